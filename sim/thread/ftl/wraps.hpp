#pragma once
#include "sim/thread/ftl/state.hpp"

// Which of the thread lies along steel in a substep, and what it knows from the last one.
namespace sim::thread::ftl {

/// Finds what lies along steel as the rows were measured, into State::on_steel, and tells its rows what
/// LastSubstep::wraps knows of the last substep.
void recall_wraps(State& state);
/// Notes in LastSubstep::wraps what lies along steel as a substep ends.
void remember_wraps(State& state);
/// Lays what pressed on steel when the last substep ended on it where it has come to: drift goes straight on, steel is
/// round.
void lie_on_steel(State& state);

}  // namespace sim::thread::ftl
