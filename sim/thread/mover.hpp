#pragma once
#include <variant>

#include "sim/thread/elastic/mover.hpp"
#include "sim/thread/ftl/mover.hpp"

// A thread's mover, one of two, and what is done with either.
namespace sim::thread {

/// What moves a thread: one of the two movers, each with all that it carries.
using Mover = std::variant<ftl::Mover, elastic::Mover>;

/// Makes the mover that ThreadDef::elastic asks for, of a thread as in contact::State's constructor.
Mover make_mover(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts);

/// What either mover carries.
inline contact::State& state_of(Mover& mover) {
    return std::visit([](auto& one) -> contact::State& { return one.state(); }, mover);
}
/// What either mover carries.
inline const contact::State& state_of(const Mover& mover) {
    return std::visit([](const auto& one) -> const contact::State& { return one.state(); }, mover);
}

/// The same as Thread::tick().
TickReport tick(Mover& mover, const TickInput& input);

}  // namespace sim::thread
