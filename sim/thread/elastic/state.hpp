#pragma once
#include <vector>

#include "sim/rod/rod.hpp"
#include "sim/thread/contact/state.hpp"

// What an elastic thread carries, besides what both movers share.
namespace sim::thread::elastic {

using contact::Against;
using contact::Contact;
using contact::Row;
using rod::Pair;
using rod::Rod;
using rod::Rolling;

/// What pressed on a piece of thread as it fell asleep.
struct SleepingPress {
    Row row;                  ///< Pushes in newtons.
    geometry::Triangle wall;  ///< Where that was, if it is one.
};

struct State : contact::State {
    /// As contact::State.
    State(const ThreadDef& def, std::vector<Vec3> start_nodes, std::span<const int> cuts = {});

    Rod rod;                              ///< Its nodes and lengths are the thread's.
    std::vector<Row> pressed;             ///< What pressed when its last step ended; pushes in newtons.
    std::vector<SleepingPress> sleeping;  ///< What pressed on the pieces that sleep.
    std::vector<Vec3>
        watched;            ///< n + 1: where each node was when it was last looked at whether its piece is still [m].
    int watched_ticks = 0;  ///< Ticks since then.
};

/// All that pressed when last solved, of pieces that sleep and that do not.
template <class AnyState, class Change>
void for_all_pressed(AnyState& state, Change change) {
    for (auto& row : state.pressed) change(row);
    for (auto& press : state.sleeping) change(press.row);
}

}  // namespace sim::thread::elastic
