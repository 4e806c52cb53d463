#pragma once
#include "sim/thread/contact/state.hpp"

// How far what is near may come: gaps, the bound of each node from them, and the rows of what may touch.
namespace sim::thread::contact {

/// Gaps of all contacts as the nodes stand, the bound of each node from them, and the rows, where held nodes and tools
/// are asked to go `way` [m]. O(contacts).
void measure_gaps(State& state, double way);
/// Only how far links are from tools; rows are not to be used before measure_gaps().
void measure_tool_gaps(State& state);

/// What is farther off than where it touches by this has no row [m].
double closing(const State& state);
/// What is farther off than where it touches by this does not press in the next step of an elastic thread, but where it
/// did in the last [m].
double about_to_press(const State& state);
/// Cosine of the angle within which rows on a wall are of the same contact.
double same_way_on_wall(const State& state);

}  // namespace sim::thread::contact
