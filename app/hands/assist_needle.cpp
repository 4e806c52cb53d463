#include "app/hands/assist_needle.hpp"

namespace app::hands {

// By where the needle goes with the tool that is asked for, which may be ahead of the one in the world.
Pose turned_about_needle(const World& world, int tool, const Pose& pose, double angle) {
    for (const auto& needle : world.needles()) {
        if (needle.holder.tool != tool || angle == 0) continue;
        const auto arc = needle.led_by(pose);
        const Quat turn = rotation_of(angle * arc.to_tail.cross(arc.onwards).normalized());
        return {arc.centre + turn * (pose.position - arc.centre), (turn * pose.rotation).normalized()};
    }
    return pose;
}

}  // namespace app::hands
