#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/rod/rod.hpp"
#include "sim/thread/contact/link_tree.hpp"
#include "sim/thread/ftl/band.hpp"
#include "sim/thread/thread.hpp"

// What the stages of a tick share. Private to sim/thread.
namespace sim::thread {

using rod::Pair;
using rod::Rod;
using rod::Rolling;

enum class Against : std::uint8_t { thread, capsule, surface };

/// A link near something: what bounds its nodes, and whether it may touch in this substep.
struct Contact {
    Against against;
    int link, other;   ///< `other`: link, capsule or triangle.
    double thickness;  ///< Distance at which the two touch [m].
    double measured,
        measured_at;  ///< Centre-line distance to the other's centre line or surface, and `moved` then [m].
    double place;     ///< Where along the other's axis it was nearest then, 0..1.
    double gap = 0;   ///< What the distance is at least, as the substep begins [m].
};

/// Those of contacts as State keeps them that are not with walls, of which there are many more.
template <class Contacts>
auto but_walls(Contacts& contacts) {
    return std::span(contacts.begin(), std::partition_point(contacts.begin(), contacts.end(), [](const Contact& c) {
                         return c.against != Against::surface;
                     }));
}

/// A contact that may touch in this substep, linearised: the point at `s` of the link must stay `target` away along
/// `normal` from the point at `t` of the other. Pushes are totals of the substep, in metres over inverse mass.
struct Row {
    Against against;
    int link, other;
    double thickness, friction;
    double target;           ///< Distance to come to in this substep: `thickness`, or less when deep inside [m].
    double s, t;             ///< 0..1
    Vec3 normal;             ///< From the other towards the link; last one known.
    Vec3 start;              ///< From the other's point to the link's when the substep began.
    Vec3 fixed;              ///< The other's point now, when the other is not the thread.
    double distance;         ///< When last aimed [m].
    double mobility = 0;     ///< Distance gained by a unit push.
    double normal_push = 0;  ///< >= 0.
    Vec3 tangent_push = Vec3::Zero();
    double grip = 0;  ///< Share of Coulomb's friction that a wrap on steel drags with, positive towards the thread's
                      ///< first node ...
    double grip_before = 0, slip_before = 0;  ///< ... and another that was tried, and how far it slid with that [m].
    bool glides = false;                      ///< Part of a wrap on steel: its pushes are found together with lengths.
    bool pressed = false;                     ///< When the last substep ended; until it is known whether it does now.
    double slip = 0;                          ///< How far friction that holds has let it slide, when last resolved [m].
    bool is_there_still = false;              ///< Of what pressed when an elastic step ended: as the next is found.
    Vec3 began = Vec3::Zero();                ///< push() as an elastic tick began [N].

    Vec3 push() const { return normal_push * normal + tangent_push; }
};

/// A row that pushes, and what its pushes do to the thread as a whole.
struct PushedRow {
    explicit PushedRow(Row& of) : row(&of) {}

    Row* row;
    std::array<int, 4> node{};  ///< Its points lie apart by the sum of weight * node.
    std::array<double, 4> weight{};
    int nodes = 0;
    std::array<int, 8> link{};     ///< Links whose lengths a push changes,
    std::array<Vec3, 8> effect{};  ///< by effect * push,
    std::array<int, 8> place{};    ///< and where they are among all that rows touch.
    int links = 0;
    Vec3 apart = Vec3::Zero();     ///< Before all pushes.
    Eigen::Matrix3d own = {};      ///< How its points give way to pushes on themselves,
    double mobility = 0;           ///< along the normal.
    Eigen::Matrix3d against = {};  ///< Times a slip: the push that undoes it.
};

/// What pressed on a piece of thread as it fell asleep.
struct SleepingPress {
    Row row;                  ///< Pushes in newtons.
    geometry::Triangle wall;  ///< Where that was, if it is one.
};

/// Presses one after the other.
struct Run {
    std::size_t first, past;
};

/// A contact of an elastic thread during one step.
struct Press {
    explicit Press(Row* of) : row(of), normal(of->normal) {}

    Row* row;
    Vec3 normal;                                     ///< The row's: sweeps have it at hand with what follows.
    Vec3 push = Vec3::Zero();                        ///< [N] on the link, drag and all.
    Vec3 began = Vec3::Zero();                       ///< As the tick began.
    Vec3 rest = Vec3::Zero();                        ///< Where it would press and drag no more [m].
    double friction = 0;                             ///< Coulomb's, and what a polyline lacks.
    double give = 0;                                 ///< Of the contact itself and of what it presses on [m/N].
    double gives = 0;                                ///< How its points give way to its own push across, across [m/N],
    Vec3 across = Vec3::Zero();                      ///< and in all;
    Eigen::Matrix3d along = {};                      ///< the push along that undoes a slip [N/m].
    Vec3 before = Vec3::Zero(), way = Vec3::Zero();  ///< Its push as a sweep began, and where sweeps lead.
    Pair pair;                                       ///< Where it acts, and its push as the step began.
    std::array<Eigen::Index, 4> place{};             ///< Of those nodes' three axes among all that touch.
    std::array<int, 2> piece{-1, -1};                ///< Of the thread that they are of; none: -1.
    std::size_t answers = 0;                         ///< Which list of those that answer to its pushes is its.
};

/// What is found together with all others where thread lies on steel: the pull of a link, or the push of a contact. It
/// acts on the link's two nodes with `weight` * `force`, so that what they measure along `axis` is right.
struct Unknown {
    Row* row;  ///< None: a length.
    int link;
    std::array<double, 2> weight;
    Vec3 axis, force;
    double compliance;
};

/// Of a link on steel, from substep to substep.
struct Wrap {
    double grip = 0;  ///< As Row::grip.
    bool presses = false;
};

/// How far one dares to go, for tools that move together.
struct Pace {
    double trust = 1;           ///< Share of the admissible step that the last substep managed.
    int refused_in_a_row = 0;   ///< Substeps undone since the last good one,
    int jams_in_a_row = 0;      ///< those of them at the least trust,
    int waits = 0;              ///< and ticks until what is jammed is tried again.
    bool stuck = false;         ///< Meanwhile not even the slack around it can answer.
    std::vector<Vec3> refused;  ///< What was asked for when last refused: the ways of what is held and of tools [m].
};

constexpr int most_coupled = 64;  ///< Rows that are solved together with all lengths.
/// A number per axis of those rows.
template <int rows, int columns>
using PerAxis = Eigen::Matrix<double, rows, columns, columns == 1 ? Eigen::ColMajor : Eigen::RowMajor,
                              rows == 1 ? 1 : 3 * most_coupled, columns == 1 ? 1 : 3 * most_coupled>;

/// A matrix in a room that only grows.
struct Table {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    Eigen::Map<Matrix> resized(Eigen::Index rows, Eigen::Index columns) {
        if (room.size() < static_cast<std::size_t>(rows * columns))
            room.resize(static_cast<std::size_t>(rows * columns));
        return {room.data(), rows, columns};
    }

    std::vector<double> room;
};

/// A short substep that is not within tolerance yet. The thread stays as it was before it, tools wait, and the next
/// tick goes on from here: a hard knot takes several ticks, none of them long.
struct Unfinished {
    int pace = -1;     ///< Of State::paces: whose it is; -1: there is none.
    double share = 0;  ///< Of the tick's motion.
    int tries = 0;
    std::vector<Vec3> nodes;  ///< [m]
};

struct State {
    State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes, std::span<const int> cuts = {});
    /// Everything that there is one of per node or link and that no tick hands on to the next. Allocates nothing.
    void size_for_links();

    int links() const { return static_cast<int>(rest.size()); }
    /// A cut is a link that is no more; it has no length, and what it parts meets only as other strands do.
    bool is_cut(std::size_t link) const { return rest[link] == 0; }
    bool is_first(std::size_t node) const { return node == 0 || is_cut(node - 1); }  ///< Of its piece,
    bool is_last(std::size_t node) const { return node == rest.size() || is_cut(node); }
    bool is_end(std::size_t node) const { return is_first(node) || is_last(node); }

    ThreadDef def;
    std::vector<Vec3> nodes;
    std::vector<double> rest;  ///< [m]; 0: a cut.
    std::vector<double>
        arc;              ///< Per node: length of thread before it, with a cut as long as nothing is looked for [m].
    double longest_link;  ///< When the thread was made [m].
    std::vector<double> nearest;  ///< Scratch: per link, distance of the nearest strand in thicknesses.

    std::vector<double>
        least_span;  ///< Per inner node: least distance of its neighbours, by the thread's thickness [m].

    // One tick.
    std::vector<double> inverse_mass;  ///< 1, or 0 for a held node.
    std::vector<Vec3> hold_from;       ///< Per hold: where its node was when the tick began.
    TickInput input;
    std::vector<double> progress,
        progress_before;  ///< Share of its motion in this tick that each group of tools has made.

    // One substep.
    std::vector<Vec3> before;           ///< Nodes when the substep began.
    std::vector<double> bound;          ///< How far each node may move in this substep [m].
    std::vector<double> room_at_walls;  ///< Scratch: per node, what is free between its links and walls [m].
    std::vector<Capsule> capsules, capsules_before;
    std::vector<Row> rows;      ///< Contacts that can touch in this substep,
    std::vector<int> on_steel;  ///< and which of them glide, one a link, increasing.
    std::vector<int> kept;      ///< Nodes that are held in this substep because they press.

    // Carried from tick to tick.
    std::vector<Contact> contacts;   ///< Every pair within `reach` when last detected: strands, then tools, then walls.
    double reach = 0;                ///< [m]
    double moved = 0;                ///< Sum of largest node moves (and tool moves) since then [m].
    bool is_rest_due = false;        ///< Only tools have been looked at since.
    std::vector<int> seen;           ///< Holds, owners, capsules and size of the surface that the contacts are for.
    std::vector<Vec3> drift;         ///< How each node moved in the last substep [m] ...
    double drift_way = 0;            ///< ... while held nodes or tools went this far [m].
    std::vector<double> following;   ///< Per node: of that way, how much it went, drift and all.
    std::vector<Pace> paces;         ///< Of all groups together, then of each alone.
    std::vector<Vec3> asked;         ///< Scratch: as Pace::refused,
    std::size_t asked_of_holds = 0;  ///< those of holds first.
    Unfinished unfinished;
    int work = 0;                 ///< Of this tick, in passes over contacts and lengths,
    int wasted = 0;               ///< and how much of it on answers that were refused.
    bool slides = false;          ///< What is led is taut over walls and follows along itself (slide.cpp).
    bool settled = false;         ///< Nothing moved and nothing is violated: a tick without motion does nothing.
    std::vector<double> tension;  ///< [N] per link.
    std::vector<SurfaceForce> surface_forces;

    std::optional<Rod> rod;           ///< Of an elastic thread.
    std::vector<int> touching;        ///< Scratch of it: nodes that pushes act on, increasing,
    std::vector<Eigen::Index> place;  ///< and of each where its three axes begin among theirs,
    std::vector<Press> presses;
    std::vector<Press> all_presses;  ///< Scratch, of a thread that was cut: those of all islands, while one is solved;
    std::vector<double> all_apart;   ///< their `apart`;
    std::vector<int> piece_of, island;        ///< of each node the piece, and of each piece the first in its island.
    std::vector<std::size_t> first_touching;  ///< Of each piece, among what touches; past the last its end.
    std::vector<double> inverses;  ///< ChainMatrix::inverse_at each piece's nodes that touch, one after the other,
    std::vector<std::size_t> first_inverse;  ///< where each begins.
    std::vector<Run> answering;              ///< Lists of presses that answer to others' pushes, in runs,
    std::vector<std::size_t> first_answer;   ///< and where each list begins.
    std::vector<Rolling> rolling;
    std::vector<Pair> pairs;
    std::vector<Hold> targets;
    std::vector<Vec3> forces;
    std::vector<double>
        apart;  ///< Of the points of all presses, from the other's to the link's, as the step has it [m],
    std::vector<double> apart_before, apart_way;  ///< as a sweep began, and where sweeps lead.
    std::vector<double> press_moves;  ///< Of what touches, for a unit push at one contact along one axis [m/N].
    Table press_responses, press_across;
    std::vector<Row*> nearest_rows;   ///< Scratch.
    std::vector<int> pushing, wrong;  ///< Scratch: presses, in their order.
    std::vector<double> push_change;
    std::vector<Row> pressed;  ///< What pressed when its last step ended; pushes in newtons.
    std::vector<char> asleep;  ///< Per node: whether its piece sleeps.
    std::vector<SleepingPress> sleeping;
    std::vector<Vec3> watched;  ///< Where each node was when it was last looked at whether its piece is still,
    int watched_ticks = 0;      ///< so many ticks ago.

    LinkTree tree;
    std::vector<int> found;  ///< Scratch.
    struct Middle {
        Vec3 place;
        double half;
    };
    std::vector<Middle> middles;  ///< Of links, with half their lengths [m]: most pairs are told apart by these.
    std::vector<Vec3> unit;       ///< Scratch of the length solve.
    std::vector<double> lower, pivot, upper, multiplier;  ///< The last length solve: its factors and its answer.
    std::vector<double> pulled;          ///< Per link, multipliers of the substep's length solves; negative: shortened.
    std::vector<double> rubbed;          ///< Per link, friction of what it touches; -1: nothing.
    std::vector<double> profile;         ///< Per link, its tension as a share of any.
    std::vector<PushedRow> pushed_rows;  ///< Scratch of coupling.
    PerAxis<Eigen::Dynamic, 1> pushes;   ///< Of all those rows.
    PerAxis<Eigen::Dynamic, 1> pushes_before, gain, way;  ///< As a sweep began, what it gained, and where sweeps lead.
    Table responses;                                      ///< How far their points move apart for unit pushes.
    Table effects, answers;  ///< Of unit pushes on lengths, and of the lengths' multipliers.
    PerAxis<1, Eigen::Dynamic> answer_from_left;
    std::vector<double> weight_at;  ///< Per node; 0 between uses.
    std::vector<int> touched;       ///< Links that pushed rows touch.
    struct Reach {
        double diagonal, share;
    };
    std::vector<Reach> inverse;  ///< Of the lengths' matrix, at those links.
    std::vector<Vec3> coupled_move;
    std::vector<Wrap> wraps;            ///< Per link, of the last substep,
    std::vector<double> pulled_before;  ///< and `pulled`.
    std::vector<Unknown> unknowns;      ///< Scratch of thread on steel: what is asked for,
    std::vector<double> unknown;        ///< errors and then answers,
    Band band;
    std::vector<Vec3> line, glided;                     ///< per node: along the thread, and how it moves [m],
    std::vector<double> stiff;                          ///< and how much harder across itself.
    std::vector<Vec3> carried;                          ///< Scratch: how far taut spans went along with their ends.
    std::vector<Vec3> forward;                          ///< Scratch of Follow-The-Leader.
    mutable std::vector<Box> audit_boxes, audit_links;  ///< Scratch of the audit.
    mutable std::vector<int> audit_found;
};

}  // namespace sim::thread
