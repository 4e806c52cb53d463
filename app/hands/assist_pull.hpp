#pragma once
#include "app/hands/led.hpp"
#include "app/hands/strand.hpp"

namespace app::hands {

/// Assist "pull both": two hands that hold thread pull apart along the line between them, and stop where the thread
/// carries the tension that is set. They slow down as it rises, and give way where it rises beyond.
class PullBoth {
  public:
    static constexpr double slow = 2e-3, fast = 30e-3;  ///< Speeds that can be chosen, of each hand [m/s].

    /// Chooses another speed: so many steps faster, or slower.
    void change_speed(double steps);
    /// Of the next `seconds`; `stop_N` is the tension set, above 0. Hands that do not both hold thread stay.
    void tick(const World& world, int one, int other, Led& led_one, Led& led_other, double stop_N, double seconds);
    /// Forgets what it knows of the thread's tension; as it begins.
    void begin() { tension_N_ = 0; }

  private:
    double speed_ = 10e-3;  // of each hand [m/s]
    double tension_N_ = 0;  // of the thread, smoothed
};

}  // namespace app::hands
