#include "tests/bench/lab/needle_drive.hpp"

#include <algorithm>
#include <cmath>

namespace bench::lab {

using tissue::Arc;
using tissue::Vec3;

Arc Swing::at(double turn) const {
    const Vec3 onto = -bend;  // from the centre to the tip at 0
    const double tail = turn - angle, sin = std::sin(tail), cos = std::cos(tail);
    return {.centre = point + radius * bend,
            .to_tail = cos * onto + sin * way,
            .onwards = cos * way - sin * onto,
            .radius = radius,
            .angle = angle,
            .wire = wire};
}

Stitching::Stitching(const tissue::BiteDef& def, const tissue::TubeDef& tube, const tissue::Solver& solver)
    : mesh(make_tube(tube)), tissue({}, mesh, solver), skin(mesh), bites(def, mesh) {
    const int nodes = static_cast<int>(mesh.nodes.size()), section = tube.around * (tube.through + 1);
    for (int i = 0; i < nodes; ++i)
        if (i >= nodes - section || (i < section && mesh.nodes[static_cast<std::size_t>(i)].y() < 0))
            holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
}

void Stitching::go(const Arc* needle) {
    bites.press(needle, skin);
    tissue.step({.holds = holds, .forces = bites.forces()}, step);
    skin.update(tissue.nodes());
    bites.settle(skin);
}

// Out from the wire's circle and out of its plane.
static Eigen::Vector2d off_circle(const Arc& needle, const Vec3& point) {
    const Vec3 out = point - needle.centre, up = needle.to_tail.cross(needle.onwards);
    const double above = out.dot(up);
    return {(out - above * up).norm() - needle.radius, above};
}

void Stitching::support() {
    for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
        const Vec3& p = mesh.nodes[static_cast<std::size_t>(i)];
        const tissue::TubeDef def;
        const bool is_inner = std::hypot(p.y(), p.z()) < def.diameter / 2 - 0.9 * def.wall;
        if (is_inner && p.y() > 0 && p.x() < 0.75 * def.length) holds.push_back({i, p});
    }
}

bool Stitching::is_in_wall(const Arc& needle) const {
    constexpr int samples = 64;
    for (int k = 0; k <= samples; ++k)
        if (tissue::is_in_wall(mesh.tetrahedra, tissue.nodes(), needle.at(needle.length() * k / samples))) return true;
    return false;
}

Driven drive_through(const tissue::BiteDef& def, const tissue::TubeDef& tube, double speed, bool supported) {
    Stitching scene(def, tube);
    if (supported) scene.support();
    const Swing swing{{1.53e-3, 2.02e-3, 0.07e-3}, Vec3(-0.5, -1, 0).normalized(), Vec3(-1, 0.5, 0).normalized()};
    Driven driven;
    const auto settled = static_cast<int>(0.05 / scene.step), before = static_cast<int>(0.1e-3 / (speed * scene.step));
    std::array<Eigen::Vector2d, 2> first{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
    int open_for = 0;
    for (int n = -before; !driven.drawn; ++n) {
        const double gone = n * speed * scene.step;
        if (gone > swing.radius * swing.angle + 2e-3 || (supported && driven.entry > 0)) break;
        const Arc needle = swing.at(gone / swing.radius);
        scene.go(&needle);
        for (const tissue::BiteEvent& event : scene.bites.events()) {
            if (event.kind == tissue::BiteEvent::pierced) driven.entry = event.force;
            if (event.kind == tissue::BiteEvent::through) driven.exit = event.force;
            driven.drawn |= event.kind == tissue::BiteEvent::drawn;
        }
        if (scene.bites.bites().empty() || scene.bites.bites().front().state != tissue::BiteState::open || driven.drawn)
            continue;
        const tissue::Bite& bite = scene.bites.bites().front();
        for (std::size_t k = 0; k < 2; ++k) {
            const tissue::BiteEnd& end = k == 0 ? bite.entry : bite.exit;
            const auto off = off_circle(needle, scene.tissue.position(end.at));
            const tissue::Tetrahedron& tet = scene.mesh.tetrahedra[static_cast<std::size_t>(end.at.tetrahedron)];
            Vec3 lies = Vec3::Zero();
            for (std::size_t c = 0; c < 4; ++c)
                lies += end.at.weights[c] * scene.mesh.nodes[static_cast<std::size_t>(tet[c])];
            if (open_for == settled) first[k] = off;
            if (open_for > settled) driven.aside = std::max(driven.aside, (off - first[k]).norm());
            driven.off = std::max(driven.off, off_circle(needle, lies).norm());
        }
        ++open_for;
    }
    return driven;
}

}  // namespace bench::lab
