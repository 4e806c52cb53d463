#include "sim/thread/elastic/state.hpp"

namespace sim::thread::elastic {

State::State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes, std::span<const int> cuts)
    : contact::State(thread_def, std::move(start_nodes), cuts), rod(*def.elastic, nodes), watched(nodes) {
    const std::size_t most = most_links();
    for (const int cut : cuts) rod.leave_out(static_cast<std::size_t>(cut), static_cast<std::size_t>(cut) + 1);
    rod.resize();
    rod.reserve(most);
    asleep.assign(nodes.size(), 0);
    watched.reserve(most + 1), asleep.reserve(most + 1), sleeping.reserve(2 * most);
    pressed.reserve(2 * most);
}

}  // namespace sim::thread::elastic
