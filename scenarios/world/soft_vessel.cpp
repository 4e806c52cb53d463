#include "scenarios/world/soft_vessel.hpp"

#include <algorithm>
#include <set>

#include "tissue/tube.hpp"
#include "tissue/wall.hpp"

namespace scenarios::world {

using tissue::Side;

// Direction from a vessel's cut to its far end; its cut is its first end where neither end is held or both are.
static Vec3 inwards(const VesselDef& def) {
    return def.start_held && !def.end_held ? Vec3(-def.axis) : def.axis;
}

// Axes of a vessel as columns: along it, across it level, across both. Two vessels that face each other so have cuts
// that are parallel.
static Eigen::Matrix3d frame_of(const Vec3& along) {
    const Vec3 up = std::abs(along.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
    Eigen::Matrix3d frame;
    frame.col(0) = along;
    frame.col(1) = up.cross(along).normalized();
    frame.col(2) = frame.col(0).cross(frame.col(1));
    return frame;
}

tissue::Mesh wall_of(const VesselDef& def) {
    if (!def.triangles.empty()) return tissue::make_wall(def.outside, def.triangles, {.thickness = def.wall}).mesh;
    const bool is_cut = !def.start_held || !def.end_held;
    tissue::TubeDef tube{
        .diameter = def.diameter, .wall = def.wall, .length = def.length, .cut_angle = is_cut ? def.cut_angle : 90.0};
    tube.near_length = is_cut ? std::min(def.diameter, 0.5 * def.length) : 0.5 * def.length;
    tissue::Mesh wall = make_tube(tube);
    const Vec3 along = inwards(def), cut = def.centre - 0.5 * def.length * along;
    const Eigen::Matrix3d frame = frame_of(along);
    for (Vec3& node : wall.nodes) node = cut + frame * node;
    return wall;
}

// A clamp on a vessel from a mesh holds as much of the end as the wall is thick.
static std::vector<tissue::Hold> clamps_of_mesh(const VesselDef& def, const tissue::Mesh& wall) {
    const auto [low, high] =
        std::minmax_element(wall.nodes.begin(), wall.nodes.end(),
                            [&](const Vec3& a, const Vec3& b) { return def.axis.dot(a) < def.axis.dot(b); });
    std::vector<tissue::Hold> clamps;
    for (std::size_t i = 0; i < wall.nodes.size(); ++i) {
        const Vec3& node = wall.nodes[i];
        if ((def.start_held && def.axis.dot(node - *low) <= def.wall) ||
            (def.end_held && def.axis.dot(*high - node) <= def.wall))
            clamps.push_back({static_cast<int>(i), node});
    }
    return clamps;
}

static std::vector<tissue::Hold> clamps_of(const VesselDef& def, const tissue::Mesh& wall) {
    if (!def.triangles.empty()) return clamps_of_mesh(def, wall);
    std::set<int> held;
    for (const tissue::Face& face : wall.faces)
        if ((face.side == Side::far_end && (def.start_held || def.end_held)) ||
            (face.side == Side::cut && def.start_held && def.end_held))
            held.insert(face.nodes.begin(), face.nodes.end());
    std::vector<tissue::Hold> clamps;
    for (const int node : held) clamps.push_back({node, wall.nodes[static_cast<std::size_t>(node)]});
    return clamps;
}

static tissue::Material material_of(const VesselDef& def) {
    tissue::Material material;
    material.young = def.young_modulus;
    return material;
}

// A hole is wider than the wire: the needle goes through aslant, at 25 degrees to a wall and more, and so does the
// thread after it, whose first node follows the needle exactly and touches no rim. With holes as wide as the wire it
// jammed there.
static tissue::BiteDef bites_of(const VesselDef& def, double wire) {
    return {.puncture = def.puncture_force, .grip = 2, .hole = 1.5 * wire, .axis = def.axis, .wall = def.wall};
}

SoftVessel::SoftVessel(const VesselDef& def, double wire)
    : tissue(material_of(def), wall_of(def)),
      skin(tissue.rest()),
      bites(bites_of(def, wire), tissue.rest()),
      clamps(clamps_of(def, tissue.rest())),
      held_by(def.held_by),
      name(def.name) {
    for (const auto& [from, to] : def.bitten) bites.begin_with(from, to, skin);
    skin.forget_parts();
    pulls.assign(static_cast<std::size_t>(skin.holes()), Vec3::Zero());
    presses.reserve(1024), pressed.reserve(128), forces.reserve(4096), pulls.reserve(128), mean_pulls.reserve(128),
        strengths.reserve(64);
}

// Stiffness of a wall under all that presses on it at a hole, at so many places [N/m]: that of some 5 mm of 6-0
// polypropylene along itself, and twice that where thread cannot stretch. Thread and wall are stepped in turn, each
// reckoning with the other's compliance (`wall_compliance`). With too small a stiffness, a fifth of this, or where
// every strand that lies squeezed between two ends takes the wall for stiffer, each throws the other to and fro, and a
// bite pulled to what it bears goes to pieces; with a larger one the wall comes the slower (100 ms for a wall of 100
// N/m). So all places that are pressed at a hole share it.
static double stiffness_with(bool elastic, int places) {
    return elastic ? std::max(5e3, places / wall_compliance) : 1e4;
}

void SoftVessel::press(const sim::thread::SurfaceForce& force, const sim::geometry::Triangle& shown, double trusted) {
    if (force.force.isZero(0)) return;
    const int triangle = force.triangle - first;
    const Vec3 weights = tissue::weights_in(shown, force.at);
    const double size = force.force.norm();
    const Vec3 direction = force.force / size;
    const double gone = direction.dot(tissue::point_in(skin[triangle], weights) - force.at);
    // A wall that comes back meets a thread that follows it, and presses as hard; a thread that sleeps holds it where
    // it was.
    presses.push_back({skin.point(triangle, weights), skin.hole_about(triangle, weights), trusted * size, direction,
                       (force.asleep ? gone : std::max(0.0, gone)) - direction.dot(force.deeper)});
}

void SoftVessel::load(double share, bool elastic) {
    pressed.assign(static_cast<std::size_t>(skin.holes() + 1), {});
    const auto all = [&](const Press& press) -> auto& {
        return pressed[static_cast<std::size_t>(press.hole + 1)];
    };
    for (const Press& press : presses) all(press).size += press.size, ++all(press).places;
    for (const Press& press : presses) {
        if (press.hole >= 0) pulls[static_cast<std::size_t>(press.hole)] += share * press.size * press.direction;
        const double stiffness = stiffness_with(elastic, all(press).places) * press.size / all(press).size;
        const double left = std::max(0.0, press.size - stiffness * press.gone);
        forces.push_back({press.at, share * left * press.direction, share * stiffness});
    }
    presses.clear();
}

void SoftVessel::step(double seconds) {
    tissue.step({.holds = clamps, .forces = forces}, seconds);
    forces.clear();
    skin.update(tissue.nodes());
    bites.settle(skin);
}

static EventKind kind_of(tissue::BiteEvent::Kind kind) {
    switch (kind) {
        case tissue::BiteEvent::pierced:
            return EventKind::pierced;
        case tissue::BiteEvent::through:
            return EventKind::through;
        case tissue::BiteEvent::back_in:
            return EventKind::back_in;
        case tissue::BiteEvent::withdrawn:
            return EventKind::withdrawn;
        case tissue::BiteEvent::drawn:
            return EventKind::drawn;
        case tissue::BiteEvent::torn:
            return EventKind::torn;
        case tissue::BiteEvent::slipped:
            return EventKind::slipped;
    }
    return EventKind::slipped;
}

void SoftVessel::note_bites(double now_s, std::vector<Event>& events) {
    for (const tissue::BiteEvent& event : bites.events()) {
        events.push_back({now_s, kind_of(event.kind), name, event.force});
        const bool is_bite = event.kind == tissue::BiteEvent::pierced || event.kind == tissue::BiteEvent::through ||
                             event.kind == tissue::BiteEvent::withdrawn;
        if (!is_bite) continue;
        bitten_s.resize(bites.bites().size());
        bitten_s[static_cast<std::size_t>(event.bite)] = now_s;
    }
}

std::vector<sim::geometry::Triangle> with_skins(std::vector<sim::geometry::Triangle> triangles,
                                                std::span<SoftVessel> vessels) {
    for (SoftVessel& vessel : vessels) {
        vessel.first = static_cast<int>(triangles.size());
        for (int t = 0; t < vessel.skin.size(); ++t) triangles.push_back(vessel.skin[t]);
    }
    return triangles;
}

std::vector<std::array<int, 3>> holes_in(std::size_t rigid, std::span<const SoftVessel> vessels) {
    std::vector<std::array<int, 3>> holes(rigid, {-1, -1, -1});
    int before = 0;
    for (const SoftVessel& vessel : vessels) {
        for (int t = 0; t < vessel.skin.size(); ++t) {
            const auto hole = [&](std::size_t corner) {
                return vessel.skin.hole_at(t, corner) < 0 ? -1 : before + vessel.skin.hole_at(t, corner);
            };
            holes.push_back({hole(0), hole(1), hole(2)});
        }
        before += vessel.skin.holes();
    }
    return holes;
}

}  // namespace scenarios::world
