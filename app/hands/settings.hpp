#pragma once
#include "app/hands/assists.hpp"

namespace app::hands {

/// How a person wants to lead the hands.
struct Settings {
    double scale = 1;           ///< Of moves, not of turns: 1/4, 1/3, 1/2, 1 or 2; 1: as on the screen.
    double wheel = 0.5e-3;      ///< A notch along the line of sight [m].
    double turn = 0.007;        ///< By a pixel [rad].
    double roll = 0.087;        ///< By a notch [rad].
    double needle = 0.052;      ///< Of the needle, by a notch [rad].
    double smoothing_s = 8e-3;  ///< Time constant of the mouse's smoothing [s].
    double steady_s = 80e-3;    ///< Time constant of the assist "steady" [s].
    double pull_stop_N = 0.5;   ///< Where "pull both" stops [N].
    bool holds_jaw = false;     ///< Jaws are shut while their button is held; else they stay until the next press.
    bool left_handed = false;   ///< The mouse leads the left instrument.
    bool one_handed = false;    ///< For the mouse alone: its middle button swaps hands; holds are toggles.
    bool toggles = false;       ///< What is held otherwise begins with a press and ends with the next.
    bool is_exam = false;       ///< No assist helps.
    Assists assists;            ///< That help from the start.
};

}  // namespace app::hands
