#pragma once
#include <optional>

#include "scenarios/world/world.hpp"

// What jaws could take, as the world has it now.
namespace app::hands {

using scenarios::world::World;
using sim::geometry::Vec3;

/// A place on thread or needle that jaws could take.
struct Takeable {
    Vec3 at;          ///< The place [m].
    Vec3 along;       ///< How the strand or the wire goes there, unit.
    double distance;  ///< From where it was looked for [m].
};

/// The nearest place to `point` of thread that nobody holds or of a needle that `tool` does not hold, no farther than
/// `within` [m]. O(links).
std::optional<Takeable> nearest_takeable(const World& world, int tool, const Vec3& point, double within);

/// How far `point` is from the nearest wall that gives way [m], by its nodes; infinite where there is none. O(nodes).
double distance_to_wall(const World& world, const Vec3& point);

/// How far a node is along the thread, from the first node of all [m]. O(links).
double along_thread(const World& world, int node);
/// The place that far along, and how the thread goes there. O(links).
Takeable on_thread(const World& world, double along);

/// Where an instrument's closing jaws take what is there: a little behind their tips [m].
Vec3 bite_of(const instruments::Pose& pose);
constexpr double bite_depth = 1e-3;  ///< How far that is behind the tips [m].

}  // namespace app::hands
