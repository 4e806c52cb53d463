#include "sim/knot/reroute.hpp"

#include <array>
#include <optional>

namespace sim::knot {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The plane graph of a diagram, where asked with one edge (`missing`) left out. Edge (strand s, index i) leads from passage i to i + 1.
// Dart 2e walks edge e forwards with its left face on the left hand, dart 2e + 1 backwards with its right face there.
class Faces {
  public:
    explicit Faces(const Diagram& diagram) : diagram_(diagram) {
        number_edges();
        number_rays();
        number_faces();
    }
    Faces(const Diagram& diagram, int strand, int index) : diagram_(diagram) {
        number_edges();
        missing_ = offset_[at(strand)] + index;
        number_rays();
        number_faces();
    }

    int edges() const { return edges_; }
    int missing() const { return missing_; }
    int offset(int strand) const { return offset_[at(strand)]; }
    int face_of_dart(int dart) const { return face_[at(dart)]; }
    int count() const { return count_; }
    // The face in which the missing edge starts (or ends).
    int face_at_start() const { return face_beside(start_[at(missing_)]); }
    int face_at_end() const { return face_beside(end_[at(missing_)]); }

  private:
    struct Ray {
        int crossing = 0, turn = 0;  // turn: 0..3 counter-clockwise
    };
    struct Spoke {
        int edge = 0;
        bool outgoing = false;
    };

    void number_edges() {
        for (const auto& word : diagram_.strands) {
            offset_.push_back(edges_);
            edges_ += static_cast<int>(word.size());
        }
    }

    void number_rays() {
        spokes_.resize(diagram_.sign.size());
        start_.resize(at(edges_)), end_.resize(at(edges_));
        for (std::size_t s = 0; s < diagram_.strands.size(); ++s) {
            const int n = static_cast<int>(diagram_.strands[s].size());
            for (int i = 0; i < n; ++i) {
                const Passage p = diagram_.strands[s][at(i)];
                const int in = offset_[s] + (i + n - 1) % n, out = offset_[s] + i;
                const bool positive = diagram_.sign[at(p.crossing)] > 0;
                // Under runs south to north; over runs west to east at a positive crossing. 0 east, 1 north, ...
                const int turn_out = p.over ? (positive ? 0 : 2) : 1, turn_in = (turn_out + 2) % 4;
                spokes_[at(p.crossing)][at(turn_out)] = {out, true};
                spokes_[at(p.crossing)][at(turn_in)] = {in, false};
                start_[at(out)] = {p.crossing, turn_out};
                end_[at(in)] = {p.crossing, turn_in};
            }
        }
    }

    // Arriving at a crossing by `ray`, the sharpest left turn: the next spoke clockwise that is there.
    int dart_after(Ray ray) const {
        for (int step = 1; step <= 4; ++step) {
            const Spoke spoke = spokes_[at(ray.crossing)][at((ray.turn + 4 - step % 4) % 4)];
            if (spoke.edge != missing_) return 2 * spoke.edge + (spoke.outgoing ? 0 : 1);
        }
        return -1;
    }

    void number_faces() {
        face_.assign(at(2 * edges_), -1);
        for (int first = 0; first < 2 * edges_; ++first) {
            if (first / 2 == missing_ || face_[at(first)] >= 0) continue;
            for (int dart = first; face_[at(dart)] < 0;) {
                face_[at(dart)] = count_;
                dart = dart_after(dart % 2 == 0 ? end_[at(dart / 2)] : start_[at(dart / 2)]);
            }
            ++count_;
        }
    }

    // The face on the spot of a missing ray: left of whoever arrives by the next spoke counter-clockwise.
    int face_beside(Ray ray) const {
        for (int step = 1; step < 4; ++step) {
            const Spoke spoke = spokes_[at(ray.crossing)][at((ray.turn + step) % 4)];
            if (spoke.edge != missing_) return face_[at(2 * spoke.edge + (spoke.outgoing ? 1 : 0))];
        }
        return -1;
    }

    const Diagram& diagram_;
    std::vector<int> offset_, face_;
    std::vector<Ray> start_, end_;
    std::vector<std::array<Spoke, 4>> spokes_;
    int edges_ = 0, missing_ = -1, count_ = 0;
};

// Edges to cross on the shortest way from the start of the missing edge to its end, in order, as the darts whose face
// is left behind. Where the graph has come apart no edge is in the way: the parts can be laid side by side.
std::vector<int> shortest_way(const Faces& faces) {
    const int from = faces.face_at_start(), to = faces.face_at_end();
    std::vector<std::vector<int>> darts_of(at(faces.count()));
    for (int dart = 0; dart < 2 * faces.edges(); ++dart)
        if (dart / 2 != faces.missing()) darts_of[at(faces.face_of_dart(dart))].push_back(dart);
    std::vector<int> through(at(faces.count()), -2), queue{from};
    through[at(from)] = -1;
    for (std::size_t q = 0; q < queue.size() && through[at(to)] == -2; ++q)
        for (const int dart : darts_of[at(queue[q])]) {
            const int next = faces.face_of_dart(dart ^ 1);
            if (through[at(next)] != -2) continue;
            through[at(next)] = dart;
            queue.push_back(next);
        }
    std::vector<int> way;
    if (through[at(to)] == -2) return way;
    for (int face = to; through[at(face)] != -1; face = faces.face_of_dart(through[at(face)]))
        way.insert(way.begin(), through[at(face)]);
    return way;
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

Diagram lay(const Lifted& lifted, const Faces& faces, const std::vector<int>& way, bool over) {
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

// How few edges a stretch could cross, laid anew, found on the diagram that it still lies on: its own edges cost nothing.
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
            found = seen_[at(faces_.face_of_dart(2 * edge(stretch.length)))] || seen_[at(faces_.face_of_dart(2 * edge(stretch.length) + 1))];
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
    const std::vector<int> way = shortest_way(faces);
    if (static_cast<int>(way.size()) >= stretch.length) return false;
    diagram = lay(lifted, faces, way, stretch.over);
    return true;
}

}  // namespace

bool shorten_one_stretch(Diagram& diagram) {
    Shortcuts shortcuts(diagram);
    for (std::size_t s = 0; s < diagram.strands.size(); ++s) {
        const auto& word = diagram.strands[s];
        const int n = static_cast<int>(word.size());
        for (int first = 0; first < n; ++first) {
            const bool over = word[at(first)].over;
            int length = 1;
            while (length < n && word[at(first + length) % word.size()].over == over) ++length;
            const bool maximal = word[at(first + n - 1) % word.size()].over != over || length == n;
            const Stretch stretch{static_cast<int>(s), first, length, over};
            if (maximal && shortcuts.exists(stretch) && shorten(diagram, stretch)) return true;
            if (length == n) break;
        }
    }
    return false;
}

Diagram joined_ends(const Diagram& open, int first, int count, bool over) {
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
