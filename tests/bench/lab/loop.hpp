#pragma once
#include <array>

#include "tests/bench/lab/hands.hpp"

namespace bench::lab {

/// How deep the loop is below the knot, where its throws are 2 wide (knots.hpp).
constexpr double loop_depth = 25;

/// A thread with a knot above a loop, and the four nodes where it is held: its ends, and the sides of the loop nine
/// tenths of the way up to the knot.
struct Loop {
    /// `nodes`: from looped(..., loop_depth).
    Loop(const ThreadDef& def, const std::vector<Vec3>& nodes);

    Vec3 at(int node) const { return thread.nodes()[static_cast<std::size_t>(node)]; }
    double apart() const { return (at(right()) - at(left())).norm() / (2 * thread.def().radius); }  ///< The sides [D].
    int left() const { return held[1]; }
    int right() const { return held[2]; }

    TickReport pull_tails(double step);  ///< The sides stay, either tail goes out by `step` [m].
    TickReport pull_sides(double step);  ///< The tails are free, either side goes out by `step` [m].

    Thread thread;
    std::array<int, 4> held{};  ///< Along the thread.
};

}  // namespace bench::lab
