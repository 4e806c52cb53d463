#pragma once
#include "app/window/orbit.hpp"
#include "app/window/player.hpp"
#include "app/window/screen.hpp"

// What stands on the scene while a drill is played: words, bars and marks, none of which takes the mouse.
namespace app::window {

/// A place at the edge of the screen: the share of width and height where a panel's own same share lies.
struct Corner {
    float x, y;
};

/// Begins a panel that takes no input, at a corner; end_panel() ends it.
void begin_panel(const Shell& shell, const char* name, Corner corner, float width = 0, float down = 0);
/// Ends it.
void end_panel();

/// Which step is to be done, with the one before, ticked off, and the one after.
void draw_guide(Shell& shell, const scenarios::drill::Drill& drill, const GuideView& guide);

/// Seconds, pace, latency, frames and whether the recording is safe; `down`: how far below the upper edge [pixels].
struct StatusLine {
    double t_s, limit_s;                 ///< Simulated time, and when the drill ends [s].
    double pace, aimed_at;               ///< Measured, and what it should be.
    int frames_per_s, latency_ms;        ///< Latency -1: unknown.
    bool is_exam, is_paused;             ///< Whether it is.
    std::optional<std::string> trouble;  ///< Why the recording is not safe.
};
void draw_status(Shell& shell, const StatusLine& status, float down);

/// What each instrument holds and who leads it; returns how high the panel is [pixels].
float draw_tools(Shell& shell, const View& view, const hands::HandsView& hands);

/// Tension against its band, and the knot so far; `up`: how far above the lower edge [pixels].
void draw_tension(Shell& shell, const View& view, const scenarios::drill::Drill& drill, float up);

/// Whether panels have room beside each other along the lower edge.
bool is_wide(const Shell& shell);

/// At the jaws: who leads them.
void draw_marks(Shell& shell, const draw::Picture& picture, const View& view, const hands::HandsView& hands);

/// A knot's name for people: what surgeons call it, or how far it has come.
std::string knot_words(const std::string& knot);

}  // namespace app::window
