#pragma once
#include <algorithm>

#include "sim/thread/contact/state.hpp"

// Tools in a tick: where they are, and how far they may go before we look again.
namespace sim::thread::contact {

/// The longest way that a held node, and a tool part, is asked to go in this tick [m].
struct Motion {
    double of_holds = 0;     ///< Held nodes, from where they were when the tick began [m].
    double of_capsules = 0;  ///< Ends of capsules [m].

    double most() const { return std::max(of_holds, of_capsules); }
};

/// Of all tools together.
Motion longest_asked(const State& state);

/// Tool parts to where they are at State::progress.
void place_capsules(State& state);
/// Of any capsule's end, since State::capsules_before [m].
double largest_capsule_move(const State& state);
/// How far a tool part that was out of reach may go: as near as its reach, no nearer, before we look again [m].
double unseen_room(const State& state);
/// What share of its motion in this tick the tool of a contact may make: into the thread by no more than the thread's
/// radius.
double share_beside(const State& state, const Contact& c);

}  // namespace sim::thread::contact
