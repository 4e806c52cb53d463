#pragma once
#include <vector>

#include "sim/thread/ftl/tail.hpp"

namespace sim::thread::ftl {

/// Puts into `rubbed`, per link, the friction coefficient of what it touches, -1 where that is nothing. O(n + rows).
void find_rubbed(const State& state, std::vector<double>& rubbed);
/// The node farthest from a tail's hold whose link to it is rubbed; the held one where none is.
std::size_t last_rubbed(const std::vector<double>& rubbed, const Tail& tail);

}  // namespace sim::thread::ftl
