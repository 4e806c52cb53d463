#pragma once
#include "sim/thread/stages.hpp"

// How far tools, and what they hold, go in a step of an elastic thread: up to what they meet, into what gives way as
// far as it does, along what does not.
namespace sim::thread {

/// What share of the motion that is left tools may make before we look again, should the thread answer as freely as it
/// may; `left`: of the tick's, 0 to 1. O(contacts).
double share_of_tools(State& state, double left, const Motion& motion);

/// And should it not: no farther into links than any may be.
double careful_share(const State& state, double left, double share);

/// Whether a step may be found twice: not where one solves as many contacts as a tick may.
bool may_dare(const State& state);

/// Whether the step that was found leaves a tool farther in a link than any may be. O(contacts with tools).
bool is_deep(const State& state);

/// Leaves out of State::targets what would lead what is held too far into a tool that does not hold it or, where no
/// jaws do, into a wall.
void slide(State& state);

}  // namespace sim::thread
