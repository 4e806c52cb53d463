#pragma once
#include <array>

#include "app/hands/bindings.hpp"
#include "app/hands/sight.hpp"

namespace app::hands {

/// Keys as a hand: each moves or turns it at a rate that rises while the key is held. Rates are of simulated time.
class RateKeys {
  public:
    static constexpr double slow = 20e-3;  ///< As a key goes down [m/s].
    static constexpr double fast = 60e-3;  ///< Once it has been held for `rise_s` [m/s].
    static constexpr double rise_s = 0.5;  ///< [s]
    static constexpr double turn = 40;     ///< Turns are by this times as much [rad/m].

    /// A key of the key hand goes down or up; others are left alone.
    void press(const Press& press);
    /// Of the next `seconds`.
    Step next(double seconds, bool turns, double share);
    /// All keys are up.
    void let_go() { held_s_.fill(-1); }
    /// Up minus down: -1, 0 or 1.
    int up() const;

  private:
    std::array<double, 6> held_s_{-1, -1, -1, -1, -1, -1};  // as Action::k_left and on; -1: up
};

}  // namespace app::hands
