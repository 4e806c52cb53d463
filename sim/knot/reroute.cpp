#include "sim/knot/reroute.hpp"

#include <algorithm>
#include <cassert>

#include "sim/geometry/at.hpp"
#include "sim/knot/faces.hpp"

namespace sim::knot {

namespace {

// For each face how many edges away it is from that in which the missing edge starts, -1 where none leads there.
std::vector<int> distances(const Faces& faces, const std::vector<std::vector<int>>& darts_of) {
    std::vector<int> away(at(faces.count()), -1), queue{faces.face_at_start()};
    away[at(queue.front())] = 0;
    for (std::size_t q = 0; q < queue.size(); ++q)
        for (const int dart : darts_of[at(queue[q])]) {
            const int next = faces.face_of_dart(dart ^ 1);
            if (away[at(next)] >= 0) continue;
            away[at(next)] = away[at(queue[q])] + 1;
            queue.push_back(next);
        }
    return away;
}

// The edges to cross on a way from the start of the missing edge to its end, in order, as the darts whose face is left
// behind.
using Way = std::vector<int>;

// The shortest ways, the first `most` of them. Where the graph has come apart no edge is in the way: the parts can be
// laid side by side.
std::vector<Way> shortest_ways(const Faces& faces, std::size_t most) {
    std::vector<std::vector<int>> darts_of(at(faces.count()));
    for (int dart = 0; dart < 2 * faces.edges(); ++dart)
        if (dart / 2 != faces.missing()) darts_of[at(faces.face_of_dart(dart))].push_back(dart);
    const std::vector<int> away = distances(faces, darts_of);
    if (away[at(faces.face_at_end())] < 0) return {{}};
    struct Part {
        int face;
        Way rest;  // from there to the end
    };
    std::vector<Part> parts{{faces.face_at_end(), {}}};
    for (int left = away[at(faces.face_at_end())]; left > 0; --left) {
        std::vector<Part> longer;
        for (const Part& part : parts)
            for (const int dart : darts_of[at(part.face)]) {
                const int before = faces.face_of_dart(dart ^ 1);
                if (away[at(before)] != left - 1 || longer.size() == most) continue;
                Part& next = longer.emplace_back(Part{before, part.rest});
                next.rest.insert(next.rest.begin(), dart ^ 1);
            }
        parts = std::move(longer);
    }
    std::vector<Way> ways;
    for (Part& part : parts) ways.push_back(std::move(part.rest));
    return ways;
}

Way shortest_way(const Faces& faces) {
    return shortest_ways(faces, 1).front();
}

struct Stretch {
    int strand, first, length;
    bool over;
};

// What is left when the stretch is lifted off, and the edge on which it was.
struct Lifted {
    Diagram rest;
    int strand, index;  // edge from passage `index` of the rest; -1 when the strand has no passage left
};

Lifted lift(const Diagram& diagram, const Stretch& stretch) {
    const auto& word = diagram.strands[at(stretch.strand)];
    std::vector<char> gone(diagram.sign.size(), 0);
    for (int k = 0; k < stretch.length; ++k) gone[at(word[at(stretch.first + k) % word.size()].crossing)] = 1;
    int before = 0;  // passages of the rest that come before the stretch in the word
    for (int i = 0; i < stretch.first; ++i) before += !gone[at(word[at(i)].crossing)];
    Lifted lifted{without(diagram, gone), stretch.strand, -1};
    const int n = static_cast<int>(lifted.rest.strands[at(stretch.strand)].size());
    if (n > 0) lifted.index = (before + n - 1) % n;
    return lifted;
}

Diagram lay(const Lifted& lifted, const Faces& faces, const Way& way, bool over) {
    Diagram result;
    result.sign = lifted.rest.sign;
    std::vector<int> crossed(at(faces.edges()), -1);
    std::vector<Passage> laid;
    for (const int dart : way) {
        crossed[at(dart / 2)] = result.crossings();
        laid.push_back({result.crossings(), over});
        const bool left_to_right = dart % 2 == 0;
        result.sign.push_back(left_to_right == over ? 1 : -1);
    }
    for (std::size_t s = 0; s < lifted.rest.strands.size(); ++s) {
        auto& word = result.strands.emplace_back();
        for (std::size_t i = 0; i < lifted.rest.strands[s].size(); ++i) {
            word.push_back(lifted.rest.strands[s][i]);
            const int edge = faces.offset(static_cast<int>(s)) + static_cast<int>(i);
            if (edge == faces.missing()) word.insert(word.end(), laid.begin(), laid.end());
            if (crossed[at(edge)] >= 0) word.push_back({crossed[at(edge)], !over});
        }
    }
    return result;
}

// How few edges a stretch could cross, laid anew, found on the diagram that it still lies on: its own edges cost
// nothing.
class Shortcuts {
  public:
    explicit Shortcuts(const Diagram& diagram) : diagram_(diagram), faces_(diagram), first_(at(faces_.count() + 1), 0) {
        for (int dart = 0; dart < 2 * faces_.edges(); ++dart) ++first_[at(faces_.face_of_dart(dart) + 1)];
        for (std::size_t f = 1; f < first_.size(); ++f) first_[f] += first_[f - 1];
        darts_.resize(at(2 * faces_.edges()));
        std::vector<int> next(first_.begin(), first_.end() - 1);
        for (int dart = 0; dart < 2 * faces_.edges(); ++dart) darts_[at(next[at(faces_.face_of_dart(dart))]++)] = dart;
        own_.assign(at(faces_.edges()), 0);
        seen_.resize(at(faces_.count()));
    }

    // Whether there is a way with fewer crossings than the stretch has.
    bool exists(const Stretch& stretch) {
        const int n = static_cast<int>(diagram_.strands[at(stretch.strand)].size());
        if (stretch.length >= n) return true;
        const auto edge = [&](int i) { return faces_.offset(stretch.strand) + (stretch.first + n - 1 + i) % n; };
        for (int i = 0; i <= stretch.length; ++i) own_[at(edge(i))] = 1;
        std::fill(seen_.begin(), seen_.end(), 0);
        here_.clear(), beyond_.clear();
        reach(faces_.face_of_dart(2 * edge(0)), here_);
        reach(faces_.face_of_dart(2 * edge(0) + 1), here_);
        bool found = false;
        for (int crossed = 0; crossed < stretch.length && !found && !here_.empty(); ++crossed) {
            spread();
            found = seen_[at(faces_.face_of_dart(2 * edge(stretch.length)))] ||
                    seen_[at(faces_.face_of_dart(2 * edge(stretch.length) + 1))];
            std::swap(here_, beyond_);
            std::erase_if(here_, [&](int face) { return seen_[at(face)]; });
            for (const int face : here_) seen_[at(face)] = 1;
            beyond_.clear();
        }
        for (int i = 0; i <= stretch.length; ++i) own_[at(edge(i))] = 0;
        return found;
    }

  private:
    void reach(int face, std::vector<int>& list) {
        if (seen_[at(face)]) return;
        seen_[at(face)] = 1;
        list.push_back(face);
    }

    // All that is reached from `here` through own edges is here; what lies behind others is beyond.
    void spread() {
        for (std::size_t q = 0; q < here_.size(); ++q)
            for (int i = first_[at(here_[q])]; i < first_[at(here_[q] + 1)]; ++i) {
                const int dart = darts_[at(i)], next = faces_.face_of_dart(dart ^ 1);
                if (seen_[at(next)]) continue;
                if (own_[at(dart / 2)]) {
                    reach(next, here_);
                } else {
                    beyond_.push_back(next);
                }
            }
    }

    const Diagram& diagram_;
    Faces faces_;
    std::vector<int> first_, darts_;  // of each face, the darts around it
    std::vector<char> own_, seen_;
    std::vector<int> here_, beyond_;
};

bool shorten(Diagram& diagram, const Stretch& stretch) {
    Lifted lifted = lift(diagram, stretch);
    if (lifted.index < 0) {
        diagram = std::move(lifted.rest);
        return true;
    }
    const Faces faces(lifted.rest, lifted.strand, lifted.index);
    const Way way = shortest_way(faces);
    if (static_cast<int>(way.size()) >= stretch.length) return false;
    diagram = lay(lifted, faces, way, stretch.over);
    return true;
}

// Of each strand the stretches over the rest and under it that neither passage beside them would lengthen.
std::vector<Stretch> longest_stretches(const Diagram& diagram) {
    std::vector<Stretch> all;
    for (std::size_t s = 0; s < diagram.strands.size(); ++s) {
        const auto& word = diagram.strands[s];
        const int n = static_cast<int>(word.size());
        for (int first = 0; first < n; ++first) {
            const bool over = word[at(first)].over;
            int length = 1;
            while (length < n && word[at(first + length) % word.size()].over == over) ++length;
            if (word[at(first + n - 1) % word.size()].over != over || length == n)
                all.push_back({static_cast<int>(s), first, length, over});
            if (length == n) break;
        }
    }
    return all;
}

}  // namespace

bool shorten_one_stretch(Diagram& diagram) {
    Shortcuts shortcuts(diagram);
    for (const Stretch& stretch : longest_stretches(diagram))
        if (shortcuts.exists(stretch) && shorten(diagram, stretch)) return true;
    return false;
}

std::vector<Diagram> laid_elsewhere(const Diagram& diagram) {
    constexpr std::size_t most_ways = 6;
    std::vector<Diagram> all;
    for (const Stretch& stretch : longest_stretches(diagram)) {
        const Lifted lifted = lift(diagram, stretch);
        if (lifted.index < 0) continue;
        const Faces faces(lifted.rest, lifted.strand, lifted.index);
        for (const Way& way : shortest_ways(faces, most_ways)) all.push_back(lay(lifted, faces, way, stretch.over));
    }
    return all;
}

Diagram joined_ends(const Diagram& open, int first, int count, bool over) {
    assert(open.strands.size() == 1 && first >= 0 && count >= 0 && at(first + count) <= open.strands.front().size() &&
           "a stretch of one strand");
    const auto& word = open.strands.front();
    std::vector<int> met(open.sign.size(), 0);
    for (int k = 0; k < count; ++k) ++met[at(word[at(first + k)].crossing)];
    std::vector<char> gone(open.sign.size(), 0);
    for (std::size_t c = 0; c < gone.size(); ++c) gone[c] = met[c] < 2;
    Lifted lifted{without(open, gone), 0, -1};
    lifted.index = static_cast<int>(lifted.rest.strands.front().size()) - 1;
    if (lifted.index < 0) return lifted.rest;
    const Faces faces(lifted.rest, 0, lifted.index);
    return lay(lifted, faces, shortest_way(faces), over);
}

}  // namespace sim::knot
