#pragma once
#include "tests/app/hands/player.hpp"

// How a person goes about shipped drills, as goals in the world.
namespace app::hands {

/// The drill's own motion, but the tail is laid down farther from the vessel, where the second throw has more room.
/// `pulls_both`: the knot is pulled tight by the assist of this name.
std::vector<Goal> square_knot(const scenarios::drill::Motion& motion, bool pulls_both);

}  // namespace app::hands
