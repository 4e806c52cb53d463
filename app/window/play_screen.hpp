#pragma once
#include "app/draw/canvas.hpp"
#include "app/window/ghost.hpp"
#include "app/window/input.hpp"
#include "app/window/inset.hpp"
#include "app/window/level.hpp"
#include "app/window/orbit.hpp"
#include "app/window/player.hpp"
#include "app/window/screen.hpp"

namespace app::window {

/// What is shown beside the scene, as the person switched it.
struct Shown {
    bool guide = true, ghost = true, second_camera = true, keys = false, follow = false;
};

/// How fast pictures come and how old they are, over the last second.
class FrameMeter {
  public:
    /// A frame was shown [s]; how long after a device's event, if it is the first that shows one [s]. True: a second is
    /// whole.
    bool add(double now_s, std::optional<double> latency_s);
    int frames_per_s() const { return frames_; }    ///< In the last whole second.
    int latency_ms() const { return latency_ms_; }  ///< From a device to the picture, the mean of a second; -1: none.

  private:
    double begin_s_ = 0, sum_s_ = 0;
    int count_ = 0, events_ = 0, frames_ = 0, latency_ms_ = -1;
};

/// The screen on which a drill is played.
class PlayScreen : public Screen {
  public:
    /// Opens a drill. Throws what a bad drill throws, and std::runtime_error where it cannot be recorded.
    PlayScreen(Shell& shell, const std::filesystem::path& drill);

    const char* name() const override { return "play"; }
    void draw(Shell& shell) override;
    bool handle(Shell& shell, const SDL_Event& event) override;
    bool is_moving() const override { return true; }
    void close(Shell& shell) override;

  private:
    enum class State { before, playing, paused };

    bool act(Shell& shell, hands::Action action);
    Heeds heeds() const;
    void lead_camera(const SDL_Event& event, const Shell& shell);
    void begin(Shell& shell);
    void pause();
    void go_on();
    void change_pace(double factor);
    void ask_pace(double pace);
    void restart(Shell& shell);
    void finish(Shell& shell);
    bool is_exam() const { return player_->options().is_exam; }

    void note_frame();
    void await_hands();
    void draw_scene(Shell& shell, const View& view, const hands::HandsView& hands);
    void save_picture(Shell& shell, const draw::Picture& picture, double t_s);
    void draw_inset(Shell& shell, const View& view);
    void draw_panels(Shell& shell, const View& view, const hands::HandsView& hands);
    void draw_before(Shell& shell);
    void draw_paused(Shell& shell);
    void draw_actions(Shell& shell);
    void draw_switches(Shell& shell);
    draw::Picture picture_of(const View& view, const hands::HandsView& hands, int width, int height);

    std::shared_ptr<Player> player_;
    hands::Bindings bindings_;
    Input input_{bindings_};
    Ghost ghost_;
    std::unique_ptr<Inset> inset_;
    std::optional<Orbit> orbit_;
    Shown shown_;
    DrawingLevel level_;
    State state_ = State::before;
    double pace_ = 1, asked_pace_ = 1;
    hands::Assists assists_;
    bool wants_picture_ = false;
    FrameMeter frames_;
    std::optional<double> drawn_device_s_, shown_device_s_;
};

/// A play screen for this drill; where it cannot be opened the shell's notice says why, and there is none.
std::unique_ptr<Screen> open_drill(Shell& shell, const std::filesystem::path& drill);

}  // namespace app::window
