#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/thread/thread.hpp"
#include "tests/bench/lab/knots.hpp"

namespace bench::lab {

/// What a seed draws: a loose knot that two hands pull apart until it is tight, and on.
struct Tie {
    Knot knot;
    int links;               ///< 60 to 600, more only where the knot needs them.
    double radius_per_link;  ///< 0.2 to 1.
    double friction;         ///< 0, 0.15 or 0.3.
    double speed;            ///< Of either hand [m/s], 0.01 to 2.
    double wobble;           ///< Of the hands across their way, as a share of it.
    double wobble_hz;
    int let_go;         ///< Hand that lets go and grasps again on the way, or -1.
    double regrasp_at;  ///< Share of the slack that is left then, 0: when tight.
    int pause;          ///< Ticks it is off the thread.
    double regrasp_in;  ///< How far in it grasps, as a share of the straight end.
};

Tie tie_of(std::uint64_t seed);

struct Tied {
    std::string before, after;  ///< Names; empty where the namer is not certain.
    int pass_throughs = 0;
    int ticks = 0;
    double stretch = 0;      ///< Worst |l/l0 - 1| after any tick.
    double left = 0;         ///< What the knot takes up in the end [D].
    std::uint64_t hash = 0;  ///< Thread::hash() in the end.

    bool changed() const { return before != after; }
    bool good() const { return pass_throughs == 0 && !changed(); }
};

/// The same seed gives the same bits. `each` sees the thread after every tick, and where it is held or would be. An
/// elastic thread may slip a loop over an end that a hand holds, and change its name.
using EachTick = std::function<void(const sim::thread::Thread&, int first, int last)>;
Tied ties(std::uint64_t seed, const EachTick& each = {}, bool elastic = false);

/// One line on a seed that went wrong.
std::string words(std::uint64_t seed, const Tie& tie, const Tied& tied);

}  // namespace bench::lab
