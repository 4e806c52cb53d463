#pragma once
#include <memory>

#include "app/draw/context.hpp"
#include "app/draw/picture.hpp"

namespace app::draw {

/// How much a picture may cost. At 1280 x 720 by software on one core: full 250 to 450 ms, light some 20 to 40 ms; on a
/// graphics card both are free.
enum class Level {
    full,   ///< Four samples a pixel, soft shadows, corners darkened: for pictures, and windows with a graphics card.
    light,  ///< One sample a pixel, one tap of the shadow, coarser round surfaces: for a window drawn by software.
};

/// Where a picture goes: its lower left pixel in a framebuffer of the context, 0 for the window's own. The light level
/// needs depth there.
struct Viewport {
    unsigned framebuffer = 0;
    int x = 0, y = 0;  ///< Pixels from the left and the lower edge.
};

/// What OpenGL holds for us. Making one compiles the shaders, so keep it. One thread at a time.
class Canvas {
  public:
    /// On a context of its own, in memory. Throws DrawError: OpenGL 3.3 is not to be had.
    Canvas();
    /// On this context, which must outlive it and be usable when it is made, used and destroyed.
    explicit Canvas(Context& context);
    ~Canvas();
    struct Gpu;  ///< canvas.cpp alone knows it.
    Gpu& gpu() { return *gpu_; }

  private:
    std::unique_ptr<Context> own_;
    std::unique_ptr<Gpu> gpu_;
};

/// Draws the picture, picture.width by picture.height pixels, opaque, and touches no pixel beside it. Leaves that
/// framebuffer bound and its viewport set, scissors, blending, culling and depth test off, no vertex array bound.
/// Throws DrawError: a size or a camera out of range.
void draw(Canvas& canvas, const Picture& picture, Level level, const Viewport& viewport);

/// The same, read back. The same picture gives the same bytes. Throws DrawError: a size or a camera out of range.
Image render(Canvas& canvas, const Picture& picture, Level level = Level::full);

}  // namespace app::draw
