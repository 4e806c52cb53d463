#include "app/hands/rate_keys.hpp"

#include <algorithm>

namespace app::hands {

static_assert(static_cast<int>(Action::k_towards) == 5);

void RateKeys::press(const Press& press) {
    const auto key = static_cast<std::size_t>(press.action);
    if (key < held_s_.size()) held_s_[key] = press.down ? 0 : -1;
}

int RateKeys::up() const {
    return (held_s_[2] >= 0) - (held_s_[3] >= 0);
}

Step RateKeys::next(double seconds, bool turns, double share) {
    std::array<double, 6> ways{};
    for (std::size_t key = 0; key < ways.size(); ++key) {
        if (held_s_[key] < 0) continue;
        ways[key] = share * seconds * (slow + (fast - slow) * std::min(1.0, held_s_[key] / rise_s));
        held_s_[key] += seconds;
    }
    const Vec3 way(ways[1] - ways[0], ways[2] - ways[3], ways[5] - ways[4]);
    Step step;
    if (turns) {
        step.turn = turn * Vec3(-way.y(), way.x(), 0);
        step.roll = turn * way.z();
    } else {
        step.move = way;
    }
    return step;
}

}  // namespace app::hands
