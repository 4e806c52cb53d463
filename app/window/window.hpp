#pragma once
#include <SDL.h>

#include <stdexcept>
#include <string>

struct ImFont;

namespace app::window {

/// There is no display, or no OpenGL 3.3 on it.
struct NoWindow : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Sizes of letters on every screen, made of one font.
struct Fonts {
    ImFont *text, *bold, *title, *small;  ///< Each at its size times the scale.
};

/// The one window: SDL's, with OpenGL 3.3 and Dear ImGui in it. Main thread only.
class Window {
  public:
    /// Opens it, 1280 x 720 or as large as the screen allows. scale: of letters and all that goes with them, 0.75 to
    /// 2.5. Throws NoWindow.
    explicit Window(double scale);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// The next event, waiting for one at most so many milliseconds; false when there is none.
    bool next_event(SDL_Event& event, int wait_ms);
    /// Hands an event to the controls on the screen.
    void give_controls(const SDL_Event& event);
    /// Begins a frame: clears the picture.
    void begin();
    /// Draws the controls of this frame and shows it.
    void end();

    /// Letters anew at another scale, from the next frame on.
    void set_scale(double scale);
    /// Whether the pointer is a hand's: hidden, held in the window and read as motion alone.
    void catch_pointer(bool is_caught);
    /// Whether it is.
    bool pointer_is_caught() const { return is_caught_; }
    /// Fills the screen, or no longer.
    void toggle_full_screen();

    int width() const { return width_; }                       ///< Of what is drawn in [pixels].
    int height() const { return height_; }                     ///< Of what is drawn in [pixels].
    double scale() const { return scale_; }                    ///< Of letters.
    const Fonts& fonts() const { return fonts_; }              ///< At this scale.
    const std::string& renderer() const { return renderer_; }  ///< What OpenGL calls itself.

  private:
    void open();
    void make_fonts();

    SDL_Window* window_ = nullptr;
    SDL_GLContext context_ = nullptr;
    std::string renderer_;
    Fonts fonts_{};
    double scale_;
    int width_ = 0, height_ = 0;
    bool is_caught_ = false, has_new_scale_ = true;
};

}  // namespace app::window
