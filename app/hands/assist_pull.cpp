#include "app/hands/assist_pull.hpp"

#include <algorithm>
#include <cmath>

namespace app::hands {

void PullBoth::change_speed(double steps) {
    speed_ = std::clamp(speed_ * std::pow(1.25, steps), slow, fast);
}

// The tension of `ftl` is told from how far hands are ahead of their tools, and falls to nothing where these stand
// still: so hands are held by both, the tension and the lead.
void PullBoth::tick(const World& world, int one, int other, Led& led_one, Led& led_other, double stop_N,
                    double seconds) {
    const auto& tools = world.tools();
    const auto &tool_one = tools[static_cast<std::size_t>(one)], &tool_other = tools[static_cast<std::size_t>(other)];
    if (tool_one.grasps.empty() || tool_other.grasps.empty()) return;
    constexpr double forgets_s = 0.05;
    tension_N_ = std::max(world.tension_now(), tension_N_ * (1 - seconds / forgets_s));
    const double share = std::clamp(2 * (1 - tension_N_ / stop_N), 0.0, 1.0);
    const Vec3 apart = (led_one.at.pose.position - led_other.at.pose.position).normalized();
    led_one.at.pose.position += share * speed_ * seconds * apart;
    led_other.at.pose.position -= share * speed_ * seconds * apart;
}

}  // namespace app::hands
