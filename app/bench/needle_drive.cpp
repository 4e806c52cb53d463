#include "app/bench/needle_drive.hpp"

#include <algorithm>
#include <cmath>

namespace app::bench {

using tissue::Arc;
using tissue::Vec3;

Arc Swing::at(double turn) const {
    const Vec3 onto = -bend;  // from the centre to the tip at 0
    const double tail = turn - angle, sin = std::sin(tail), cos = std::cos(tail);
    return {.centre = point + radius * bend, .to_tail = cos * onto + sin * way, .onwards = cos * way - sin * onto, .radius = radius, .angle = angle, .wire = wire};
}

Stitching::Stitching(const tissue::BiteDef& def, const tissue::TubeDef& tube, const tissue::Solver& solver) : mesh(make_tube(tube)), tissue({}, mesh, solver), skin(mesh), bites(def, mesh) {
    const int nodes = static_cast<int>(mesh.nodes.size()), section = tube.around * (tube.through + 1);
    for (int i = 0; i < nodes; ++i)
        if (i >= nodes - section || (i < section && mesh.nodes[static_cast<std::size_t>(i)].y() < 0)) holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
}

void Stitching::go(const Arc* needle) {
    bites.press(needle, skin);
    tissue.step({.holds = holds, .forces = bites.forces()}, step);
    skin.update(tissue.nodes());
    bites.settle(skin);
}

double Stitching::moved_aside(const Arc& needle) const {
    double most = 0;
    for (const tissue::Bite& bite : bites.bites())
        for (const tissue::BiteEnd* end : {&bite.entry, &bite.exit}) {
            if (!bite.on_needle || end->hole < 0) continue;
            const Vec3 now = tissue.position(end->at), out = now - needle.centre, up = needle.to_tail.cross(needle.onwards), way = up.cross(out).normalized();
            const tissue::Tetrahedron& tet = mesh.tetrahedra[static_cast<std::size_t>(end->at.tetrahedron)];
            Vec3 moved = now;
            for (std::size_t k = 0; k < 4; ++k) moved -= end->at.weights[k] * mesh.nodes[static_cast<std::size_t>(tet[k])];
            most = std::max(most, (moved - moved.dot(way) * way).norm());
        }
    return most;
}

bool Stitching::is_in_wall(const Arc& needle) const {
    constexpr int samples = 64;
    for (int k = 0; k <= samples; ++k)
        if (tissue::is_in_wall(mesh.tetrahedra, tissue.nodes(), needle.at(needle.length() * k / samples))) return true;
    return false;
}

}  // namespace app::bench
