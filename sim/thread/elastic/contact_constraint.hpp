#pragma once
#include <array>
#include <vector>

#include "sim/thread/elastic/state.hpp"

namespace sim::thread::elastic {

/// A run of contacts, one after the other.
struct Run {
    std::size_t first;  ///< Index of the first contact.
    std::size_t past;   ///< Index one past the last contact.
};

/// A contact of an elastic thread during one step.
struct ContactConstraint {
    /// A contact at a row of State::rows, which must outlive it.
    explicit ContactConstraint(Row* of) : row(of), normal(of->normal) {}

    Row* row;                    ///< The row of State::rows that says where it touches.
    Vec3 normal;                 ///< The row's normal: sweeps have it at hand with what follows.
    Vec3 push = Vec3::Zero();    ///< Force on the link, drag and all [N].
    Vec3 began = Vec3::Zero();   ///< The push as the tick began [N].
    Vec3 rest = Vec3::Zero();    ///< Where it would press and drag no more: the link's point from the other's [m].
    double friction = 0;         ///< Coulomb's coefficient, corrected for what a polyline lacks.
    double compliance = 0;       ///< Compliance of the contact itself and of what it presses on [m/N].
    double own_compliance = 0;   ///< Compliance of its points to its own push along the normal, along it [m/N].
    Vec3 across = Vec3::Zero();  ///< How its points move for a unit push along the normal [m/N].
    Eigen::Matrix3d along = {};  ///< The push across the normal that undoes a slip [N/m].
    Vec3 before = Vec3::Zero();  ///< The push as a sweep began [N].
    Vec3 search = Vec3::Zero();  ///< Search direction of the sweeps [N].
    Pair pair;                   ///< Where it acts, and its push as the step began.
    std::array<Eigen::Index, 4> place{};  ///< First axis of each of those nodes among all that touch.
    std::array<int, 2> piece{-1, -1};     ///< Pieces of the thread that it touches; none: -1.
    std::size_t coupled = 0;              ///< Number of the list of contacts that move when it pushes.
};

/// All contacts of a step, or of an island.
struct ContactSet {
    std::vector<ContactConstraint> contacts;  ///< The contacts, nearest first.
    std::vector<double>
        apart;  ///< Three numbers a contact: from the other's point to the link's as the step has it [m].

    /// How far a contact's points are apart as the step has it [m].
    Vec3 apart_of(std::size_t c) const { return Eigen::Map<const Vec3>(apart.data() + 3 * c); }
};

/// How far the nodes' step that was found takes a row's points apart, tools and walls left where they are [m].
Vec3 displacement_of(const State& state, const Row& row);

}  // namespace sim::thread::elastic
