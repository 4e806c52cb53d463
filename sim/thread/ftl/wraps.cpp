#include "sim/thread/ftl/wraps.hpp"

#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/thread/contact/tolerances.hpp"
#include "sim/thread/ftl/resolve.hpp"

// Which of the thread lies along steel in a substep, and what it knows from the last one.
namespace sim::thread::ftl {

static bool is_near(const State& state, const Row& row) {
    return row.against == Against::capsule && is_touched(state, row);
}

// Where something else may press on the link too, it is pinched, or may be: two pushes that work against each other
// have no solution.
static bool is_alone(const State& state, const Row& row) {
    return std::none_of(state.rows.begin(), state.rows.end(), [&](const Row& other) {
        return other.link == row.link && &other != &row && other.distance < other.thickness + state.def.radius;
    });
}

// Strands that may come to press on each other are coupled with lengths and steel by passes, and a knot holds by that:
// all is left to them.
static bool is_knotted(const State& state) {
    const double neighbours =
        contact::looked_around * state.def.radius;  // along the thread: those are near at all times
    return std::any_of(state.rows.begin(), state.rows.end(), [&](const Row& row) {
        return row.against == Against::thread && state.arc[at(row.other)] - state.arc[at(row.link + 1)] >= neighbours;
    });
}

// A link or two that cross steel are met by passes.
static void find_wraps(State& state) {
    constexpr std::ptrdiff_t fewest = 4;  // links
    for (auto first = state.rows.begin(); first != state.rows.end();) {
        const auto is_part = [&](const Row& row) { return is_near(state, row) && is_alone(state, row); };
        auto last = first + 1;
        if (is_part(*first))
            while (last != state.rows.end() && is_next_link(last[-1], *last) && is_part(*last)) ++last;
        if (last - first >= fewest)
            for (auto row = first; row != last; ++row)
                state.on_steel.push_back(static_cast<int>(row - state.rows.begin()));
        first = last;
    }
}

void recall_wraps(State& state) {
    for (Row& row : state.rows) row.in_wrap = row.pressed = false;
    state.on_steel.clear();
    if (!is_knotted(state)) find_wraps(state);
    std::sort(state.on_steel.begin(), state.on_steel.end(),
              [&](int a, int b) { return state.rows[at(a)].link < state.rows[at(b)].link; });
    for (const int i : state.on_steel) {
        Row& row = state.rows[at(i)];
        const Wrap& wrap = state.last.wraps[at(row.link)];
        row.in_wrap = true;
        row.pressed = wrap.presses;
        row.friction_ratio = wrap.friction_ratio;
        row.slip_before = row.friction_ratio_before = 0;
    }
}

void remember_wraps(State& state) {
    std::fill(state.last.wraps.begin(), state.last.wraps.end(), Wrap{});
    for (const int i : state.on_steel)
        if (const Row& row = state.rows[at(i)]; row.normal_push > 0)
            state.last.wraps[at(row.link)] = {row.friction_ratio, true};
}

void lie_on_steel(State& state) {
    if (state.on_steel.empty()) return;
    aim(state);
    for (const int i : state.on_steel)
        if (const Row& row = state.rows[at(i)]; row.pressed && row.mobility > 0)
            push_apart(state, row, (row.target - row.distance) / row.mobility * row.normal);
}

}  // namespace sim::thread::ftl
