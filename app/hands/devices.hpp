#pragma once
#include <mutex>
#include <variant>
#include <vector>

#include "app/hands/assists.hpp"
#include "app/hands/bindings.hpp"
#include "app/hands/sight.hpp"

namespace app::hands {

/// A button of the mouse.
enum class Button { left, right, middle };

/// The mouse moved.
struct Motion {
    double right = 0, down = 0;  ///< [pixels]
};

/// The wheel turned.
struct Wheel {
    double notches = 0;       ///< Positive away from the person; part of one from smooth wheels.
    bool with_shift = false;  ///< Shift was held.
};

/// A button went down or up.
struct Click {
    Button button;  ///< Which it is.
    bool down;      ///< It went down.
};

/// An assist was switched.
struct Switch {
    Assist assist;  ///< Which it is.
    bool on;        ///< It is to help from now on.
};

/// All keys and buttons are up, and what they began ends: the window lost the keyboard, or the session was paused.
struct LetGo {};

/// What a device did.
struct Event {
    std::variant<Motion, Wheel, Click, Press, Switch, LetGo> what;  ///< One of these.
    double stamp_s = 0;                                             ///< When the window got it, by its own clock [s].
};

/// What has come since it was last taken.
struct Taken {
    std::vector<Event> events;  ///< In their order.
    Sight sight;                ///< The last that was posted.
};

/// The mailbox between the window's thread, which posts, and the tick thread, which takes.
class Devices {
  public:
    /// Leaves an event. Events that nobody takes are dropped beyond 10 000, the oldest first.
    void post(Event event);
    /// Says how the scene is seen from now on; once a frame.
    void look(const Sight& sight);
    /// Takes what has come; `taken` keeps its room, so that after some ticks nothing is allocated.
    void take(Taken& taken);

  private:
    std::mutex mutex_;
    std::vector<Event> events_;
    Sight sight_;
};

}  // namespace app::hands
