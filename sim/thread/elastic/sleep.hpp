#pragma once
#include <vector>

#include "sim/thread/elastic/state.hpp"

namespace sim::thread::elastic {

/// Keeps the nodes of pieces that sleep from moving, as holds do.
void hold_what_sleeps(State& state);
/// Wakes the piece that a node is of.
void wake(State& state, int node);
/// As a tick begins: wakes pieces whose holds or walls have moved. `stirred`: scratch.
void wake_what_is_moved(State& state, std::vector<int>& stirred);
/// As a tick ends: wakes pieces that something has come to, and puts those to sleep that have long been still.
void watch_over_pieces(State& state);

}  // namespace sim::thread::elastic
