#pragma once
#include "app/hands/led.hpp"
#include "app/hands/strand.hpp"

namespace app::hands {

/// Assist "needle-wheel": where a tool is that turned the needle it holds by `angle` [rad] about the needle's own
/// circle, towards its tip. A tool that holds none, or does not lead it, stays where it is.
Pose turned_about_needle(const World& world, int tool, const Pose& pose, double angle);

}  // namespace app::hands
