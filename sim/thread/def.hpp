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
    double radius = 0.0425e-3;      ///< Radius of the round cross-section [m]; 6-0 is 0.085 mm thick.
    double friction = 0.15;         ///< Coulomb coefficient, thread on thread and on surfaces.
    double friction_tool = 0.15;    ///< Coulomb coefficient, thread on moving capsules.
    double axial_stiffness = 15.9;  ///< Young's modulus times cross-section [N]; scales the tension estimate only.
    /// Length to which links are halved where the thread bends or touches itself, to within the root of two [m]; they
    /// are joined again where it is straight. 0: links stay as they are.
    double shortest_link = 0;
    /// Elastic only: once the steps of a tick have solved so many contacts together, tools wait with what is left of
    /// their motion, for a shorter longest tick; 0: there is no such limit.
    int contacts_per_tick = 0;
    std::optional<RodDef> elastic = {};  ///< The rod that the thread moves as; none: it moves by Follow-The-Leader.
};

/// What enters one tick. Nodes appear in `holds` at most once.
struct TickInput {
    std::span<const Hold> holds;                      ///< Nodes that tools hold, and where they are to go.
    std::span<const int> hold_owners;                 ///< One per hold: the owner of capsules that hold it, or -1.
    std::span<const MovingCapsule> capsules;          ///< Tool parts, from where they are to where they are to go.
    const geometry::TriangleTree* surface = nullptr;  ///< Triangles, or none.
    double seconds = 1e-3;                            ///< How long the tick takes [s], above 0; elastic only.
    std::span<const Vec3> loads = {};                 ///< Forces on nodes [N], one each or none; elastic only.
    /// How far the surface has gone since the last tick at most [m]. None of it goes through the thread: it comes
    /// nearer by 0.45 of surface_room() at most.
    double surface_moved = 0;
    std::span<const int> sheathed = {};  ///< Links that touch no surface: the needles that lead them are in the wall.
    /// The surface's triangles from this index on are soft: their owner moves them between ticks by what pressed on
    /// them.
    int soft_from = std::numeric_limits<int>::max();
    /// Compliance with which a push is taken to move soft triangles at once [m/N]; elastic only. Where both sides,
    /// solved in turn, reckon with the other's compliance their pushes converge however stiff either is (Robin
    /// conditions: Badia, Nobile and Vergara 2008).
    double soft_compliance = 0;
};

/// What a tick did and what it gave up.
struct TickReport {
    double fraction = 1;            ///< Least share of the motion asked for that any tool made; below 1 some wait.
    int substeps = 0;               ///< Steps that the tick was made in.
    int contacts = 0;               ///< Most contacts that could touch in one of the steps.
    double stretch_max = 0;         ///< |l / l0 - 1| of the worst link after the tick.
    double separation_min = 1e300;  ///< Smallest centre-line distance of non-neighbour links / diameter after the tick.
    double step_over_bound = 0;     ///< Largest move of a node in a substep over its bound; at most 1.
    int pass_throughs = 0;          ///< Found by the audit, in any substep, through thread, capsules or surface.
    int sweeps = 0;                 ///< Sweeps over contacts until their pushes stood still; elastic only.
    bool not_finite = false;        ///< Whether input was not finite, and the tick was not taken.
};

/// What the thread does to one of the surface's triangles.
struct SurfaceForce {
    int triangle;  ///< Index into TickInput::surface.
    Vec3 at;       ///< Where on the triangle the force acts [m].
    Vec3 force;    ///< Force on the triangle [N].
    int link;      ///< The link that presses.
    /// How far the thread takes the triangle to have gone at once, TickInput::soft_compliance times what the force has
    /// changed by in this tick [m].
    Vec3 deeper = Vec3::Zero();
    /// The triangle as it was when the piece that presses fell asleep; none where that is awake.
    std::optional<geometry::Triangle> asleep = {};
};

/// How near a link is to one of the surface's triangles.
struct SurfaceGap {
    int triangle;  ///< Index into TickInput::surface.
    Vec3 normal;   ///< From the triangle's nearest point to the thread's middle line, unit.
    double gap;    ///< Distance of the two [m].
};

/// A piece of thread between cuts.
struct Piece {
    int first, last;  ///< Its first and last node, two nodes at least.
};

}  // namespace sim::thread
