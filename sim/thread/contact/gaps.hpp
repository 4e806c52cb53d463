#pragma once
#include "sim/thread/contact/state.hpp"

// How far what is near may come: gaps, the bound of each node from them, and the rows of what may touch.
namespace sim::thread::contact {

/// Measures the gaps of all contacts as the nodes stand, the bound of each node from them, and the rows, where held
/// nodes and tools are asked to go `path` [m]. O(contacts).
void measure_gaps(State& state, double path);
/// Measures only how far links are from tools; rows are not to be used before measure_gaps().
void measure_tool_gaps(State& state);

/// The distance beyond touching from which on a contact has no row [m].
double closing(const State& state);
/// The distance beyond touching from which on a contact does not press in the next step of an elastic thread, unless it
/// pressed in the last [m].
double about_to_press(const State& state);
/// The cosine of the angle within which the normals of rows on a wall belong to the same contact.
double same_direction_on_wall(const State& state);

}  // namespace sim::thread::contact
