// clang-format off
#include "app/draw/gl.hpp"  // first: what OSMesa includes knows fewer functions
#include <GL/osmesa.h>
// clang-format on
#include <gtest/gtest.h>

#include "tests/app/draw/scenes.hpp"

namespace {

using namespace scenes;

/// A context that somebody else has made and keeps current, as a window does.
class Elsewhere {
  public:
    Elsewhere()
        : context_(OSMesaCreateContextAttribs(
              std::vector<int>{OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                               OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3, 0}
                  .data(),
              nullptr)),
          pixels_(4u * width * height) {
        make_current();
    }
    ~Elsewhere() { OSMesaDestroyContext(context_); }
    void make_current() { OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height); }
    /// Makes all of it one grey, a quarter of the way to the far end.
    void fill(int grey) {
        const auto share = static_cast<float>(grey) / 255;
        reinterpret_cast<PFNGLCLEARCOLORPROC>(OSMesaGetProcAddress("glClearColor"))(share, share, share, 1);
        reinterpret_cast<PFNGLCLEARDEPTHPROC>(OSMesaGetProcAddress("glClearDepth"))(0.25);
        reinterpret_cast<PFNGLCLEARPROC>(OSMesaGetProcAddress("glClear"))(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        reinterpret_cast<PFNGLCLEARDEPTHPROC>(OSMesaGetProcAddress("glClearDepth"))(1);
    }
    /// Part of what the window shows, its lower left pixel first.
    Image shown(Gl& gl, int x, int y, int wide, int high) const {
        Image image{wide, high, std::vector<unsigned char>(3u * wide * high)};
        std::vector<unsigned char> upward(image.pixels.size());
        gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl.ReadPixels(x, y, wide, high, GL_RGB, GL_UNSIGNED_BYTE, upward.data());
        for (int row = 0; row < high; ++row)
            std::copy_n(upward.begin() + 3l * wide * (high - 1 - row), 3l * wide,
                        image.pixels.begin() + 3l * wide * row);
        return image;
    }
    static constexpr int width = 640, height = 400;

  private:
    OSMesaContext context_;
    std::vector<unsigned char> pixels_;
};

void* function(const char* name) {
    return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
}

void* no_framebuffers(const char* name) {
    return std::string(name) == "glGenFramebuffers" ? nullptr : function(name);
}

Picture picture_with_all_helps() {
    Picture picture = whole_picture();
    picture.helps.plumb = picture.helps.contact = picture.helps.strand = true;
    picture.helps.ring_tool = 1;
    picture.helps.tension = 0.5;
    picture.ghosts = {tool_at({4e-3, -2e-3, 5e-3}, 1)};
    return picture;
}

}  // namespace

// A window's picture is that of a report; and beside it, where a menu is, nothing changes.
TEST(Context, AWindowShowsWhatIsDrawnInMemory) {
    const Picture picture = picture_with_all_helps();
    Canvas memory;
    for (const Level level : {Level::light, Level::full}) {
        SCOPED_TRACE(level == Level::light ? "light" : "full");
        const Image in_memory = render(memory, picture, level);
        Elsewhere window;
        Context context(function);
        Canvas canvas(context);
        window.fill(77);
        draw(canvas, picture, level, {.framebuffer = 0, .x = 96, .y = 40});
        const Image seen = window.shown(context.gl(), 96, 40, picture.width, picture.height);
        EXPECT_LE(mean_difference(in_memory, seen), 2);
        EXPECT_LE(differing(in_memory, seen), picture.width * picture.height / 100);
        for (const auto& [x, y, wide, high] : {std::array{0, 0, 640, 40}, std::array{0, 0, 96, 400},
                                               std::array{576, 0, 64, 400}, std::array{0, 360, 640, 40}})
            for (const unsigned char value : window.shown(context.gl(), x, y, wide, high).pixels)
                ASSERT_EQ(value, 77) << "a pixel beside the picture";
        float depth = 0;
        context.gl().ReadPixels(5, 5, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
        EXPECT_NEAR(depth, 0.25, 1e-3) << "depth beside the picture";
    }
}

// What was drawn before must not show through, whatever state a menu's own drawing leaves behind.
TEST(Context, AFrameDependsOnNothingBeforeIt) {
    const Picture picture = picture_with_all_helps();
    Elsewhere window;
    Context context(function);
    Gl& gl = context.gl();
    Canvas canvas(context);
    const auto frame = [&] {
        draw(canvas, picture, Level::light, {});
        return window.shown(gl, 0, 0, picture.width, picture.height).pixels;
    };
    const auto first = frame();
    Picture other = picture;
    other.camera.position *= 1.3;
    draw(canvas, other, Level::light, {});
    gl.Enable(GL_BLEND);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 0, 10, 10);
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_FRONT);
    gl.DepthMask(GL_FALSE);
    gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    EXPECT_EQ(frame(), first);
}

// An old driver says what it lacks; a null pointer would be called in the first frame.
TEST(Context, AMissingFunctionIsNamed) {
    Elsewhere window;
    try {
        Context context(no_framebuffers);
        FAIL() << "made without glGenFramebuffers";
    } catch (const DrawError& error) {
        EXPECT_NE(std::string(error.what()).find("glGenFramebuffers"), std::string::npos) << error.what();
    }
}
