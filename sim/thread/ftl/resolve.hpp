#pragma once
#include "sim/thread/contact/rows.hpp"
#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

/// Does what contact::aim() does; where thread lies finely on steel, it puts rows at the thread's nodes.
double aim(State& state);
/// Makes one pass over all rows with friction; returns the worst overlap found before it, 1 where it is small enough.
double resolve_contacts(State& state);
/// The overlap of a row as a share of what passes work for, at most 1 where they may stop: strands into each other's
/// margin by `strand_goal`, thread into steel or a wall by a tenth of its thickness, which is out of sight, and
/// wherever it was by less than `steel_limit`. `distance`: that of the row's points along its normal [m].
double over_goal(const State& state, const Row& row, double distance);
/// Moves the nodes of a row by a push on its points.
void push_apart(State& state, const Row& row, const Vec3& push);
/// Projected Gauss-Seidel on one row whose points are `apart` [m] and move by `mobility` for a unit push along the
/// normal: the push never pulls. Pushes are totals of the substep, so they do not depend on how many passes are made or
/// how long a tick is; returned is what they gained.
double add_normal_push(Row& row, const Vec3& apart, double mobility);
/// Adds as much of the push that is `wanted` against the slip as Coulomb's cone allows; returns what the push gained.
Vec3 add_tangent_push(Row& row, const Vec3& slip, const Vec3& wanted);
/// Whether the second row is of the same tool part and the next link.
bool is_next_link(const Row& row, const Row& next);

}  // namespace sim::thread::ftl
