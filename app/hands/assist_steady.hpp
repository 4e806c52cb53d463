#pragma once
#include "app/hands/led.hpp"

namespace app::hands {

/// Assist "steady" of one instrument: a low pass of where it is asked to be.
class Steady {
  public:
    /// Begins where the tool is asked to be.
    void begin(const Pose& at) { at_ = at; }
    /// What a hand asks for, smoothed with a time constant of `tau` [s].
    Pose next(const Pose& asked, double seconds, double tau);
    const Pose& now() const { return at_; }  ///< What it said last.

  private:
    Pose at_;
};

}  // namespace app::hands
