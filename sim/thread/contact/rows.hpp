#pragma once
#include "sim/thread/contact/state.hpp"

// Rows as the nodes stand: where each touches, how far apart its points are and how far it slid.
namespace sim::thread::contact {

/// The point [m] at share `s` of a link, 0..1.
Vec3 point_on(const std::vector<Vec3>& nodes, int link, double s);
/// How far a unit push moves the point at `place` of a link: inverse masses of its nodes, by their shares squared [1].
double mobility_of(const State& state, int link, double place);

/// Brings all rows to the nearest points as everything stands now, a wall being the plane that it was when measured;
/// returns the worst overlap, 1 where tools must wait.
double aim(State& state);
/// The vector from the other's point to the link's, as the nodes are [m].
Vec3 apart_of(const State& state, const Row& row);
/// How far the points have slid on each other in this substep [m], given how they lie apart now [m].
Vec3 slip_of(const Row& row, const Vec3& apart);
/// The overlap of a row as a share of its limit, 1 where tools must wait: strands wait when they touch, for there
/// topology is at stake, thread on steel when it is a fifth of its thickness inside.
double over_limit(const State& state, const Row& row);

}  // namespace sim::thread::contact
