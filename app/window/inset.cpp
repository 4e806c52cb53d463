#include "app/window/inset.hpp"

#include "app/draw/gl.hpp"

namespace app::window {

Inset::Inset(draw::Context& context, int width, int height)
    : width_(width),
      height_(height),
      target_(std::make_unique<draw::Target>(context.gl(), width, height, true)),
      context_(context) {
    context_.gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
}

Inset::~Inset() = default;

void Inset::draw(draw::Canvas& canvas, const draw::Picture& picture, double now_s) {
    draw::draw(canvas, picture, draw::Level::light, {target_->frame(), 0, 0});
    context_.gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
    drawn_s_ = now_s;
}

ImTextureID Inset::id() const {
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(target_->color));
}

}  // namespace app::window
