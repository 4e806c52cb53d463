#include "app/window/graphics.hpp"

#include <SDL.h>

namespace app::window {

draw::Context& Graphics::context() {
    if (!context_) context_ = std::make_unique<draw::Context>(SDL_GL_GetProcAddress);
    return *context_;
}

draw::Canvas& Graphics::canvas() {
    if (!canvas_) canvas_ = std::make_unique<draw::Canvas>(context());
    return *canvas_;
}

}  // namespace app::window
