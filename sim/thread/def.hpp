#pragma once
#include <limits>
#include <optional>
#include <span>

#include "sim/geometry/moving.hpp"
#include "sim/rod/rod_def.hpp"

// What a thread is, what enters one of its ticks and what comes out: the values that pass through the door.
namespace sim::geometry {
class TriangleTree;
}

namespace sim::thread {

using geometry::Capsule;
using geometry::Hold;
using geometry::MovingCapsule;
using geometry::Vec3;
using rod::RodDef;

/// What a thread is. SI; n links between n + 1 nodes.
struct ThreadDef {
    double radius = 0.0425e-3;      ///< [m] of the round cross-section; 6-0 is 0.085 mm thick.
    double friction = 0.15;         ///< Coulomb coefficient, thread on thread and on surfaces.
    double friction_tool = 0.15;    ///< Coulomb coefficient, thread on moving capsules.
    double axial_stiffness = 15.9;  ///< Young's modulus times cross-section [N]; scales the tension estimate only.
    double shortest_link =
        0;  ///< [m]: where the thread bends or touches itself links are halved until they are as short,
            ///< to within the root of two, and joined again where it is straight; 0: they stay as they are.
    int contacts_per_tick =
        0;  ///< Elastic only: where the steps of a tick have pressed on so many together, tools wait with what is
            ///< left of their motion, for a shorter longest tick; 0: for nothing but the steps themselves.
    std::optional<RodDef> elastic = {};  ///< Moves as this, of `radius`; else by Follow-The-Leader.
};

/// What enters one tick. Nodes appear in `holds` at most once.
struct TickInput {
    std::span<const Hold> holds;
    std::span<const int> hold_owners;  ///< One per hold: the owner of capsules that hold it, or -1.
    std::span<const MovingCapsule> capsules;
    const geometry::TriangleTree* surface = nullptr;  ///< Triangles, or none.
    double seconds = 1e-3;                            ///< How long it takes; elastic only, as are
    std::span<const Vec3> loads = {};                 ///< forces on nodes [N], one each or none.
    double surface_moved = 0;  ///< How far the surface has gone since the last tick at most [m]; none of it through
                               ///< the thread: nearer by 0.45 of surface_room() at most.
    std::span<const int> sheathed = {};  ///< Links that touch no surface: the needles that lead them are in the wall.
    int soft_from = std::numeric_limits<int>::max();  ///< The surface's triangles from this one on come after what
                                                      ///< presses on them, which its owner moves
    double soft_give = 0;  ///< between ticks: by so much [m/N] is a push taken to move them at once; elastic only.
                           ///< Where both sides, solved in turn, reckon with how the other gives way their pushes come
                           ///< to rest however stiff either is (Robin conditions: Badia, Nobile and Vergara 2008).
};

/// What a tick did and what it gave up.
struct TickReport {
    double fraction = 1;  ///< Least share of the motion asked for that any tool made; below 1 some wait.
    int substeps = 0, contacts = 0;
    double stretch_max = 0;         ///< |l / l0 - 1| of the worst link after the tick.
    double separation_min = 1e300;  ///< Smallest centre-line distance of non-neighbour links / diameter after the tick.
    double step_over_bound = 0;     ///< Largest move of a node in a substep over its bound; at most 1.
    int pass_throughs = 0;          ///< Found by the audit, in any substep, through thread, capsules or surface.
    int sweeps = 0;                 ///< Over contacts until their pushes stood still; elastic only.
    bool not_finite = false;        ///< Input was not finite; the tick was not taken.
};

/// What the thread does to one of the surface's triangles.
struct SurfaceForce {
    int triangle;
    Vec3 at;                     ///< On it [m].
    Vec3 force;                  ///< [N]
    int link;                    ///< That presses.
    Vec3 deeper = Vec3::Zero();  ///< How far the thread has gone beyond that, for TickInput::soft_give [m].
    std::optional<geometry::Triangle> asleep =
        {};  ///< Of a piece that stays where it is: the triangle as it was when that fell asleep.
};

/// How near a link is to one of the surface's triangles.
struct SurfaceGap {
    int triangle;
    Vec3 normal;  ///< From the triangle's nearest point to the thread's middle line, unit.
    double gap;   ///< Between the two [m].
};

/// What cuts leave whole: nodes `first` to `last`, at least two.
struct Piece {
    int first, last;
};

}  // namespace sim::thread
