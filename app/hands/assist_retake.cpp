#include "app/hands/assist_retake.hpp"

#include <algorithm>
#include <cmath>

#include "app/hands/assist_snap.hpp"

namespace app::hands {

// How far it is to the knot along the thread, negative towards the first node: halfway to the next that is held, which
// the knot is before, or to the middle of what is left.
static double way_to_knot(const World& world, int tool, int node) {
    const double here = along_thread(world, node);
    double nearest = 0;
    for (std::size_t i = 0; i < world.tools().size(); ++i)
        for (const auto& grasp : world.tools()[i].grasps) {
            const double way = along_thread(world, grasp.middle()) - here;
            if (static_cast<int>(i) != tool && (nearest == 0 || std::abs(way) < std::abs(nearest))) nearest = way;
        }
    if (nearest != 0) return nearest / 2;
    return along_thread(world, static_cast<int>(world.thread().size()) - 1) / 2 - here;
}

void Retake::begin(const World& world, int tool, Led& led) {
    const auto& grasps = world.tools()[static_cast<std::size_t>(tool)].grasps;
    if (grasps.empty()) return;
    constexpr double patience_s = 3;
    const int node = grasps.front().middle();
    along_ = along_thread(world, node) + std::clamp(way_to_knot(world, tool, node), -by, by);
    left_s_ = patience_s;
    led.jaw_goal = led.opening;
}

void Retake::tick(const World& world, int tool, Led& led, double seconds) {
    if (left_s_ <= 0) return;
    const auto& now = world.tools()[static_cast<std::size_t>(tool)];
    left_s_ -= seconds;
    const bool is_open = !now.closed && led.at.jaw == led.jaw_goal;
    if (!is_open && left_s_ > 0) return;
    if (left_s_ > 0 && !glide(led, now.shape, on_thread(world, along_).at, seconds)) return;
    led.jaw_goal = 0;
    left_s_ = 0;
}

}  // namespace app::hands
