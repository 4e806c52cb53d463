#pragma once
#include <cstdint>

#include "sim/thread/mover.hpp"

namespace sim::thread {

/// The same as Thread::hash().
std::uint64_t hash_of(const Mover& mover);
/// The same as Thread::hash_of_all_carried().
std::uint64_t hash_of_all_carried(const Mover& mover);

}  // namespace sim::thread
