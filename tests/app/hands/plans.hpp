#pragma once
#include "tests/app/hands/player.hpp"

// How a person goes about shipped drills, as goals in the world.
namespace app::hands {

/// The drill's own motion, but the tail is laid down farther from the vessel, where the second throw has more room.
/// `pulls_both`: the knot is pulled tight by the assist of this name.
std::vector<Goal> square_knot(const scenarios::drill::Motion& motion, bool pulls_both);

/// One bite through both walls: the mouse has the needle holder and drives the needle by the wheel, keys have the
/// forceps, which back the left edge and then take the needle by its tip; hands are swapped to draw it out.
std::vector<Goal> single_bite();

}  // namespace app::hands
