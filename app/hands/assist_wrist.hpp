#pragma once
#include "app/hands/led.hpp"
#include "app/hands/strand.hpp"

namespace app::hands {

/// The rotation nearest to `rotation` with jaws square to a strand that goes `along`: their hinge's axis along it.
Quat square_to(const Quat& rotation, const Vec3& along);

/// `rotation` rolled about the shaft so that the jaws open across a strand that goes `along`; itself where that goes
/// nearly along the shaft.
Quat rolled_across(const Quat& rotation, const Vec3& along);

/// Assist "wrist" of one instrument: it keeps its turn in the picture, whatever the camera does, and its open jaws roll
/// square to the strand within 5 mm, the more the nearer: so the hand has only to move. The shaft does not swing: it
/// would sweep away the loops that lie round it.
class Wrist {
  public:
    static constexpr double reach = 5e-3;  ///< Strands nearer than this are followed [m].

    /// How it is turned now is how it stays in the picture.
    void keep(const Quat& rotation, const Sight& sight) { home_ = sight.turned.conjugate() * rotation; }
    /// Its person turned it by this step, which turns what is kept as well.
    void turn(const Step& step, const Sight& sight);
    /// Turns the tool in the next `seconds`, at 90 degrees a second at most. `near`: what its jaws would take.
    void tick(Led& tool, const std::optional<Takeable>& near, const Sight& sight, double seconds) const;

  private:
    Quat home_ = Quat::Identity();  // in the camera's axes
};

}  // namespace app::hands
