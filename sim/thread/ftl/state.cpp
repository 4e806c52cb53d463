#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

State::State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes, std::span<const int> cuts)
    : contact::State(thread_def, std::move(start_nodes), cuts) {
    const std::size_t most = most_links();
    for (auto* of_nodes : {&last.drift, &unfinished.nodes, &carried}) of_nodes->reserve(most + 1);
    for (auto* of_links : {&last.following, &pulled, &last.pulled}) of_links->reserve(most + 1);
    last.drift.resize(nodes.size(), Vec3::Zero());
    last.following.resize(nodes.size(), 1.0);
    last.wraps.reserve(most);
    on_steel.reserve(most);
    size_for_links();
}

void State::size_for_links() {
    contact::State::size_for_links();
    const std::size_t n = rest_length.size();
    unfinished.nodes = nodes;
    carried.resize(n + 1);
    for (auto* of_links : {&pulled, &last.pulled}) of_links->assign(n, 0.0);
    last.wraps.assign(n, {});
}

}  // namespace sim::thread::ftl
