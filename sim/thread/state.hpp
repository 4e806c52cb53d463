#pragma once
#include <cstdint>
#include <vector>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/link_tree.hpp"
#include "sim/thread/thread.hpp"

// What the stages of a tick share. Private to sim/thread.
namespace sim::thread {

enum class Against : std::uint8_t { thread, capsule, surface };

/// A link near something. Pushes are position corrections in units of 1/inverse mass, gathered over one substep.
struct Contact {
    Against against;
    int link, other;              ///< `other`: link, capsule or triangle.
    double gap;                   ///< Centre-line distance to the other's centre line or surface, substep start [m].
    double thickness;             ///< Distance at which the two touch [m].
    double friction;              ///< Coulomb coefficient.
    double target = 0;            ///< Distance to come to in this substep: `thickness`, or less when deep inside [m].
    double place = 0;             ///< Where along the other's axis it is nearest, 0..1, substep start.
    double link_place = 0;        ///< Where along the link, 0..1, and
    Vec3 wall = Vec3::Zero();     ///< which point of a surface is nearest, substep start.
    double normal_push = 0;       ///< >= 0.
    Vec3 tangent_push = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  ///< From the other towards the link; last one known.
};

struct State {
    State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes);

    int links() const { return static_cast<int>(rest.size()); }

    ThreadDef def;
    std::vector<Vec3> nodes;
    std::vector<double> rest;          ///< [m]
    int skip;                          ///< Links closer than this in order are neighbours: bending, not contact.

    // One tick.
    std::vector<double> inverse_mass;  ///< 1, or 0 for a held node.
    std::vector<Vec3> hold_from;       ///< Per hold: where its node was when the tick began.
    TickInput input;
    std::vector<Contact> contacts;     ///< Every pair within `reach` when last detected.
    double reach = 0;                  ///< [m]
    double moved = 0;                  ///< Sum of largest node moves (and tool moves) since then [m].
    double progress = 0;               ///< Share of the tick's motion applied so far.

    // One substep.
    std::vector<Vec3> before;          ///< Nodes when the substep began.
    std::vector<double> bound;         ///< How far each node may move in this substep [m].
    std::vector<Capsule> capsules, capsules_before;
    std::vector<int> active;           ///< Contacts that can touch in this substep.

    // Carried from tick to tick.
    std::vector<Vec3> drift;           ///< How each node moved in the last substep [m] ...
    double drift_way = 0;              ///< ... while held nodes or tools went this far [m].
    double trust = 1;                  ///< Share of the admissible step that the last substep managed.
    bool settled = false;              ///< Nothing moved and nothing is violated: a tick without motion does nothing.
    std::vector<double> tension;       ///< [N] per link.

    LinkTree tree;
    std::vector<int> found;            ///< Scratch.
    std::vector<Vec3> unit;            ///< Scratch of the length solve.
    std::vector<double> upper, multiplier;
    std::vector<double> pulled;        ///< Per link, multipliers of the substep's length solves; negative: shortened.
    std::vector<Vec3> last_pass, last_step;  ///< Scratch of relaxation.
    std::vector<Vec3> forward;         ///< Scratch of Follow-The-Leader.
    mutable std::vector<Box> audit_boxes;  ///< Scratch of the audit.
    mutable std::vector<int> audit_found;
};

// Tolerances, as shares of the thread's own sizes.
constexpr double stretch_tolerance = 5e-4;     ///< Of a link's rest length: half of what a thread at rest may show.
constexpr double bound_share = 0.45;           ///< Two neighbours that each use it keep a tenth of their distance.

/// Held nodes to where they are asked to be at `progress` (follow_leader.cpp).
void place_held(State& state, double progress);
/// Follow-The-Leader from every held node outwards.
void follow_leader(State& state);

/// One Newton step of all lengths at once; returns the worst |l/l0 - 1| found before it (lengths.cpp).
double solve_lengths(State& state);
double worst_stretch(const State& state);

/// Every pair within reach; resets `moved` (detect.cpp).
void detect(State& state, double reach);
/// Gaps of all contacts as the nodes stand, the bound of each node from them, and which contacts are active.
void measure_gaps(State& state);

/// Closest points of a contact's link and its other, as both stand now.
geometry::ClosestPair nearest(const State& state, const Contact& contact);

/// One pass over active contacts with friction; returns the worst overlap found before it, 1 where it is small enough
/// (resolve.cpp).
double resolve_contacts(State& state);
/// Worst overlap of any contact, 1 where tools must wait.
double worst_overlap(const State& state);
/// Keeps every bend no tighter than the thread's own radius.
void limit_bends(State& state);

/// Pass-throughs between `before` and `nodes`, found without using contacts or bounds (audit.cpp).
int audit(const State& state);

/// Tension estimate of every link from how far the held nodes lag behind their targets (tension.cpp).
void estimate_tension(State& state);

}  // namespace sim::thread
