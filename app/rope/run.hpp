#pragma once
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "app/rope/motion.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"

namespace app::rope {

/// One bare thread and what is done to it.
struct Experiment {
    sim::thread::ThreadDef thread;
    std::vector<Vec3> nodes;       ///< [m]
    std::vector<HeldNode> motion;  ///< Of these nodes.
    double tick = 0.001;           ///< [s]
    const sim::geometry::TriangleTree* obstacle = nullptr;
    std::ostream* positions = nullptr;  ///< One JSON line every `every` ticks, or none.
    int every = 1;
};

/// What was measured on the way.
struct Measured {
    std::int64_t ticks = 0, substeps = 0;
    std::vector<float> tick_us;     ///< Wall-clock time of each tick, ascending.
    double stretch_max = 0;         ///< |l / l0 - 1| of the worst link after any tick.
    double stretch_settled = 0;     ///< The same after the last tick.
    double stretch_total = 0;       ///< Of the whole length after the last tick.
    double separation_min = 1e300;  ///< As TickReport, of all ticks.
    double step_over_bound = 0;
    int pass_throughs = 0, contacts_max = 0;
    double lag_max = 0, lag_final = 0;  ///< Of held nodes behind the motion [m].
    double tension_max = 0;             ///< [N]
    std::uint64_t hash = 0;
    std::vector<Vec3> nodes;  ///< In the end [m].
};

/// How many ticks a motion takes: up to and including the time of its last row.
double ticks_of(const Experiment& experiment);

Measured run(const Experiment& experiment);

}  // namespace app::rope
