#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/geometry/shapes.hpp"
#include "sim/thread/def.hpp"

// The thread as both movers share it, and what it is near.
namespace sim::thread::contact {

/// What a link is near.
enum class Against : std::uint8_t {
    thread,   ///< Another link of the same thread.
    capsule,  ///< A tool part, one of TickInput::capsules.
    surface,  ///< A triangle of TickInput::surface.
};

/// A link near something: what bounds its nodes, and whether it may touch in this substep.
struct Contact {
    Against against;     ///< What `other` counts.
    int link;            ///< Counted along the thread from 0.
    int other;           ///< Link, capsule of the input or triangle of the surface, by `against`.
    double thickness;    ///< Distance of centre line to centre line or surface at which the two touch [m].
    double measured;     ///< That distance when last measured [m].
    double measured_at;  ///< State::moved when it was measured [m].
    double place;        ///< Where along the other's axis it was nearest when measured, 0..1.
    double gap = 0;      ///< What the distance is at least, as the substep begins [m].
};

/// The contacts, as State keeps them, that are not with walls, of which there are many more.
template <class Contacts>
auto but_walls(Contacts& contacts) {
    return std::span(contacts.begin(), std::partition_point(contacts.begin(), contacts.end(), [](const Contact& c) {
                         return c.against != Against::surface;
                     }));
}

/// A contact that may touch in this substep, linearised: the point at `s` of the link must stay `target` away along
/// `normal` from the point at `t` of the other. Pushes are totals of the substep: by Follow-The-Leader multipliers in
/// metres over inverse mass, of an elastic thread forces in newtons.
struct Row {
    Against against;         ///< As in Contact.
    int link;                ///< As in Contact.
    int other;               ///< As in Contact.
    double thickness;        ///< As in Contact [m].
    double friction;         ///< Coulomb coefficient.
    double target;           ///< Distance to come to in this substep: `thickness`, or less when deep inside [m].
    double s;                ///< Where on the link it touches, 0..1.
    double t;                ///< Where on the other's axis it touches, 0..1.
    Vec3 normal;             ///< From the other towards the link, unit; the last one known where they coincide.
    Vec3 start;              ///< From the other's point to the link's when the substep began [m].
    Vec3 fixed;              ///< The other's point now, when the other is not the thread [m].
    double distance;         ///< Between the two points when last aimed [m].
    double mobility = 0;     ///< Distance gained by a unit push [1].
    double normal_push = 0;  ///< Along the normal, >= 0.
    Vec3 tangent_push = Vec3::Zero();  ///< Friction, across the normal.
    double friction_ratio = 0;  ///< Follow-The-Leader: share of Coulomb's friction that a wrap on steel drags with,
                                ///< -1..1, positive towards the thread's first node.
    double friction_ratio_before = 0;  ///< Follow-The-Leader: the share that was tried before `friction_ratio`.
    double slip_before = 0;            ///< Follow-The-Leader: how far the wrap slid with `friction_ratio_before` [m].
    bool in_wrap = false;  ///< Follow-The-Leader: part of a wrap on steel, whose pushes are found with the lengths.
    bool pressed = false;  ///< Follow-The-Leader: pressed when the last substep ended, until this one is solved.
    double slip = 0;       ///< How far friction that holds has let it slide, when last resolved [m].
    bool is_there_still = false;  ///< Elastic: a contact of the last step that was found again in this one.
    Vec3 began = Vec3::Zero();    ///< Elastic: push() as the tick began [N].

    /// The whole push on the link, along the normal and across it, in the units of its parts.
    Vec3 push() const { return normal_push * normal + tangent_push; }
};

/// What both movers carry from tick to tick, and what a tick hands from stage to stage. A mover's own state extends
/// it; scratch belongs to the class that uses it.
struct State {
    /// A thread at rest with nodes at `start_nodes` [m], at least 2; the links in `cuts` are cuts.
    State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes, std::span<const int> cuts = {});
    /// Resizes what has one entry a node or link, and no tick hands on, to the number of links. Allocates nothing once
    /// reserved.
    void size_for_links();
    /// The most links there may come to be, by ThreadDef::shortest_link and the lengths of the links now.
    std::size_t most_links() const;

    /// The number of links, cuts among them.
    int links() const { return static_cast<int>(rest_length.size()); }
    /// A cut is a link that is no more; it has no length, and what it parts meets only as other strands do.
    bool is_cut(std::size_t link) const { return rest_length[link] == 0; }
    /// Whether a node is the first of its piece.
    bool is_first(std::size_t node) const { return node == 0 || is_cut(node - 1); }
    /// Whether a node is the last of its piece.
    bool is_last(std::size_t node) const { return node == rest_length.size() || is_cut(node); }
    /// Whether a node is either end of its piece.
    bool is_end(std::size_t node) const { return is_first(node) || is_last(node); }
    /// Whether both nodes of a link sleep.
    bool sleeps(int link) const {
        return !asleep.empty() && asleep[static_cast<std::size_t>(link)] && asleep[static_cast<std::size_t>(link) + 1];
    }

    ThreadDef def;                    ///< What the thread is, as it was made.
    std::vector<Vec3> nodes;          ///< n + 1 positions [m], world frame.
    std::vector<double> rest_length;  ///< n lengths when nothing pulls [m]; 0 of a cut.
    std::vector<double> arc;          ///< n + 1: thread before each node [m], a cut as long as nothing is looked for.
    double longest_link;              ///< Length of the longest link when the thread was made [m].
    std::vector<double> tension;      ///< n pulls [N].
    std::vector<SurfaceForce> surface_forces;  ///< What the thread did to the surface as the last tick ended.

    TickInput input;                   ///< What entered the tick that runs; its spans end with it.
    std::vector<double> inverse_mass;  ///< n + 1: 1, or 0 for a node that is held or sleeps.
    std::vector<Vec3> hold_from;       ///< Per hold: where its node was when the tick began [m].
    std::vector<double> progress;      ///< Per tool, nobody's first: share of its motion made in this tick, 0..1.

    std::vector<Vec3> before;              ///< n + 1: nodes when the substep began [m].
    std::vector<double> bound;             ///< n + 1: how far each node may move in this substep [m].
    std::vector<Capsule> capsules;         ///< Tool parts where they are now.
    std::vector<Capsule> capsules_before;  ///< Tool parts when the substep began.
    std::vector<Row> rows;                 ///< Contacts that can touch in this substep.

    std::vector<Contact> contacts;  ///< Every pair within `reach` when last detected: strands, then tools, then walls.
    double reach = 0;               ///< How far links looked for others when last detected [m].
    double moved = 0;               ///< Sum of the largest moves of nodes and tools since the last detection [m].
    bool is_rest_due = false;       ///< Whether the last detection looked at tools alone.
    std::vector<int> seen;     ///< Holds, owners, capsules and size of the surface that the contacts were detected for.
    std::vector<char> asleep;  ///< n + 1 of an elastic thread, 1 where a node's piece sleeps; else empty.
};

/// The largest |length / rest length - 1| of all links at `nodes`.
double worst_stretch(const State& state, const std::vector<Vec3>& nodes);

/// By how much the thread turns at a node [rad], as the chord of the angle; 0 at the ends of a piece.
double turn_at(const State& state, std::size_t node);

/// Whether a row is nearer than a radius to touching.
inline bool is_touched(const State& state, const Row& row) {
    return row.distance < row.thickness + state.def.radius;
}

/// Whether a contact of an elastic thread is with a wall that its owner moves as the thread presses on it
/// (TickInput::soft_from); links lean on such a wall with their ends.
template <class RowOrContact>
bool is_on_soft_wall(const State& state, const RowOrContact& c) {
    return state.def.elastic && c.against == Against::surface && c.other >= state.input.soft_from;
}

}  // namespace sim::thread::contact
