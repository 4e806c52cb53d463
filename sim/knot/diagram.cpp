#include "sim/knot/diagram.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "sim/knot/reroute.hpp"

namespace sim::knot {

Places places(const Diagram& diagram) {
    Places p{std::vector<Place>(diagram.sign.size()), std::vector<Place>(diagram.sign.size())};
    for (std::size_t s = 0; s < diagram.strands.size(); ++s)
        for (std::size_t i = 0; i < diagram.strands[s].size(); ++i) {
            const Passage passage = diagram.strands[s][i];
            (passage.over ? p.over : p.under)[static_cast<std::size_t>(passage.crossing)] = {static_cast<int>(s),
                                                                                             static_cast<int>(i)};
        }
    return p;
}

Diagram without(const Diagram& diagram, const std::vector<char>& gone) {
    assert(gone.size() == diagram.sign.size() && "a mark for each crossing");
    Diagram result;
    std::vector<int> number(diagram.sign.size(), -1);
    for (std::size_t c = 0; c < gone.size(); ++c)
        if (!gone[c]) {
            number[c] = result.crossings();
            result.sign.push_back(diagram.sign[c]);
        }
    for (const auto& strand : diagram.strands) {
        auto& kept = result.strands.emplace_back();
        for (const Passage p : strand)
            if (!gone[static_cast<std::size_t>(p.crossing)])
                kept.push_back({number[static_cast<std::size_t>(p.crossing)], p.over});
    }
    return result;
}

namespace {

bool mark_curls(const Diagram& diagram, std::vector<char>& gone) {
    bool found = false;
    for (const auto& strand : diagram.strands)
        for (std::size_t i = 0; i < strand.size(); ++i) {
            const Passage a = strand[i], b = strand[(i + 1) % strand.size()];
            if (a.crossing != b.crossing || a.over == b.over) continue;
            gone[static_cast<std::size_t>(a.crossing)] = 1;
            found = true;
        }
    return found;
}

// Two strands that are neighbours at two crossings of opposite sign, one above the other at both, bound an empty bigon.
bool mark_bigons(const Diagram& diagram, std::vector<char>& gone) {
    const Places at = places(diagram);
    bool found = false;
    for (const auto& strand : diagram.strands)
        for (std::size_t i = 0; i < strand.size() && strand.size() > 1; ++i) {
            const Passage a = strand[i], b = strand[(i + 1) % strand.size()];
            const auto ca = static_cast<std::size_t>(a.crossing), cb = static_cast<std::size_t>(b.crossing);
            if (!a.over || !b.over || gone[ca] || gone[cb] || diagram.sign[ca] == diagram.sign[cb]) continue;
            const Place ua = at.under[ca], ub = at.under[cb];
            if (ua.strand != ub.strand) continue;
            const int length = static_cast<int>(diagram.strands[static_cast<std::size_t>(ua.strand)].size());
            const int apart = std::abs(ua.index - ub.index);
            if (apart != 1 && apart != length - 1) continue;
            gone[ca] = gone[cb] = 1;
            found = true;
        }
    return found;
}

}  // namespace

void remove_curls_and_bigons(Diagram& diagram) {
    for (;;) {
        std::vector<char> gone(diagram.sign.size(), 0);
        if (!mark_curls(diagram, gone) && !mark_bigons(diagram, gone)) return;
        diagram = without(diagram, gone);
    }
}

void simplify(Diagram& diagram, int most) {
    remove_curls_and_bigons(diagram);
    if (diagram.crossings() > most) return;
    while (diagram.crossings() > 0 && shorten_one_stretch(diagram)) remove_curls_and_bigons(diagram);
}

bool reduced_alternating(const Diagram& diagram) {
    for (const auto& strand : diagram.strands)
        for (std::size_t i = 0; i < strand.size(); ++i)
            if (strand[i].over == strand[(i + 1) % strand.size()].over) return false;
    // A crossing that cuts the diagram in two: on a knot, the stretch between its passages is closed in itself.
    for (const auto& strand : diagram.strands)
        for (std::size_t i = 0; i < strand.size(); ++i) {
            std::vector<int> met(diagram.sign.size(), 0);
            int open = 0;
            for (std::size_t k = 1; k < strand.size(); ++k) {
                const Passage p = strand[(i + k) % strand.size()];
                if (p.crossing == strand[i].crossing) {
                    if (open == 0) return false;
                    break;
                }
                open += met[static_cast<std::size_t>(p.crossing)]++ ? -1 : 1;
            }
        }
    return true;
}

std::vector<Piece> split_pieces(const Diagram& diagram) {
    const Places at = places(diagram);
    std::vector<int> leader(diagram.strands.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](int s) {
        while (leader[static_cast<std::size_t>(s)] != s) s = leader[static_cast<std::size_t>(s)];
        return s;
    };
    for (std::size_t c = 0; c < diagram.sign.size(); ++c) {
        const int a = find(at.over[c].strand), b = find(at.under[c].strand);
        leader[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::vector<Piece> pieces;
    for (int s = 0; s < static_cast<int>(diagram.strands.size()); ++s) {
        if (find(s) != s) continue;
        std::vector<char> gone(diagram.sign.size(), 0);
        for (std::size_t c = 0; c < gone.size(); ++c) gone[c] = find(at.over[c].strand) != s;
        const Diagram kept = without(diagram, gone);
        Piece piece{{{}, kept.sign}, {}};
        for (int t = s; t < static_cast<int>(diagram.strands.size()); ++t)
            if (find(t) == s) {
                piece.diagram.strands.push_back(kept.strands[static_cast<std::size_t>(t)]);
                piece.strands.push_back(t);
            }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

namespace {

struct Stretch {
    int strand = -1, first = 0, length = 0;
};

// The shortest stretch that is closed in itself and is not its whole diagram.
Stretch shortest_closed_stretch(const Diagram& diagram) {
    Stretch best;
    for (std::size_t s = 0; s < diagram.strands.size(); ++s) {
        const auto& strand = diagram.strands[s];
        const int n = static_cast<int>(strand.size()), all = 2 * diagram.crossings();
        for (int i = 0; i < n; ++i) {
            std::vector<char> met(diagram.sign.size(), 0);
            int open = 0;
            for (int k = 0; k < n && k + 1 < all && (best.strand < 0 || k + 1 < best.length); ++k) {
                char& seen = met[static_cast<std::size_t>(strand[static_cast<std::size_t>((i + k) % n)].crossing)];
                open += seen ? -1 : 1;
                seen = 1;
                if (open == 0) {
                    best = {static_cast<int>(s), i, k + 1};
                    break;
                }
            }
        }
    }
    return best;
}

}  // namespace

std::vector<Summand> cut_summands(Diagram& diagram) {
    std::vector<Summand> summands;
    for (;;) {
        const Stretch cut = shortest_closed_stretch(diagram);
        if (cut.strand < 0) break;
        const auto& strand = diagram.strands[static_cast<std::size_t>(cut.strand)];
        std::vector<char> inside(diagram.sign.size(), 0), outside(diagram.sign.size(), 1);
        for (int k = 0; k < cut.length; ++k) {
            const auto i = static_cast<std::size_t>(cut.first + k) % strand.size();
            const auto c = static_cast<std::size_t>(strand[i].crossing);
            inside[c] = 1, outside[c] = 0;
        }
        Diagram part = without(diagram, outside);
        summands.push_back({{{part.strands[static_cast<std::size_t>(cut.strand)]}, part.sign}, cut.strand});
        diagram = without(diagram, inside);
    }
    if (diagram.strands.size() == 1 && diagram.crossings() > 0) {
        summands.push_back({diagram, 0});
        diagram = {{{}}, {}};
    }
    return summands;
}

int linking_number(const Diagram& diagram, int i, int j) {
    const Places at = places(diagram);
    int total = 0;
    for (std::size_t c = 0; c < diagram.sign.size(); ++c) {
        const int a = at.over[c].strand, b = at.under[c].strand;
        if ((a == i && b == j) || (a == j && b == i)) total += diagram.sign[c];
    }
    return total / 2;
}

Diagram reversed(Diagram diagram, int i) {
    assert(i >= 0 && static_cast<std::size_t>(i) < diagram.strands.size() && "a strand of the diagram");
    const Places at = places(diagram);
    for (std::size_t c = 0; c < diagram.sign.size(); ++c)
        if ((at.over[c].strand == i) != (at.under[c].strand == i)) diagram.sign[c] = -diagram.sign[c];
    auto& strand = diagram.strands[static_cast<std::size_t>(i)];
    std::reverse(strand.begin(), strand.end());
    return diagram;
}

Diagram only(const Diagram& diagram, int i) {
    assert(i >= 0 && static_cast<std::size_t>(i) < diagram.strands.size() && "a strand of the diagram");
    const Places at = places(diagram);
    std::vector<char> gone(diagram.sign.size(), 0);
    for (std::size_t c = 0; c < gone.size(); ++c) gone[c] = at.over[c].strand != i || at.under[c].strand != i;
    Diagram kept = without(diagram, gone);
    return {{kept.strands[static_cast<std::size_t>(i)]}, kept.sign};
}

}  // namespace sim::knot
