#include "sim/thread/ftl/rubbed.hpp"

#include <algorithm>

#include "sim/geometry/at.hpp"

namespace sim::thread::ftl {

void find_rubbed(const State& state, std::vector<double>& rubbed) {
    rubbed.assign(state.rest_length.size(), -1.0);
    for (const Row& row : state.rows)
        if (is_touched(state, row))
            for (const int link : {row.link, row.against == Against::thread ? row.other : row.link})
                rubbed[at(link)] = std::max(rubbed[at(link)], row.friction);
}

std::size_t last_rubbed(const std::vector<double>& rubbed, const Tail& tail) {
    std::size_t node = tail.end;
    while (node != tail.held && rubbed[tail.link_to(node)] < 0) node = tail.before(node);
    return node;
}

}  // namespace sim::thread::ftl
