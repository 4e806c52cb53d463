#include "sim/thread/elastic/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/geometry/at.hpp"
#include "sim/geometry/triangle_tree.hpp"

// Of several pieces of an elastic thread, one that no tool holds and that has been still for a while sleeps: it is not
// solved, and holds walls as it did, until a tool, another piece, a wall or what holds it stirs it. So a stitch that is
// tied costs next to nothing while the next is made, and cannot creep. A thread in one piece is the one that is worked
// with, and does not.
namespace sim::thread::elastic {

namespace {

constexpr int watch =
    100;  // [ticks]: what falls asleep has gone less far in so many, where it presses on something and elsewhere
double still(const State& state) {
    return 0.25 * state.def.radius;
}
double still_in_air(const State& state) {
    return 2 * state.def.radius;
}
// And what wakes it. Walls are some 100 N/m soft: one that has gone so far, against what holds it, has a millinewton
// more or less to bear.
double stirred(const State& state) {
    return 0.25 * state.def.radius;
}

Piece piece_at(const State& state, int node) {
    Piece piece{node, node};
    while (!state.is_first(at(piece.first))) --piece.first;
    while (!state.is_last(at(piece.last))) ++piece.last;
    return piece;
}

bool is_of(const Piece& piece, const Row& row) {
    return row.link >= piece.first && row.link < piece.last;
}

geometry::Triangle wall_of(const State& state, const Row& row) {
    return row.against == Against::surface ? (*state.input.surface)[row.other]
                                           : geometry::Triangle{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
}

void fall_asleep(State& state, const Piece& piece) {
    std::fill(state.asleep.begin() + piece.first, state.asleep.begin() + piece.last + 1, 1);
    for (const Row& row : state.pressed)
        if (is_of(piece, row)) state.sleeping.push_back({row, wall_of(state, row)});
    std::erase_if(state.pressed, [&](const Row& row) { return is_of(piece, row); });
    state.seen.clear();  // what is around is looked for anew
}

bool has_stirred(const State& state, const SleepingContact& contact) {
    const geometry::Triangle now = wall_of(state, contact.row), &then = contact.wall;
    const double most = stirred(state);
    return (now.a - then.a).squaredNorm() > most * most || (now.b - then.b).squaredNorm() > most * most ||
           (now.c - then.c).squaredNorm() > most * most;
}

bool is_in_hand(const State& state, const Piece& piece) {
    for (std::size_t h = 0; h < state.input.holds.size(); ++h) {
        const int node = state.input.holds[h].node;
        if (state.input.hold_owners[h] >= 0 && node >= piece.first && node <= piece.last) return true;
    }
    return false;
}

bool is_still(const State& state, const Piece& piece) {
    const auto went_less = [&](int node, double most) {
        return (state.nodes[at(node)] - state.watched[at(node)]).squaredNorm() <= most * most;
    };
    for (int i = piece.first; i <= piece.last; ++i)
        if (!went_less(i, still_in_air(state))) return false;
    return std::all_of(state.pressed.begin(), state.pressed.end(), [&](const Row& row) {
        return !is_of(piece, row) || (went_less(row.link, still(state)) && went_less(row.link + 1, still(state)));
    });
}

void wake_what_is_touched(State& state) {
    for (const Row& row : state.rows) {
        if (state.sleeps(row.link)) wake(state, row.link);
        if (row.against == Against::thread && state.sleeps(row.other)) wake(state, row.other);
    }
    for (const Contact& c : state.contacts)
        if (c.against == Against::surface && c.gap < c.thickness - stirred(state) && state.sleeps(c.link))
            wake(state, c.link);
}

}  // namespace

// It must be still for a whole watch again.
void wake(State& state, int node) {
    if (!state.asleep[at(node)]) return;
    const Piece piece = piece_at(state, node);
    std::fill(state.asleep.begin() + piece.first, state.asleep.begin() + piece.last + 1, 0);
    std::fill(state.watched.begin() + piece.first, state.watched.begin() + piece.last + 1,
              Vec3::Constant(std::numeric_limits<double>::infinity()));
    for (const SleepingContact& contact : state.sleeping)
        if (is_of(piece, contact.row)) state.pressed.push_back(contact.row);
    std::erase_if(state.sleeping, [&](const SleepingContact& contact) { return is_of(piece, contact.row); });
    state.seen.clear();
}

void hold_what_sleeps(State& state) {
    for (std::size_t i = 0; i < state.asleep.size(); ++i)
        if (state.asleep[i]) state.inverse_mass[i] = 0;
}

void wake_what_is_moved(State& state, std::vector<int>& stirred_links) {
    const bool is_wall_new = std::isinf(state.input.surface_moved);  // its triangles have other numbers
    for (const Hold& hold : state.input.holds)
        if ((hold.target - state.nodes[at(hold.node)]).norm() > stirred(state)) wake(state, hold.node);
    stirred_links.clear();
    for (const SleepingContact& contact : state.sleeping)
        if (contact.row.against == Against::surface && (is_wall_new || has_stirred(state, contact)))
            stirred_links.push_back(contact.row.link);
    for (const int link : stirred_links) wake(state, link);
}

void watch_over_pieces(State& state) {
    wake_what_is_touched(state);
    if (++state.watched_ticks < watch) return;
    state.watched_ticks = 0;
    for (int first = 0; first <= state.links();) {
        const Piece piece = piece_at(state, first);
        const bool is_whole = piece.last - piece.first == state.links();
        if (!is_whole && !state.asleep[at(first)] && !is_in_hand(state, piece) && is_still(state, piece))
            fall_asleep(state, piece);
        first = piece.last + 1;
    }
    state.watched = state.nodes;
}

}  // namespace sim::thread::elastic
