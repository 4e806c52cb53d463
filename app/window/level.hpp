#pragma once
#include <string>

namespace app::window {

/// How the scene is drawn: full with a graphics card that is fast enough for it, else light. What a person switches
/// stays; what is too slow becomes light and stays so, for a level that comes and goes would flicker.
class DrawingLevel {
  public:
    /// renderer: as OpenGL calls itself; Mesa's software renderers take half a second for a full picture.
    explicit DrawingLevel(const std::string& renderer) {
        for (const char* slow : {"llvmpipe", "softpipe", "swrast"})
            if (renderer.find(slow) != std::string::npos) is_full_ = false;
    }
    /// So many frames were drawn in a second.
    void add_second(int frames) {
        constexpr int enough = 30;
        if (!is_switched_ && frames < enough) is_full_ = false;
    }
    /// The person wants the other.
    void toggle() { is_full_ = !is_full_, is_switched_ = true; }
    bool is_full() const { return is_full_; }  ///< Else light.

  private:
    bool is_full_ = true, is_switched_ = false;
};

}  // namespace app::window
