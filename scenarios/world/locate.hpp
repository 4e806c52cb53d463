#pragma once
#include <span>
#include <string>
#include <vector>

#include "scenarios/world/measure.hpp"
#include "sim/geometry/vec.hpp"

namespace scenarios::world {

class World;

/// Where the knot is that the world named last, and how it lies: its tails, its loop, the vessels it goes round and how
/// far it is off them. Names many stretches of the thread, some 2 ms each: for the end of a session.
KnotPlace locate_knot(const World& world);

/// Lengths of a piece of thread before and after its knot, of this name (sim/knot) [mm]. `curve`: n + 1 nodes of the
/// piece [m]; `rest`: n lengths of its links [m].
std::vector<double> tails_of(const std::vector<sim::geometry::Vec3>& curve, std::span<const double> rest,
                             const std::string& knot);

}  // namespace scenarios::world
