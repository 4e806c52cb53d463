#pragma once
#include <imgui.h>

#include <memory>

#include "app/draw/canvas.hpp"

namespace app::draw {
class Target;
}

namespace app::window {

/// A small picture beside the large one, drawn at most 15 times a second.
class Inset {
  public:
    Inset(draw::Context& context, int width, int height);
    ~Inset();

    int width() const { return width_; }    ///< In pixels.
    int height() const { return height_; }  ///< In pixels.
    /// Whether it is time to draw it anew, by a clock [s].
    bool is_due(double now_s) const { return now_s - drawn_s_ >= 1.0 / 15; }
    /// Draws it.
    void draw(draw::Canvas& canvas, const draw::Picture& picture, double now_s);
    /// For ImGui; its rows go upwards.
    ImTextureID id() const;

  private:
    const int width_, height_;
    double drawn_s_ = -1;
    std::unique_ptr<draw::Target> target_;
    draw::Context& context_;
};

}  // namespace app::window
