#pragma once
#include <SDL.h>

#include <functional>

#include "app/hands/devices.hpp"

namespace app::window {

/// Who gets what devices do.
enum class Heeds {
    hands,   ///< Mouse and keys lead the hands.
    free,    ///< The pointer is free: of the hands' keys only that which gives it back.
    window,  ///< A page is open: hands get nothing.
};

/// Turns what SDL says of mouse and keys into what the hands take and what the window does itself.
class Input {
  public:
    /// bindings: which key asks for what; outlives it, and may change.
    explicit Input(const hands::Bindings& bindings) : bindings_(bindings) {}

    /// Hands take an event, if it is theirs and they are heeded; returns what a key asks of the window, if it does.
    std::optional<hands::Press> take(const SDL_Event& event, Heeds heeds, hands::Devices& devices);
    /// All keys are up: the window lost the keyboard, or the session was paused.
    void let_go(hands::Devices& devices);
    /// Whether the middle button is down: the mouse leads the camera.
    bool leads_camera() const { return leads_camera_; }
    /// When the hands were left something last [s]; 0: never.
    double newest_s() const { return newest_s_; }

  private:
    std::optional<hands::Press> take_key(const SDL_Event& event, Heeds heeds, hands::Devices& devices);
    void take_mouse(const SDL_Event& event, hands::Devices& devices);
    void post(hands::Devices& devices, decltype(hands::Event::what) what);

    const hands::Bindings& bindings_;
    hands::Keyboard keyboard_;
    bool leads_camera_ = false;
    double newest_s_ = 0;
};

}  // namespace app::window
