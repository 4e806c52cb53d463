#pragma once
#include "app/hands/led.hpp"
#include "app/hands/strand.hpp"

namespace app::hands {

/// A step of open jaws towards a place [m] so that it comes to lie between them: first back where it lies beside them,
/// then sideways, then onto it; at 20 mm/s at most. True once it lies there; then nothing moves.
bool glide(Led& tool, const instruments::ToolShape& shape, const Vec3& to, double seconds);

/// Assist "snap" of one instrument: jaws that are told to shut near something glide there first.
class Snap {
  public:
    static constexpr double reach = 3e-3;    ///< What is nearer than this is lit [m].
    static constexpr double speed = 20e-3;   ///< Of gliding, at most [m/s].
    static constexpr double patience_s = 1;  ///< Then jaws shut where they are.

    /// Its jaws were told to shut on what is lit: they stay open until they are there.
    void begin(Led& tool);
    /// Glides in the next `seconds`; `lit` is what the jaws would take now.
    void tick(Led& tool, const instruments::ToolShape& shape, const std::optional<Takeable>& lit, double seconds);

  private:
    double left_s_ = 0;  // of its patience
};

}  // namespace app::hands
