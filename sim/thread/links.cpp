#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/thread/stages.hpp"

// Links where they are needed. A link is halved at its middle, which moves nothing; two are joined only where they lie
// straight and clear of other strands, so that nothing can be in the sliver between them and their chord.
namespace sim::thread {

constexpr double most_sagitta =
    0.25;  // of the radius: a link is longer then than the geometric mean of thickness and bend

// How far links of length `l` lie off the curve that turns by `turn` [rad] at each of them: the sagitta of an arc.
static double sagitta(double l, double turn) {
    return l * turn / 8;
}

static Vec3 direction(const State& state, std::size_t link) {
    return (state.nodes[link + 1] - state.nodes[link]).stableNormalized();
}

double turn_at(const State& state, std::size_t node) {
    return state.is_end(node) ? 0 : (direction(state, node) - direction(state, node - 1)).norm();
}

// Nearest other strand of every link, in thicknesses, as it was when last looked at. What is as near along the thread
// as we look is no other strand: there the bend between says how short links must be.
static void measure_nearest(State& state) {
    state.nearest.assign(state.rest.size(), 1e300);
    for (const Contact& c : state.contacts) {
        if (c.against != Against::thread || state.arc[at(c.other)] - state.arc[at(c.link + 1)] < state.reach) continue;
        for (const int link : {c.link, c.other})
            state.nearest[at(link)] = std::min(state.nearest[at(link)], c.gap / c.thickness);
    }
}

static bool asks_for_shorter(const State& state, std::size_t link) {
    constexpr double touching = 1.1, root_two = 1.4142135623730951;
    if (state.rest[link] <= root_two * state.def.shortest_link ||
        state.inverse_mass[link] + state.inverse_mass[link + 1] == 0)
        return false;
    const double turn = std::max(turn_at(state, link), turn_at(state, link + 1));
    return state.nearest[link] < touching || sagitta(state.rest[link], turn) > most_sagitta * state.def.radius;
}

// By joining two links half of what halves one must not be reached, or it would be halved again.
static bool can_go(const State& state, std::size_t node) {
    constexpr double clear = 1.9;  // nearer strands are measured in every substep
    constexpr double most_moved = 0.1;
    const double a = state.rest[node - 1], b = state.rest[node], joined = a + b;
    if (state.is_end(node) || state.inverse_mass[node] == 0 || joined > state.longest_link ||
        std::min(state.nearest[node - 1], state.nearest[node]) < clear)
        return false;
    const double off = a * b / joined * turn_at(state, node);
    const double turn = turn_at(state, node) + std::max(turn_at(state, node - 1), turn_at(state, node + 1));
    return off < most_moved * state.def.radius && sagitta(joined, turn) < 0.5 * most_sagitta * state.def.radius;
}

template <class T>
static void insert(std::vector<T>& values, std::size_t place, const T& value) {
    values.insert(values.begin() + static_cast<std::ptrdiff_t>(place), value);
}

template <class T>
static void erase(std::vector<T>& values, std::size_t place) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(place));
}

static void renumber(std::span<int> held, int from, int by) {
    for (int& node : held)
        if (node >= from) node += by;
}

void split(State& state, std::size_t link, double share, std::span<int> held) {
    const auto insert_between = [&](auto& values) {
        insert(
            values, link + 1,
            typename std::decay_t<decltype(values)>::value_type((1 - share) * values[link] + share * values[link + 1]));
    };
    insert_between(state.nodes);
    insert_between(state.drift);
    insert_between(state.following);
    insert(state.inverse_mass, link + 1, 1.0);
    for (std::vector<double>* of_links : {&state.rest, &state.tension, &state.nearest})
        insert(*of_links, link, (*of_links)[link]);
    state.rest[link] *= share;
    state.rest[link + 1] *= 1 - share;
    const int parted = static_cast<int>(link);
    renumber(held, parted + 1, 1);
    if (!state.rod) return;
    insert_between(state.watched);
    insert(state.asleep, link + 1, state.asleep[link]);
    state.rod->split(link, share);
    for_all_pressed(state, [&](Row& row) {
        if (row.link > parted || (row.link == parted && row.s > share)) ++row.link;
        if (row.against == Against::thread && (row.other > parted || (row.other == parted && row.t > share)))
            ++row.other;
    });
}

static void join_at(State& state, std::size_t node) {
    erase(state.nodes, node);
    erase(state.drift, node);
    erase(state.following, node);
    erase(state.inverse_mass, node);
    state.rest[node - 1] += state.rest[node];
    for (std::vector<double>* of_links : {&state.rest, &state.tension, &state.nearest}) erase(*of_links, node);
    if (!state.rod) return;
    erase(state.watched, node);
    erase(state.asleep, node);
    state.rod->join_at(node);
    const int joined = static_cast<int>(node);
    for_all_pressed(state, [&](Row& row) {
        if (row.link >= joined) --row.link;
        if (row.against == Against::thread && row.other >= joined) --row.other;
    });
}

// From the last to the first, so that what is still to be looked at keeps its number.
static bool halve_where_needed(State& state, std::span<int> held) {
    bool changed = false;
    for (int k = state.links() - 1; k >= 0; --k) {
        if (!asks_for_shorter(state, at(k))) continue;
        split(state, at(k), 0.5, held);
        changed = true;
    }
    return changed;
}

static bool join_where_straight(State& state, std::span<int> held) {
    bool changed = false;
    for (int i = state.links() - 1; i >= 1; --i) {
        if (!can_go(state, at(i))) continue;
        join_at(state, at(i));
        renumber(held, i, -1);
        --i;  // what was just joined stays as it is this time
        changed = true;
    }
    return changed;
}

void renew(State& state) {
    state.size_for_links();
    if (state.rod) state.rod->resize();
    state.contacts.clear();
    state.rows.clear();
    state.seen.clear();  // to be looked for again
    state.settled = false;
}

bool fit_links(State& state, std::span<int> held) {
    const bool stands = state.unfinished.pace >= 0 || (state.reach > 0 && state.moved <= state.def.radius);
    if (state.def.shortest_link <= 0 || state.settled || stands) return false;
    std::fill(state.inverse_mass.begin(), state.inverse_mass.end(), 1.0);
    for (const int node : held) state.inverse_mass[at(node)] = 0;
    hold_what_sleeps(state);
    measure_nearest(state);
    const bool joined = join_where_straight(state, held), halved = halve_where_needed(state, held);
    if (!joined && !halved) return false;
    renew(state);
    return true;
}

}  // namespace sim::thread
