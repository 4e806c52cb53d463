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
struct SleepingContact {
    Row row;                  ///< Where it pressed, with pushes in newtons.
    geometry::Triangle wall;  ///< Where the wall's triangle was; of no meaning where the row is with something else.
};

/// All that an elastic thread carries from tick to tick.
struct State : contact::State {
    /// Makes it as contact::State's constructor does; `def` is elastic.
    State(const ThreadDef& def, std::vector<Vec3> start_nodes, std::span<const int> cuts = {});

    Rod rod;                                ///< Its nodes and lengths are the thread's.
    std::vector<Row> pressed;               ///< Rows that pressed when the last step ended; pushes in newtons.
    std::vector<SleepingContact> sleeping;  ///< What pressed on the pieces that sleep.
    std::vector<Vec3> watched;  ///< n + 1: where each node was at the last look whether its piece is still [m].
    int watched_ticks = 0;      ///< Ticks since the last look whether pieces are still.
};

/// Calls change(row) for every row that pressed when last solved, of pieces that sleep and of those that do not.
template <class AnyState, class Change>
void for_all_pressed(AnyState& state, Change change) {
    for (auto& row : state.pressed) change(row);
    for (auto& contact : state.sleeping) change(contact.row);
}

}  // namespace sim::thread::elastic
