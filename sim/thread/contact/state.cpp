#include "sim/thread/contact/state.hpp"

#include <cassert>
#include <cmath>

#include "sim/thread/contact/tolerances.hpp"

namespace sim::thread::contact {

static std::vector<double> lengths_of(const std::vector<Vec3>& nodes, std::span<const int> cuts) {
    assert(nodes.size() >= 2 && "a thread of at least one link");
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) lengths.push_back((nodes[i + 1] - nodes[i]).norm());
    for ([[maybe_unused]] const double length : lengths)
        assert(length > 0 && std::isfinite(length) && "links of some length, between finite nodes");
    for (const int cut : cuts) {
        assert(cut > 0 && static_cast<std::size_t>(cut) + 1 < lengths.size() && "a cut between two links");
        lengths[static_cast<std::size_t>(cut)] = 0;
    }
    return lengths;
}

std::size_t State::most_links() const {
    if (def.shortest_link <= 0) return rest_length.size();
    double length = 0;
    for (const double link : rest_length) length += link;
    // None is shorter by more than the root of two.
    return rest_length.size() + static_cast<std::size_t>(1.5 * length / def.shortest_link);
}

State::State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes, std::span<const int> cuts)
    : def(thread_def),
      nodes(std::move(start_nodes)),
      rest_length(lengths_of(nodes, cuts)),
      longest_link(1.001 * *std::max_element(rest_length.begin(), rest_length.end())),  // equal ones differ by rounding
      tension(rest_length.size(), 0.0) {
    assert(def.radius > 0 && def.friction >= 0 && def.friction_tool >= 0 && def.shortest_link >= 0);
    const std::size_t most = most_links();
    for (auto* of_nodes : {&nodes, &before}) of_nodes->reserve(most + 1);
    for (auto* of_links : {&rest_length, &arc, &inverse_mass, &bound, &tension}) of_links->reserve(most + 1);
    // What a knot pulled tight takes, with links no longer than the thread is thick; what takes more allocates.
    surface_forces.reserve(most);
    contacts.reserve(24 * most);
    rows.reserve(8 * most);
    size_for_links();
    if (def.elastic) def.elastic->radius = def.radius;
}

void State::size_for_links() {
    const std::size_t n = rest_length.size();
    arc.assign(1, 0.0);
    for (std::size_t k = 0; k < n; ++k)
        arc.push_back(arc.back() + (is_cut(k) ? looked_around * def.radius : rest_length[k]));
    before = nodes;
    inverse_mass.assign(n + 1, 1.0);
    bound.assign(n + 1, 0.0);
}

double worst_stretch(const State& state, const std::vector<Vec3>& nodes) {
    double worst = 0;
    for (std::size_t k = 0; k < state.rest_length.size(); ++k) {
        if (state.is_cut(k)) continue;
        const double length = (nodes[k + 1] - nodes[k]).norm();
        worst = std::max(worst, std::abs(length / state.rest_length[k] - 1));
    }
    return worst;
}

static Vec3 direction(const State& state, std::size_t link) {
    return (state.nodes[link + 1] - state.nodes[link]).stableNormalized();
}

double turn_at(const State& state, std::size_t node) {
    return state.is_end(node) ? 0 : (direction(state, node) - direction(state, node - 1)).norm();
}

}  // namespace sim::thread::contact
