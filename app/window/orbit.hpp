#pragma once
#include "app/draw/picture.hpp"

namespace app::window {

/// A camera that a person leads about what it looks at.
class Orbit {
  public:
    /// Begins at the drill's view.
    explicit Orbit(const draw::Camera& home) : home_(home), now_(home) {}

    /// Where it is.
    const draw::Camera& camera() const { return now_; }
    /// One that looks at the same place from a quarter turn aside.
    draw::Camera from_aside() const;
    /// Turns about the target: by so many pixels to the right and down, half a degree each.
    void turn(double right, double down);
    /// Shifts eye and target so that what is looked at goes with the pointer, in a picture of this height [pixels].
    void shift(double right, double down, double height);
    /// Comes nearer by a tenth for each notch, goes away for negative ones.
    void zoom(double notches);
    /// Back to the drill's view.
    void go_home() { now_ = home_; }
    /// Looks at the same place from a side: towards the eye, any length, z is up.
    void look_from(const draw::Vec3& towards);
    /// Looks at this place from now on, from where it looked before [m].
    void look_at(const draw::Vec3& place);

  private:
    draw::Camera home_, now_;
};

}  // namespace app::window
