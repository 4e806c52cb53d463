#pragma once
#include <algorithm>

#include "sim/thread/contact/state.hpp"

// Tools in a tick: where they are, and how far they may go before we look again.
namespace sim::thread::contact {

/// How far tools are asked to go in a tick.
struct Motion {
    double of_holds = 0;     ///< The longest path of a held node from where it was when the tick began [m].
    double of_capsules = 0;  ///< The longest path of an end of a capsule [m].

    /// The longer of the two [m].
    double most() const { return std::max(of_holds, of_capsules); }
};

/// The longest paths that all tools together are asked to go in this tick.
Motion longest_asked(const State& state);

/// Puts tool parts where they are at State::progress.
void place_capsules(State& state);
/// The largest move of any capsule's end since State::capsules_before [m].
double largest_capsule_move(const State& state);
/// How far a tool part that was out of reach may go before the next detection [m]: as near as the reach, no nearer.
double unseen_room(const State& state);
/// The share, 0..1, of its motion in this tick that the tool of a contact may make: it goes into the thread by no more
/// than the thread's radius.
double share_beside(const State& state, const Contact& c);

}  // namespace sim::thread::contact
