#pragma once
#include <string>
#include <vector>

#include "scenarios/world/world.hpp"

// What tests of scenarios/world build their scenes of.
namespace scene {

using instruments::Kind;
using instruments::ToolInput;
using scenarios::world::World;
using sim::geometry::Quat;
using sim::geometry::Vec3;

constexpr double mm = 1e-3;

/// A scene, and where the hands lead its tools.
struct Scene {
    scenarios::world::WorldDef def;
    std::vector<ToolInput> tools;

    void add(const std::string& name, Kind kind, const ToolInput& at) {
        def.instruments.push_back({name, kind});
        tools.push_back(at);
    }
    /// The thread starts along this path and is as long, in so many links.
    void lay(const std::vector<Vec3>& path, int links) {
        def.thread.start = path;
        def.thread.length = 0;
        for (std::size_t k = 1; k < path.size(); ++k) def.thread.length += (path[k] - path[k - 1]).norm();
        def.thread.links = links;
    }
    /// A short thread far above what the test is about.
    void lay_aside() { lay({{0, 0, 30 * mm}, {6 * mm, 0, 30 * mm}}, 12); }

    World world() const { return World(def, {}, tools); }
    void play(World& world, int ticks = 1) const {
        for (int t = 0; t < ticks; ++t) world.tick(tools);
    }
};

/// Jaws whose middle plane a strand at `at` along `along` crosses 1.5 mm behind their tips; the tool points along
/// `points`. Both unit, at right angles.
inline instruments::Pose across(const Vec3& at, const Vec3& along, const Vec3& points) {
    Eigen::Matrix3d axes;
    axes.col(1) = along, axes.col(2) = points;
    axes.col(0) = axes.col(1).cross(axes.col(2));
    return {at + 1.5 * mm * points, Quat(axes).normalized()};
}

/// Jaws across a strand along x at height 0, 2 mm behind their tips; the tool comes from above.
inline instruments::Pose from_above(double x) {
    Eigen::Matrix3d down;
    down << 0, 1, 0, 1, 0, 0, 0, 0, -1;
    return {Vec3(x, 0, -2 * mm), Quat(down)};
}

/// An end of a vessel along x that gives way, held at its far end alone: its cut is at `cut_x` [m], and it goes on
/// from there for `length` [m] towards -x, or towards +x where that is negative.
inline scenarios::world::VesselDef end_at(double cut_x, double length) {
    scenarios::world::VesselDef end;
    end.wall = 0.5 * mm;
    end.length = std::abs(length);
    end.centre = {cut_x - length / 2, 0, 0};
    (length > 0 ? end.end_held : end.start_held) = false;
    end.is_soft = true;
    return end;
}

/// A vessel of 12 mm along x that gives way, both its ends held.
inline scenarios::world::VesselDef held_vessel() {
    scenarios::world::VesselDef vessel;
    vessel.diameter = 3.5 * mm, vessel.wall = 0.6 * mm, vessel.length = 12 * mm;
    vessel.is_soft = true;
    vessel.young_modulus = 0.2e6;
    return vessel;
}

/// How often this has happened.
inline std::size_t count(const World& world, scenarios::world::EventKind kind) {
    return static_cast<std::size_t>(std::count_if(world.events().begin(), world.events().end(),
                                                  [&](const auto& event) { return event.kind == kind; }));
}

}  // namespace scene
