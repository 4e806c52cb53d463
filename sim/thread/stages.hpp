#pragma once
#include "sim/thread/state.hpp"

// The stages of a tick, all on a State. Private to sim/thread.
namespace sim::thread {

constexpr double looked_around = 6;  ///< Radii: how far strands look for each other.
constexpr int most_work = 54;        ///< Of a tick, in passes: what is left then is lag.

// Tolerances, as shares of the thread's own sizes.
constexpr double stretch_tolerance = 5e-4;  ///< Of a link's rest length: half of what a thread at rest may show.
/// Strands keep so much farther apart than they are thick: what passes leave undone is air then, not overlap.
constexpr double skin = 0.045;         ///< Of the thread's thickness.
constexpr double strand_goal = 0.03;   ///< Of it too: how far into the skin passes still work ...
constexpr double strand_limit = 0.05;  ///< ... and tools wait: strands then touch by less than a hundredth.
constexpr double steel_limit = 0.2;    ///< Of it too: how far into tools and walls; tools wait then.
constexpr double slip_goal = 0.03;     ///< Of it too: what friction that holds may let slide in a substep.
constexpr double bound_share = 0.45;   ///< Two neighbours that each use it keep a tenth of their distance.

/// How the thread answers when held nodes move. Least motion first: all nodes together move as little as the lengths
/// allow, so slack is taken up before anything is dragged (plain Follow-The-Leader drags the far end of a slack thread
/// as if it were taut). A taut thread that must slide round things is found quickly only by letting it follow its
/// leader. Drawn over walls, through ten bites, it must slide along itself: neither is found. Where strands are jammed
/// in each other and no answer is found for them, what presses stays where it is and the slack around it answers: a
/// knot pulled tight must not hold up the hands that let go of it. What is unfinished is gone on with.
enum class Answer { drift, follow_the_leader, slide, keep_what_presses, go_on };
/// What an answer may cost at most: passes over contacts and lengths in turn, then solves of both together.
struct Effort {
    int passes, couplings;
};
struct Substep {
    bool accepted = false;
    double over_bound = 0;
    int pass_throughs = 0;
};
/// Moves tools and held nodes to where they are at `progress`, by at most `way` [m], and lets the thread answer. Undone
/// unless the result is within tolerance or no worse than what was there: so a thread that cannot follow stays as it is
/// and the tools wait (substep.cpp).
Substep attempt(State& state, double way, Answer answer, Effort effort);
void place_capsules(State& state);
/// Of any capsule's end, since capsules_before [m].
double largest_capsule_move(const State& state);
/// The longest way that a held node, and a tool part, is asked to go in this tick [m].
struct Motion {
    double of_holds = 0, of_capsules = 0;
    double most() const { return std::max(of_holds, of_capsules); }
};
/// How far a tool part that was out of reach may go: as near as its reach, no nearer, before we look again [m]
/// (tick.cpp).
double unseen_room(const State& state);
/// What share of its motion in this tick the tool of a contact may make: into the thread by no more than the thread's
/// radius.
double share_beside(const State& state, const Contact& c);
/// All of a tick but what is told of it, for an elastic thread (elastic.cpp).
void elastic_tick(State& state, const Motion& motion, TickReport& report);
/// Rows that press, or may come to in this step, `presses` and `pairs` (find_presses.cpp).
void find_presses(State& state);
/// The pushes of all together with the rod, whose step with the pushes as they were is known; returns how many sweeps
/// that took.
int solve_presses(State& state);
/// Held nodes to where they are asked to be at `progress` (follow_leader.cpp).
void place_held(State& state);
/// Taut spans between held nodes go along with what the ways of both ends have in common.
void carry_taut_spans(State& state);
/// Follow-The-Leader from every held node outwards.
void follow_leader(State& state);

/// Whether the thread lies at walls and is only drawn, away from free ends.
bool may_slide(const State& state);
/// Into State::slides, after a substep: whether it may, and free ends followed: there is no slack to take up first.
void note_whether_it_slides(State& state);
/// What share of the way the thread can so follow in one step.
double share_of_slide(const State& state, double way);
/// Along itself after what leads it; returns the worst violation left, 1 where tools must wait (slide.cpp).
double slide_along(State& state);

/// One Newton step of all lengths at once; returns the worst |l/l0 - 1| found before it (lengths.cpp).
double solve_lengths(State& state);
/// Directions of all links, their length errors into `multiplier`; returns the worst relative error. A cut has neither.
double measure_links(State& state);
double worst_stretch(const State& state, const std::vector<Vec3>& nodes);

/// Every pair within `reach` of each other, where it is not known already (detect.cpp): whether anything was to be
/// found.
bool look_around(State& state, double way);
/// Only what tools are near; the next look_around() sees the rest. Contacts are not to be used for more before it.
bool look_at_tools(State& state, double way);
/// Gaps of all contacts as the nodes stand, the bound of each node from them, and the rows (gaps.cpp).
void measure_gaps(State& state, double way);

/// What is farther off than where it touches by this has no row [m].
double closing(const State& state);

/// And this one does not press in the next step of an elastic thread, but where it did [m].
double about_to_press(const State& state);

/// Of a wall that its owner moves as an elastic thread presses on it (TickInput::soft_from): links lean on such with
/// their ends.
template <class RowOrContact>
bool is_on_soft_wall(const State& state, const RowOrContact& c) {
    return state.rod && c.against == Against::surface && c.other >= state.input.soft_from;
}

/// Cosine of the angle within which rows on a wall say the same (gaps.cpp).
double same_way_on_wall(const State& state);

/// Whether any row that glides pushes or is about to (glide.cpp).
bool is_on_steel(const State& state);
/// As solve_lengths, with the pushes and the friction of steel: one Newton step of them all, O(n).
double glide(State& state);
/// Whether the second row is of the same tool part and the next link.
bool goes_on(const Row& row, const Row& next);
/// Into State::wraps, and from there to rows: finds what lies along steel as the rows were measured (wraps.cpp).
void remember_wraps(State& state);
void recall_wraps(State& state);
/// What pressed on steel when the last substep ended is laid on it where it has come to: drift goes straight on, steel
/// is round.
void lie_on_steel(State& state);

/// Only how far links are from tools; rows are not to be used before measure_gaps().
void measure_tool_gaps(State& state);

/// Rows to the nearest points as everything stands now; returns the worst overlap, 1 where tools must wait
/// (resolve.cpp).
double aim(State& state);
/// One pass over all rows with friction; returns the worst overlap found before it, 1 where it is small enough.
double resolve_contacts(State& state);
/// All rows that push, together with all lengths; returns the worst overlap that its linear model expects to be left, 1
/// where it is small enough (couple.cpp).
double couple(State& state);
/// What passes stop for: strands into each other's skin by `strand_goal`, thread into steel or a wall by a tenth of its
/// thickness, which is out of sight, and wherever it was by less than `steel_limit`.
double over_goal(const State& state, const Row& row, double distance);
/// From the other's point to the link's, as the nodes are [m].
Vec3 apart_of(const State& state, const Row& row);
/// Moves the nodes of a row by a push.
void push_apart(State& state, const Row& row, const Vec3& push);
/// Projected Gauss-Seidel on one row whose points are `apart` and give way by `mobility` to a unit push along the
/// normal: the push never pulls. Pushes are totals of the substep, so they do not depend on how many passes are made or
/// how long a tick is; returned is what they gained.
double add_normal_push(Row& row, const Vec3& apart, double mobility);
/// How far the points have slid on each other in this substep [m].
Vec3 slip_of(const Row& row, const Vec3& apart);
/// As far as Coulomb's cone allows, the push that is `wanted` against the slip.
Vec3 add_tangent_push(Row& row, const Vec3& slip, const Vec3& wanted);
/// Overlap of a row, 1 where tools must wait: strands that touch, for there topology is at stake; a thread a fifth in
/// steel.
double over_limit(const State& state, const Row& row);
/// The least distance [m] between the outer ends of links of lengths `a` and `b` [m] that turn about a thread of
/// `radius` [m].
double least_span(double a, double b, double radius);
/// Keeps every bend no tighter than that.
void limit_bends(State& state);

/// Contacts and lengths in turn until neither is violated; returns the worst violation left, 1 where tools must wait
/// (relax.cpp).
double relax(State& state, Effort effort);
/// No node leaves its bound, whatever stage moved it.
void clip(State& state);

/// Pass-throughs between `before` and `nodes`, found without using contacts or bounds (audit.cpp).
int audit(const State& state);

/// Halves links that bend or touch and joins straight ones, by ThreadDef::shortest_link, each time the thread has moved
/// by its own radius; whether any changed (links.cpp).
bool fit_links(State& state, std::span<int> held);
/// A node more, at a share of a link; nothing moves.
void split(State& state, std::size_t link, double share, std::span<int> held);
/// After links have changed: what there is one of per link, and what was known of their surroundings.
void renew(State& state);
/// As Thread::cut (cut.cpp).
bool cut(State& state, std::size_t link, double share, std::span<int> held);
int most_loaded(const State& state);
/// By how much the thread turns at a node [rad], as the chord of the angle; not at all at the ends of a piece.
double turn_at(const State& state, std::size_t node);

/// Nearer than a radius to touching.
inline bool is_touched(const State& state, const Row& row) {
    return row.distance < row.thickness + state.def.radius;
}

struct Tail;
/// Into State::rubbed (capstan.cpp).
void find_rubbed(State& state);
/// The node farthest from its hold whose link to it is rubbed; the held one where none is.
std::size_t last_rubbed(const State& state, const Tail& tail);

/// Of State::rubbed into State::profile, of strands that are drawn over walls and tools with their other ends free:
/// Euler's and Eytelwein's law, the pull grows by e to friction times turn (capstan.cpp). O(n).
void find_capstan_profile(State& state);

/// Whether a link's piece sleeps (sleep.cpp).
inline bool sleeps(const State& state, int link) {
    return !state.asleep.empty() && state.asleep[static_cast<std::size_t>(link)] &&
           state.asleep[static_cast<std::size_t>(link) + 1];
}
/// As holds do: nothing moves its nodes.
void hold_what_sleeps(State& state);
/// Wakes the piece that a link is of.
void wake_at(State& state, std::size_t link);
/// As a tick begins: pieces whose holds or walls have moved wake.
void wake_what_is_moved(State& state);
/// As it ends: those that something has come to wake, those that have long been still fall asleep.
void watch_over_pieces(State& state);
/// All that pressed when last solved, of pieces that sleep and that do not.
template <class Change>
void for_all_pressed(State& state, Change change) {
    for (Row& row : state.pressed) change(row);
    for (SleepingPress& press : state.sleeping) change(press.row);
}

/// What the thread does to the surface as it lies now, after the tick's tensions are known (surface.cpp).
void find_surface_forces(State& state);

/// Tension estimate of every link from how far the held nodes lag behind their targets (tension.cpp).
void estimate_tension(State& state);

}  // namespace sim::thread
