#include "app/window/open.hpp"

#include <algorithm>

#include "app/fault.hpp"
#include "app/window/graphics.hpp"
#include "app/window/menu.hpp"
#include "app/window/play_screen.hpp"
#include "app/window/shelf.hpp"
#include "app/window/theme.hpp"

namespace app::window {

namespace {

bool is_tab(const SDL_Event& event) {
    return event.type == SDL_KEYDOWN && event.key.keysym.scancode == SDL_SCANCODE_TAB;
}

void handle(Shell& shell, Screen& screen, const SDL_Event& event) {
    if (event.type == SDL_QUIT) shell.is_over = true;
    if (screen.handle(shell, event)) return;
    if (event.type == SDL_KEYDOWN && event.key.keysym.scancode == SDL_SCANCODE_F11) shell.window.toggle_full_screen();
    if (is_tab(event))
        shell.ui.move_focus(event.key.keysym.mod & KMOD_SHIFT ? -1 : 1);
    else
        shell.window.give_controls(event);
}

// At rest a frame now and then is enough: pictures of drills come by themselves. What moves has at most 60 frames a
// second, and every event that came until the next one is drawn.
void take_events(Shell& shell, Screen& screen, double last_frame_s) {
    const double left_s = last_frame_s + 1.0 / 60 - now_s();
    const int wait_ms = screen.is_moving() ? std::max(0, static_cast<int>(1e3 * left_s)) : 50;
    SDL_Event event;
    if (screen.is_moving() && wait_ms > 0) SDL_Delay(static_cast<unsigned>(wait_ms));
    if (!shell.window.next_event(event, screen.is_moving() ? 0 : wait_ms)) return;
    // Who closes the window does not wait for every key that is still to have its frame.
    shell.is_over |= SDL_HasEvent(SDL_QUIT) == SDL_TRUE;
    // Controls see keys once a frame: one that is pressed and let go between two frames would be lost.
    const auto needs_frame = [&] { return event.type == SDL_KEYDOWN && !shell.window.pointer_is_caught(); };
    do handle(shell, screen, event);
    while (!needs_frame() && shell.window.next_event(event, 0));
}

void draw_frame(Shell& shell, Screen& screen) {
    shell.window.begin();
    shell.ui.begin(screen.name(), shell.window.width(), shell.window.height());
    screen.draw(shell);
    shell.ui.end();
    shell.window.end();
}

// What the command line asks for at once; a drill that cannot be played ends the program with its line.
std::unique_ptr<Screen> first_screen(Shell& shell) {
    if (shell.options.drill.empty()) return std::make_unique<Menu>();
    return std::make_unique<PlayScreen>(shell, shell.options.drill);
}

void run(Shell& shell) {
    std::unique_ptr<Screen> screen = first_screen(shell);
    while (!shell.is_over) {
        const double begin_s = now_s();
        shell.window.set_scale(shell.settings.scale);
        draw_frame(shell, *screen);
        take_events(shell, *screen, begin_s);
        if (!shell.next) continue;
        screen->close(shell);
        screen = std::move(shell.next);
        shell.shelf.pause(screen->is_moving());
        shell.ui.forget_focus();
    }
    screen->close(shell);
}

}  // namespace

void open(const PlayOptions& options) {
    std::string problem;
    Settings settings = load_settings(places().settings, problem);
    if (!options.drill.empty()) settings.is_exam = options.exam;
    Ui ui(options.ui_dump);
    SceneDump scene_dump(options.scene_dump);
    Window window(settings.scale);
    Places where = places();
    if (!options.recordings.empty()) where.recordings = options.recordings;
    Shelf shelf(where, settings, options.drills);
    Graphics graphics;
    Shell shell{window, ui, settings, shelf, graphics, scene_dump, options, where, problem};
    run(shell);
}

}  // namespace app::window
