#pragma once
#include "app/hands/devices.hpp"
#include "app/hands/settings.hpp"
#include "app/hands/smooth.hpp"

namespace app::hands {

/// The mouse as a hand: pixels and notches, smoothed, to steps.
class Mouse {
  public:
    /// What the wheel turns.
    enum class WheelTo { depth, roll, needle };
    /// What comes out in one tick.
    struct Out {
        Step step;          ///< Of the tool.
        double needle = 0;  ///< Turn of the needle about its circle, towards its tip [rad].
    };

    /// A motion of the mouse, times `share` where hands move finely; turns the tool where `turns`.
    void add(const Motion& motion, bool turns, double share);
    /// Notches of the wheel, times `share`.
    void add_wheel(double notches, WheelTo to, double share);
    /// Of the next `seconds`, for a tool at `tool` [m].
    Out next(double seconds, const Settings& settings, const Sight& sight, const Vec3& tool);
    /// Forgets what has not come out.
    void drop() { smooth_.drop(); }

  private:
    // [pixels] right, down; the same of turns; [notches] away, roll, needle.
    Smooth<7> smooth_;
};

}  // namespace app::hands
