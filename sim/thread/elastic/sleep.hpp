#pragma once
#include <vector>

#include "sim/thread/elastic/state.hpp"

namespace sim::thread::elastic {

/// As holds do: nothing moves the nodes of pieces that sleep.
void hold_what_sleeps(State& state);
/// Wakes the piece that a node is of.
void wake(State& state, int node);
/// As a tick begins: pieces whose holds or walls have moved wake. `stirred`: scratch.
void wake_what_is_moved(State& state, std::vector<int>& stirred);
/// As it ends: those that something has come to wake, those that have long been still fall asleep.
void watch_over_pieces(State& state);

}  // namespace sim::thread::elastic
