#include "sim/knot/diagram.hpp"

#include <algorithm>
#include <array>

namespace sim::knot {

int Diagram::crossings() const {
    size_t passages = 0;
    for (const Word& word : words) passages += word.size();
    return static_cast<int>(passages / 2);
}

namespace {

void erase(Diagram& diagram, int a, int b) {
    for (Word& word : diagram.words)
        std::erase_if(word, [&](const Passage& p) { return p.crossing == a || p.crossing == b; });
}

bool undo_curl(Diagram& diagram) {
    for (const Word& word : diagram.words)
        for (size_t i = 0; i < word.size(); ++i)
            if (const int c = word[i].crossing; word.size() > 1 && c == word[(i + 1) % word.size()].crossing) {
                erase(diagram, c, c);
                return true;
            }
    return false;
}

// Two crossings of opposite sign, next to each other on the strand above and on the strand below: the two arcs between
// them bound a disc no other strand can enter without a third crossing, so the strands come apart.
bool undo_overlap(Diagram& diagram) {
    struct Place {
        int component = 0, index = 0;
    };
    std::vector<Place> below(diagram.sign.size());
    for (size_t c = 0; c < diagram.words.size(); ++c)
        for (size_t i = 0; i < diagram.words[c].size(); ++i)
            if (const Passage& p = diagram.words[c][i]; !p.over)
                below[p.crossing] = {static_cast<int>(c), static_cast<int>(i)};
    for (const Word& word : diagram.words)
        for (size_t i = 0; i < word.size(); ++i) {
            const Passage p = word[i], q = word[(i + 1) % word.size()];
            if (!p.over || !q.over || p.crossing == q.crossing) continue;
            if (diagram.sign[p.crossing] == diagram.sign[q.crossing]) continue;
            const Place a = below[p.crossing], b = below[q.crossing];
            if (a.component != b.component) continue;
            const int n = static_cast<int>(diagram.words[a.component].size()), gap = (a.index - b.index + n) % n;
            if (gap != 1 && gap != n - 1) continue;
            erase(diagram, p.crossing, q.crossing);
            return true;
        }
    return false;
}

// Length of the shortest stretch from `start` that contains both passages of each of its crossings.
size_t closed_stretch(const Word& word, size_t start, std::vector<int>& seen) {
    std::fill(seen.begin(), seen.end(), 0);
    int open = 0;
    for (size_t length = 1; length <= word.size(); ++length) {
        open += ++seen[word[(start + length - 1) % word.size()].crossing] == 1 ? 1 : -1;
        if (open == 0) return length;
    }
    return word.size();
}

}  // namespace

void simplify(Diagram& diagram) {
    while (undo_curl(diagram) || undo_overlap(diagram)) {
    }
}

std::vector<Diagram> split(Diagram diagram) {
    std::vector<Diagram> factors;
    simplify(diagram);
    std::vector<int> seen(diagram.sign.size());
    while (diagram.crossings() > 0) {
        Word& word = diagram.words.front();
        size_t best = word.size(), from = 0;
        for (size_t start = 0; start < word.size(); ++start)
            if (const size_t length = closed_stretch(word, start, seen); length < best) best = length, from = start;
        std::rotate(word.begin(), word.begin() + from, word.end());
        Diagram factor{{Word(word.begin(), word.begin() + best)}, diagram.sign};
        word.erase(word.begin(), word.begin() + best);
        simplify(factor);
        if (factor.crossings() > 0) factors.push_back(factor);
        simplify(diagram);
    }
    return factors;
}

}  // namespace sim::knot
