#pragma once
#include "sim/thread/stages.hpp"

namespace sim::thread {

/// How far apart a unit push at each contact moves the points of every other [m/N]: three rows and columns for each of
/// State::presses.
using Responses = Eigen::Map<Table::Matrix>;

/// Whether a row is too far off to push in the next step, which leaves it just touching at most.
bool is_far(const State& state, const Row& row);

/// By how much a wall that gives way goes for what a push on it has changed by since it was moved [m/N]; 0 where it
/// does not.
double give_of_wall(const State& state, const Row& row);

/// How far the step that was found takes a row's points apart, were it for the nodes alone.
Vec3 way_of(const State& state, const Row& row);

/// All of State::presses, until they push as Coulomb wants it; returns how often all were looked at.
int solve_together(State& state);

/// With the rod's inverse at the nodes that they touch; O(m n + m^2) for m contacts that touch n nodes. Pieces of
/// thread answer each by itself: where contacts share none nothing is written.
Responses measure_responses(State& state);

/// The contacts that move when d pushes, increasing, d among them unless nothing moves: those that share a piece of
/// thread with it.
std::span<const Run> answers_to(const State& state, std::size_t d);

/// Pushes contact c by `more` [N] than it does, and moves the points of all.
void push_more(State& state, const Responses& responses, std::size_t c, const Vec3& more);

/// Where sweeps left a contact a hundredth of a thickness nearer than it would be: what all push across, to rounding,
/// with what they drag as it is but within its cone. Block principal pivoting [Judice and Pires 1994] from the contacts
/// that push now; a Cholesky factorisation of those for each change.
void part_presses(State& state, const Responses& responses);

}  // namespace sim::thread
