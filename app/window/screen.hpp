#pragma once
#include <SDL.h>

#include <memory>

#include "app/window/scene_dump.hpp"
#include "app/window/settings.hpp"
#include "app/window/ui.hpp"
#include "app/window/window.hpp"

namespace app {
struct PlayOptions;
}

namespace app::window {

class Graphics;
class Screen;
class Shelf;

/// What all screens share.
struct Shell {
    Window& window;
    Ui& ui;
    Settings& settings;
    Shelf& shelf;
    Graphics& graphics;
    SceneDump& scene_dump;
    const PlayOptions& options;         ///< As the command line has them.
    Places where;                       ///< Where things lie; recordings as --recordings says.
    std::string notice;                 ///< What went wrong, shown until it is put away.
    int attempts = 0;                   ///< Begun since the program was opened.
    std::unique_ptr<Screen> next = {};  ///< Shown from the next frame on.
    bool is_over = false;               ///< The program ends.

    /// Keeps the settings; what goes wrong becomes the notice.
    void save() { notice = save_settings(where.settings, settings); }
};

/// One of the screens: menu, play, result, settings.
class Screen {
  public:
    virtual ~Screen() = default;
    /// Its name, for the dump of the controls.
    virtual const char* name() const = 0;
    /// Draws a frame and does what was asked for.
    virtual void draw(Shell& shell) = 0;
    /// An event, before the controls have it; true: they shall not have it.
    virtual bool handle(Shell&, const SDL_Event&) { return false; }
    /// Whether it moves by itself, so that frames follow each other without waiting for an event.
    virtual bool is_moving() const { return false; }
    /// The person leaves; finishes what is begun.
    virtual void close(Shell&) {}
};

}  // namespace app::window
