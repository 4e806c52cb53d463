#pragma once
#include "app/hands/led.hpp"
#include "app/hands/strand.hpp"

namespace app::hands {

/// Assist "retake" of one instrument: it lets go of its strand, goes along it towards the knot, and takes it again.
class Retake {
  public:
    static constexpr double by = 8e-3;  ///< How much nearer to the knot, at most [m].

    /// Lets go, if it holds thread. The knot is towards the next instrument that holds the same thread, else where more
    /// of the thread is.
    void begin(const World& world, int tool, Led& led);
    /// What it does in the next `seconds`.
    void tick(const World& world, int tool, Led& led, double seconds);
    /// Whether it is under way.
    bool is_at_work() const { return left_s_ > 0; }

  private:
    double along_ = 0;   // of the place to be taken [m]
    double left_s_ = 0;  // of its patience
};

}  // namespace app::hands
