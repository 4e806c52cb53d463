#pragma once
#include <memory>

#include "app/draw/canvas.hpp"

namespace app::window {

/// What draws scenes in the window; made when the first is drawn, so that the menu need not wait for its shaders.
class Graphics {
  public:
    draw::Context& context();  ///< The window's.
    draw::Canvas& canvas();    ///< On it.

  private:
    std::unique_ptr<draw::Context> context_;
    std::unique_ptr<draw::Canvas> canvas_;
};

}  // namespace app::window
