#pragma once
#include <cstdint>

#include "sim/thread/mover.hpp"

namespace sim::thread {

/// As Thread::hash().
std::uint64_t hash_of(const Mover& mover);
/// As Thread::hash_of_all_carried().
std::uint64_t hash_of_all_carried(const Mover& mover);

}  // namespace sim::thread
