#pragma once
#include "scenarios/world/world.hpp"
#include "tests/bench/lab/trace.hpp"

namespace bench::lab {

/// Looks on at what walls that give way, and the needle, come to in a drill. By where things are, not by what the world
/// has kept of them.
class WallWatch {
  public:
    explicit WallWatch(const scenarios::world::World& world);

    /// After a tick. What takes longer than the tick every tenth time.
    void look(const scenarios::world::World& world, Frame& frame);
    /// After the last.
    void conclude(const scenarios::world::World& world, Trace& trace) const;

  private:
    std::vector<std::vector<double>> volumes_;  // of the tetrahedra of each vessel at rest [m^3]
    tissue::WallContact contact_;
    std::vector<std::vector<tissue::PointForce>> forces_;  // scratch
    int looks_ = 0;
};

}  // namespace bench::lab
