#include "sim/knot/homfly.hpp"

#include <algorithm>
#include <map>

namespace sim::knot {

namespace {

// a + c v^dv z^dz b
Polynomial add(const Polynomial& a, const Polynomial& b, int dv, int dz, long long c) {
    Polynomial sum;
    sum.reserve(a.size() + b.size());
    size_t i = 0;
    const auto push = [&](const Term& t) {
        if (t.coefficient != 0) sum.push_back(t);
    };
    for (const Term& t : b) {
        const int v = t.v + dv, z = t.z + dz;
        for (; i < a.size() && (a[i].v < v || (a[i].v == v && a[i].z < z)); ++i) push(a[i]);
        long long coefficient = c * t.coefficient;
        if (i < a.size() && a[i].v == v && a[i].z == z) coefficient += a[i++].coefficient;
        push({v, z, coefficient});
    }
    for (; i < a.size(); ++i) push(a[i]);
    return sum;
}

Polynomial circles(size_t count) {
    Polynomial p = {{0, 0, 1}};
    for (size_t i = 1; i < count; ++i) p = add(add({}, p, -1, -1, 1), p, 1, -1, -1);
    return p;
}

// First passage in travel order that is below where its crossing is met first; the number of such passages.
struct Bad {
    int count = 0;
    size_t component = 0, index = 0;
};

Bad bad_passages(const Diagram& diagram) {
    std::vector<bool> met(diagram.sign.size());
    Bad bad;
    for (size_t c = 0; c < diagram.words.size(); ++c)
        for (size_t i = 0; i < diagram.words[c].size(); ++i) {
            const Passage& p = diagram.words[c][i];
            if (!met[p.crossing] && !p.over && bad.count++ == 0) bad.component = c, bad.index = i;
            met[p.crossing] = true;
        }
    return bad;
}

// Starts each component where the fewest passages are bad. What it keeps is never worse than what it found, so that
// switching a bad crossing always brings the diagram nearer to a descending one.
void choose_starts(Diagram& diagram) {
    int best = bad_passages(diagram).count;
    for (Word& word : diagram.words) {
        size_t best_turn = 0;
        for (size_t turn = 1; turn < word.size(); ++turn) {
            std::rotate(word.begin(), word.begin() + 1, word.end());
            if (const int count = bad_passages(diagram).count; count < best) best = count, best_turn = turn;
        }
        if (!word.empty()) std::rotate(word.begin(), word.begin() + 1, word.end());
        std::rotate(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(best_turn), word.end());
    }
}

// Joins the strands at a crossing the other way round, along their directions.
Diagram smoothed(const Diagram& diagram, int crossing) {
    Diagram result{{}, diagram.sign};
    std::vector<Word> pieces;  // The words cut at the crossing.
    for (const Word& word : diagram.words) {
        std::vector<size_t> cuts;
        for (size_t i = 0; i < word.size(); ++i)
            if (word[i].crossing == crossing) cuts.push_back(i);
        if (cuts.empty()) result.words.push_back(word);
        for (size_t k = 0; k < cuts.size(); ++k) {
            Word piece;
            const size_t to = cuts[(k + 1) % cuts.size()];
            for (size_t i = (cuts[k] + 1) % word.size(); i != to; i = (i + 1) % word.size()) piece.push_back(word[i]);
            pieces.push_back(piece);
        }
        if (cuts.size() == 1)
            pieces.back() = [&] {
                Word piece(word.begin() + cuts[0] + 1, word.end());
                piece.insert(piece.end(), word.begin(), word.begin() + cuts[0]);
                return piece;
            }();
        if (cuts.size() == 2) {  // One component becomes two.
            result.words.insert(result.words.end(), pieces.begin(), pieces.end());
            pieces.clear();
        }
    }
    if (pieces.size() == 2) {  // Two components become one.
        pieces[0].insert(pieces[0].end(), pieces[1].begin(), pieces[1].end());
        result.words.push_back(pieces[0]);
    }
    return result;
}

void switch_crossing(Diagram& diagram, int crossing) {
    for (Word& word : diagram.words)
        for (Passage& p : word)
            if (p.crossing == crossing) p.over = !p.over;
    diagram.sign[crossing] = -diagram.sign[crossing];
}

// Numbers the crossings in travel order, so that equal diagrams look equal; the key is the diagram itself.
std::vector<short> relabel(Diagram& diagram) {
    std::vector<int> label(diagram.sign.size(), -1), sign;
    std::vector<short> key;
    for (Word& word : diagram.words) {
        for (Passage& p : word) {
            int& l = label[p.crossing];
            if (l < 0) {
                l = static_cast<int>(sign.size());
                sign.push_back(diagram.sign[p.crossing]);
            }
            p.crossing = l;
            key.push_back(static_cast<short>(4 * l + 2 * (sign[l] > 0) + p.over + 1));
        }
        key.push_back(0);
    }
    diagram.sign = sign;
    return key;
}

class Skein {
  public:
    explicit Skein(int budget) : budget_(budget) {}

    Polynomial evaluate(Diagram diagram) {
        if (budget_ <= 0) return {};
        --budget_;
        simplify(diagram);
        choose_starts(diagram);
        const std::vector<short> key = relabel(diagram);
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        const Bad bad = bad_passages(diagram);
        if (bad.count == 0) return known_[key] = circles(diagram.words.size());
        const int crossing = diagram.words[bad.component][bad.index].crossing;
        const bool positive = diagram.sign[crossing] > 0;
        const Polynomial smooth = evaluate(smoothed(diagram, crossing));
        switch_crossing(diagram, crossing);
        const Polynomial switched = evaluate(std::move(diagram));
        const Polynomial result = positive ? add(add({}, switched, 2, 0, 1), smooth, 1, 1, 1)
                                           : add(add({}, switched, -2, 0, 1), smooth, -1, 1, -1);
        return known_[key] = result;
    }

    bool finished() const { return budget_ > 0; }

  private:
    int budget_;
    std::map<std::vector<short>, Polynomial> known_;
};

}  // namespace

std::optional<Polynomial> homfly(const Diagram& diagram, int budget) {
    Skein skein(budget);
    Polynomial result = skein.evaluate(diagram);
    if (!skein.finished()) return std::nullopt;
    return result;
}

Polynomial mirror(const Polynomial& polynomial) {
    Polynomial result;
    for (const Term& t : polynomial) result.push_back({-t.v, t.z, t.z % 2 ? -t.coefficient : t.coefficient});
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace sim::knot
