#include "sim/thread/links.hpp"

#include <algorithm>

#include "sim/geometry/at.hpp"

// Links where they are needed. A link is halved at its middle, which moves nothing; two are joined only where they lie
// straight and clear of other strands, so that nothing can be in the sliver between them and their chord.
namespace sim::thread {

using contact::Against;
using contact::Contact;
using contact::State;

constexpr double most_sagitta =
    0.25;  // of the radius: a link is longer then than the geometric mean of thickness and bend

// How far links of length `l` lie off the curve that turns by `turn` [rad] at each of them: the sagitta of an arc.
static double sagitta(double l, double turn) {
    return l * turn / 8;
}

// Nearest other strand of every link, in thicknesses, as it was when last looked at. What is as near along the thread
// as we look is no other strand: there the bend between says how short links must be.
void LinkFitter::measure_nearest(const State& state) {
    nearest_.assign(state.rest_length.size(), 1e300);
    for (const Contact& c : state.contacts) {
        if (c.against != Against::thread || state.arc[at(c.other)] - state.arc[at(c.link + 1)] < state.reach) continue;
        for (const int link : {c.link, c.other}) nearest_[at(link)] = std::min(nearest_[at(link)], c.gap / c.thickness);
    }
}

bool LinkFitter::asks_for_shorter(const State& state, std::size_t link) const {
    constexpr double touching = 1.1, root_two = 1.4142135623730951;
    if (state.rest_length[link] <= root_two * state.def.shortest_link ||
        state.inverse_mass[link] + state.inverse_mass[link + 1] == 0)
        return false;
    const double turn = std::max(turn_at(state, link), turn_at(state, link + 1));
    return nearest_[link] < touching || sagitta(state.rest_length[link], turn) > most_sagitta * state.def.radius;
}

// By joining two links half of what halves one must not be reached, or it would be halved again.
bool LinkFitter::can_go(const State& state, std::size_t node) const {
    constexpr double clear = 1.9;  // nearer strands are measured in every substep
    constexpr double most_moved = 0.1;
    const double a = state.rest_length[node - 1], b = state.rest_length[node], joined = a + b;
    if (state.is_end(node) || state.inverse_mass[node] == 0 || joined > state.longest_link ||
        std::min(nearest_[node - 1], nearest_[node]) < clear)
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

void split(Mover& mover, std::size_t link, double share, std::span<int> held) {
    State& state = state_of(mover);
    insert(state.nodes, link + 1, Vec3((1 - share) * state.nodes[link] + share * state.nodes[link + 1]));
    insert(state.inverse_mass, link + 1, 1.0);
    for (std::vector<double>* of_links : {&state.rest_length, &state.tension})
        insert(*of_links, link, double((*of_links)[link]));
    state.rest_length[link] *= share;
    state.rest_length[link + 1] *= 1 - share;
    renumber(held, static_cast<int>(link) + 1, 1);
    std::visit([&](auto& one) { one.split(link, share); }, mover);
}

static void join_at(Mover& mover, std::size_t node) {
    State& state = state_of(mover);
    erase(state.nodes, node);
    erase(state.inverse_mass, node);
    state.rest_length[node - 1] += state.rest_length[node];
    for (std::vector<double>* of_links : {&state.rest_length, &state.tension}) erase(*of_links, node);
    std::visit([&](auto& one) { one.join_at(node); }, mover);
}

// From the last to the first, so that what is still to be looked at keeps its number.
bool LinkFitter::halve_where_needed(Mover& mover, std::span<int> held) const {
    const State& state = state_of(mover);
    bool changed = false;
    for (int k = state.links() - 1; k >= 0; --k) {
        if (!asks_for_shorter(state, at(k))) continue;
        split(mover, at(k), 0.5, held);
        changed = true;
    }
    return changed;
}

bool LinkFitter::join_where_straight(Mover& mover, std::span<int> held) {
    const State& state = state_of(mover);
    bool changed = false;
    for (int i = state.links() - 1; i >= 1; --i) {
        if (!can_go(state, at(i))) continue;
        join_at(mover, at(i));
        erase(nearest_, at(i));
        renumber(held, i, -1);
        --i;  // what was just joined stays as it is this time
        changed = true;
    }
    return changed;
}

void renew(Mover& mover) {
    std::visit([](auto& one) { one.renew(); }, mover);
    State& state = state_of(mover);
    state.contacts.clear();
    state.rows.clear();
    state.seen.clear();  // to be looked for again
}

bool LinkFitter::fit(Mover& mover, std::span<int> held) {
    State& state = state_of(mover);
    const bool keeps_links = std::visit([](const auto& one) { return one.keeps_links(); }, mover);
    const bool stands = keeps_links || (state.reach > 0 && state.moved <= state.def.radius);
    if (state.def.shortest_link <= 0 || stands) return false;
    std::fill(state.inverse_mass.begin(), state.inverse_mass.end(), 1.0);
    for (const int node : held) state.inverse_mass[at(node)] = 0;
    std::visit([](auto& one) { one.hold_what_sleeps(); }, mover);
    measure_nearest(state);
    const bool joined = join_where_straight(mover, held), halved = halve_where_needed(mover, held);
    if (!joined && !halved) return false;
    renew(mover);
    return true;
}

}  // namespace sim::thread
