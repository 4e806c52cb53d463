#pragma once
#include <span>
#include <vector>

#include "scenarios/world/moving_wall.hpp"
#include "scenarios/world/soft_vessel.hpp"
#include "sim/thread/thread.hpp"

namespace bench::lab {

using sim::geometry::Vec3;

/// A tube that gives way, bitten before, and a 6-0 thread through it; what hands do is left to the caller.
class ThreadInTube {
  public:
    struct Def {
        int bites = 1;  ///< 1: out of the lumen by its end; 2, 4 ...: so many walls, to and fro across the tube.
        bool is_elastic = false;
        double lead = 10e-3, tail = 110e-3;  ///< Of thread before the first hole and after the last [m].
        double friction = 0.15;
        double bending_share = 1;
    };
    explicit ThreadInTube(const Def& def);

    /// One end goes on by this [m], the other one is pulled by `load` [N] the way it lay. By Follow-The-Leader it is
    /// free. Returns how far it went: hands wait at a taut thread.
    double draw(bool by_lead, double way, double load);

    /// Where the thread is nearest to a hole, in the order that it was laid through them.
    struct AtHole {
        double along = 0;  ///< The thread, from the end of its tail [m].
        double off = 0;    ///< Of its middle line from the hole's middle [m].
    };
    std::vector<AtHole> at_holes() const;
    /// Angles that the thread turns by, between the middles of the spans on either side of each hole [rad].
    double turned() const;
    /// Before the first hole and after the last, a millimetre and a half away [N].
    double tension_of_tail() const;
    double tension_of_lead() const;
    /// Share by which its length is off what it was at first. An elastic one is stretched: of its links at rest, and of
    /// what follows the hand by `load` [N] over its material's stiffness.
    double length_off(bool by_lead, double load) const;
    const sim::thread::Thread& thread() const { return thread_; }
    const scenarios::world::SoftVessel& vessel() const { return vessel_; }
    int passes() const { return passes_; }

  private:
    Vec3 direction_at(double along) const;
    double tension_at(double along) const;

    Def def_;
    Vec3 to_tail_, to_lead_;  // unit, away from the tube
    scenarios::world::SoftVessel vessel_;
    std::vector<sim::geometry::Triangle> targets_;
    scenarios::world::MovingWall wall_;
    sim::thread::Thread thread_;
    double at_first_;         // its length at rest [m]
    std::vector<int> holes_;  // in the thread's order
    std::vector<double> rooms_;
    std::vector<sim::thread::SurfaceGap> gaps_;
    std::vector<Vec3> loads_;
    double moved_ = 0;
    int ticks_ = 0, passes_ = 0;
};

}  // namespace bench::lab
