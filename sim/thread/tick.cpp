#include <algorithm>
#include <cassert>

#include "sim/thread/contact/tools.hpp"
#include "sim/thread/mover.hpp"

namespace sim::thread {

namespace {

bool is_finite(const TickInput& input) {
    for (const Hold& hold : input.holds)
        if (!hold.target.allFinite()) return false;
    for (const MovingCapsule& c : input.capsules)
        if (!(c.from.a.allFinite() && c.from.b.allFinite() && c.to.a.allFinite() && c.to.b.allFinite())) return false;
    return std::all_of(input.loads.begin(), input.loads.end(), [](const Vec3& load) { return load.allFinite(); });
}

// What nobody holds is owned by -1, tools from 0.
std::size_t groups_of(const TickInput& input) {
    int most = -1;
    for (const int owner : input.hold_owners) most = std::max(most, owner);
    for (const MovingCapsule& c : input.capsules) most = std::max(most, c.owner);
    return static_cast<std::size_t>(most + 2);
}

// What whoever makes a tick must keep.
void expect_kept([[maybe_unused]] const contact::State& state, const TickInput& input) {
    assert(input.hold_owners.size() == input.holds.size() && "an owner for each hold");
    assert((input.loads.empty() || input.loads.size() == state.nodes.size()) && "a load for each node, or none");
    assert((!state.def.elastic || input.seconds > 0) && input.surface_moved >= 0 && input.soft_compliance >= 0);
    for ([[maybe_unused]] const Hold& hold : input.holds)
        assert(hold.node >= 0 && hold.node <= state.links() && "a node of the thread");
    for ([[maybe_unused]] const int owner : input.hold_owners) assert(owner >= -1);
    for ([[maybe_unused]] const MovingCapsule& c : input.capsules) assert(c.owner >= -1 && c.from.radius > 0);
}

void begin(contact::State& state, const TickInput& input) {
    expect_kept(state, input);
    state.input = input;
    state.progress.assign(groups_of(input), 0);
    std::fill(state.inverse_mass.begin(), state.inverse_mass.end(), 1.0);
    state.hold_from.clear();
    for (const Hold& hold : input.holds) {
        state.inverse_mass[static_cast<std::size_t>(hold.node)] = 0;
        state.hold_from.push_back(state.nodes[static_cast<std::size_t>(hold.node)]);
    }
    // Tools go on from where they stopped; should one have leapt, what was known of its surroundings is out of date.
    state.capsules_before = state.capsules;
    place_capsules(state);
    if (state.capsules.size() == state.capsules_before.size()) state.moved += largest_capsule_move(state);
    state.moved += input.surface_moved;
}

}  // namespace

Mover make_mover(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts) {
    if (def.elastic) return elastic::Mover(def, std::move(nodes), cuts);
    return ftl::Mover(def, std::move(nodes), cuts);
}

TickReport tick(Mover& mover, const TickInput& input) {
    contact::State& state = state_of(mover);
    TickReport report;
    if (!is_finite(input)) {
        report.not_finite = true;
        report.fraction = 0;
        state.progress.assign(groups_of(input), 0);
        return report;
    }
    begin(state, input);
    std::visit(
        [&](auto& one) {
            one.tick(report);
            one.find_surface_forces();
        },
        mover);
    report.fraction = *std::min_element(state.progress.begin(), state.progress.end());
    report.stretch_max = worst_stretch(state, state.nodes);
    for (const contact::Row& row : state.rows)
        if (row.against == contact::Against::thread)
            report.separation_min = std::min(report.separation_min, row.distance / (2 * state.def.radius));
    return report;
}

}  // namespace sim::thread
