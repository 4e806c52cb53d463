#include <algorithm>
#include <cmath>

#include "tissue/join_parts.hpp"

namespace tissue {

namespace {

// How far to search: the extent of both vessels, so that something is found [m].
double extent(const SewnEnd& a, const SewnEnd& b) {
    sim::geometry::Box box;
    for (const SewnEnd* end : {&a, &b})
        for (const Vec3& node : end->nodes()) box.include(node);
    return (box.high - box.low).norm();
}

struct Across {
    Vec3 outer, inner;  // now
};

Across across(const SewnEnd& end, double place) {
    const Mesh& rest = end.vessel.rest;
    const double opposite = nearest(end.inner, rest, position(end.outer, place, rest.nodes)).place;
    return {position(end.outer, place, end.nodes()), position(end.inner, opposite, end.nodes())};
}

double overlap(const SewnEnd& other, const Skin::Spot& spot) {
    const Side side = other.vessel.skin.side(spot.triangle);
    if (side != Side::outer && side != Side::inner) return 0;
    const Mesh& rest = other.vessel.rest;
    const Vec3 at = position(other.vessel.skin.point(spot.triangle, spot.weights), rest, rest.nodes);
    return nearest(side == Side::outer ? other.outer : other.inner, rest, at).distance;
}

}  // namespace

// Four an edge of the rim, so that no piece is much longer than the wall is thick.
std::vector<LinePiece> suture_line(const SewnEnd& end, const SewnEnd& other, double wall) {
    const int pieces = 4 * static_cast<int>(end.outer.nodes.size());
    const double reach = extent(end, other), length = end.outer.length / pieces;
    std::vector<LinePiece> line;
    for (int i = 0; i < pieces; ++i) {
        LinePiece piece{.place = (i + 0.5) * length, .length = length};
        const Across from = across(end, i * length), middle = across(end, piece.place),
                     to = across(end, (i + 1) * length);
        piece.width = 0.5 * ((to.outer - from.outer).norm() + (to.inner - from.inner).norm());
        const Skin::Spot spot = other.vessel.skin.closest(middle.outer, middle.inner, reach);
        const bool is_within =
            is_in_wall(other.vessel.rest.tetrahedra, other.nodes(), 0.5 * (middle.outer + middle.inner));
        piece.gap = is_within ? 0 : spot.distance;
        if (spot.triangle >= 0 && piece.gap < wall) piece.overlap = overlap(other, spot);
        line.push_back(piece);
    }
    return line;
}

}  // namespace tissue
