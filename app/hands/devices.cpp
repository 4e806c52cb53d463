#include "app/hands/devices.hpp"

#include <utility>

namespace app::hands {

void Devices::post(Event event) {
    constexpr std::size_t most = 10000;
    const std::scoped_lock lock(mutex_);
    if (events_.size() >= most) events_.erase(events_.begin());
    events_.push_back(std::move(event));
}

void Devices::look(const Sight& sight) {
    const std::scoped_lock lock(mutex_);
    sight_ = sight;
}

void Devices::take(Taken& taken) {
    taken.events.clear();
    const std::scoped_lock lock(mutex_);
    std::swap(events_, taken.events);
    taken.sight = sight_;
}

}  // namespace app::hands
