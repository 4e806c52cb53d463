#include "app/draw/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/draw/camera.hpp"
#include "app/draw/gl.hpp"
#include "app/draw/light_shaders.hpp"
#include "app/draw/scene.hpp"
#include "app/draw/shaders.hpp"

namespace app::draw {

namespace {

/// A scene that stays as it is, and where it is.
struct Fixed {
    Fixed(Gl& gl, const Scene& scene) : buffers(gl), parts(scene.parts), count(scene.surface.indices.size()) {
        buffers.fill(scene.surface);
    }
    Buffers buffers;
    std::vector<Part> parts;
    std::size_t count;
};

/// Depth as the key light sees it.
struct Shadow : Target {
    Shadow(Gl& gl, int size, int filter, int kind) : Target(gl, size, size, false, kind) {
        gl.BindTexture(GL_TEXTURE_2D, depth);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        constexpr float lit[] = {1, 1, 1, 1};  // beyond what it covers
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
        gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
    }
};

/// What a look is drawn with.
struct Material {
    Vec3 base;  ///< Share of red, green and blue light sent back.
    float gloss, sharpness, wrap, vignette;
};
const Material materials[] = {{{0.60, 0.085, 0.075}, 0.40f, 45, 0.25f, 0},  // flesh
                              {{0.02, 0.07, 0.52}, 0.55f, 50, 0, 0},        // suture
                              {{0.80, 0.82, 0.84}, 0.50f, 90, 0, 0},        // steel
                              {{0.30, 0.46, 0.42}, 0, 1, 0, 0.2f}};         // cloth
const Material& material_of(Look look) {
    return materials[static_cast<std::size_t>(look)];
}

Scene cloth_scene() {
    Scene scene;
    scene.add(cloth(), Look::cloth);
    return scene;
}

std::string light(const char* fragment) {
    return std::string(light_shaders::lamps) + fragment;
}

constexpr int fine_shadow = 2048, coarse_shadow = 1024;  // the former as in the shader

}  // namespace

struct Canvas::Gpu {
    Context& context;
    Gl& gl = context.gl();
    Program solid{gl, shaders::solid_vertex, shaders::solid_fragment};  // of suture and cloth
    Program flesh{gl, shaders::solid_vertex, shaders::solid_fragment, "#define FLESH\n"};
    Program steel{gl, shaders::solid_vertex, shaders::solid_fragment, "#define STEEL\n"};
    Program shadow_caster{gl, shaders::solid_vertex, shaders::nothing_fragment};
    Program ghost{gl, shaders::solid_vertex, shaders::ghost_fragment};
    Program mark{gl, shaders::solid_vertex, shaders::mark_fragment};
    Program background{gl, shaders::screen_vertex, shaders::background_fragment};
    Program final{gl, shaders::screen_vertex, shaders::final_fragment};
    Program light_matt{gl, light_shaders::vertex, light(light_shaders::matt_fragment)};
    Program light_steel{gl, light_shaders::vertex, light(light_shaders::steel_fragment)};
    Program light_flesh{gl, light_shaders::vertex, light(light_shaders::matt_fragment), "#define FLESH\n"};
    Program cloth{gl, light_shaders::cloth_vertex, light_shaders::cloth_fragment};
    Program cast{gl, light_shaders::cloth_vertex, light_shaders::cloth_fragment, "#define CASTS\n"};
    Scene scene;  // kept for its room
    Buffers moving{gl}, marks{gl};
    Fixed drape{gl, cloth_scene()};
    std::unique_ptr<Shadow> shadows[2];    // of each level
    std::unique_ptr<Fixed> tools[2][4];    // of each level and kind
    std::unique_ptr<Target> fine, result;  // twice the picture's width and height; the picture

    explicit Gpu(Context& drawn_with) : context(drawn_with) {}

    const Shadow& shadow(Level level) {
        auto& shadow = shadows[static_cast<std::size_t>(level)];
        if (!shadow)
            shadow = level == Level::full
                         ? std::make_unique<Shadow>(gl, fine_shadow, GL_LINEAR, GL_DEPTH_COMPONENT32F)
                         : std::make_unique<Shadow>(gl, coarse_shadow, GL_NEAREST, GL_DEPTH_COMPONENT16);
        return *shadow;
    }
    const Fixed& tool(instruments::Kind kind, Level level) {
        auto& tool = tools[static_cast<std::size_t>(level)][static_cast<std::size_t>(kind)];
        if (!tool) tool = std::make_unique<Fixed>(gl, tool_scene(kind, level));
        return *tool;
    }
};

Canvas::Canvas() : own_(memory_context()), gpu_(std::make_unique<Gpu>(*own_)) {}
Canvas::Canvas(Context& context) {
    context.make_current();
    gpu_ = std::make_unique<Gpu>(context);
}
Canvas::~Canvas() {
    gpu_->context.make_current();
}

namespace {

using Gpu = Canvas::Gpu;

void resize(Gpu& gpu, std::unique_ptr<Target>& target, int width, int height) {
    if (!target || target->width != width || target->height != height)
        target = std::make_unique<Target>(gpu.gl, width, height, true);
}

/// The camera's view of a picture, and the lamps, which go with the camera: the key over its left shoulder, the fill
/// low on the right, the rim behind.
struct View {
    Eigen::Matrix4d clip_from_world, shadow_from_world;
    Vec3 eye, to_key, to_fill, to_rim, up;
    double shadow_half;  ///< Half of what the shadow covers [m].
};

/// Square to the key light about what the camera looks at; deep enough for all that could cast a shadow there.
Eigen::Matrix4d shadow_from_world(const Vec3& target, const Vec3& to_key, double half) {
    const Vec3 x = to_key.unitOrthogonal();
    Eigen::Matrix4d shadow = Eigen::Matrix4d::Identity();
    shadow.row(0).head<3>() = x / half;
    shadow.row(1).head<3>() = to_key.cross(x) / half;
    shadow.row(2).head<3>() = -to_key / (4 * half);
    shadow.topRightCorner<3, 1>() = -shadow.topLeftCorner<3, 3>() * target;
    return shadow;
}

View view_of(const Picture& picture) {
    const Camera& camera = picture.camera;
    const Eigen::Matrix3d axes = axes_of(camera);
    const auto towards = [&](double right, double up, double back) -> Vec3 {
        return axes.transpose() * Vec3(right, up, back).normalized();
    };
    View view{clip_from_world(camera, static_cast<double>(picture.width) / picture.height),
              {},
              camera.position,
              towards(-0.45, 0.85, 0.65),
              towards(0.9, -0.1, 0.6),
              towards(0.4, 0.5, -0.8),
              towards(0, 1, 0),
              1.8 * half_height(camera) * (camera.position - camera.target).norm()};
    view.shadow_from_world = shadow_from_world(camera.target, view.to_key, view.shadow_half);
    return view;
}

/// The parts that `wanted` holds for, by the program in use; of what is closed and does not fold the outside alone.
template <class Wanted>
void draw_parts(Gpu& gpu, const Scene& scene, const Program& program, const Wanted& wanted) {
    for (const Part& part : scene.parts) {
        if (!wanted(part)) continue;
        if (part.closed && part.look != Look::flesh) gpu.gl.Enable(GL_CULL_FACE);
        program.set("sheet", part.closed ? 0 : 1);
        gpu.moving.draw(part.first, part.count);
        gpu.gl.Disable(GL_CULL_FACE);
    }
}

void draw_tool(Gpu& gpu, const ToolPicture& picture, Level level, const Program& program) {
    const Fixed& tool = gpu.tool(picture.kind, level);
    gpu.gl.Enable(GL_CULL_FACE);
    for (const auto& [part, pose] : placed_parts(picture)) {
        program.set("model", pose.matrix());
        const Part& piece = tool.parts[static_cast<std::size_t>(part)];
        tool.buffers.draw(piece.first, piece.count);
    }
    gpu.gl.Disable(GL_CULL_FACE);
}

void draw_shadow(Gpu& gpu, const Scene& scene, const Picture& picture, const View& view, Level level) {
    gpu.shadow(level).draw_here();
    gpu.gl.Enable(GL_DEPTH_TEST);
    gpu.gl.Clear(GL_DEPTH_BUFFER_BIT);
    gpu.shadow_caster.use();
    gpu.shadow_caster.set("clip_from_world", view.shadow_from_world);
    gpu.shadow_caster.set("model", Eigen::Matrix4d::Identity().eval());
    draw_parts(gpu, scene, gpu.shadow_caster, [](const Part& part) { return part.casts; });
    for (const ToolPicture& tool : picture.tools) draw_tool(gpu, tool, level, gpu.shadow_caster);
}

/// Makes a program of solids ready for its parts.
void use(Gpu& gpu, const Program& program, const View& view, Level level) {
    const Shadow& shadow = gpu.shadow(level);
    program.use();
    program.set("clip_from_world", view.clip_from_world);
    program.set("shadow_from_world", view.shadow_from_world);
    program.set("texel", static_cast<float>(2 * view.shadow_half / shadow.width));
    program.texture("shadow", 0, shadow.depth);
    program.set("eye", view.eye);
    program.set("to_key", view.to_key);
    program.set("to_fill", view.to_fill);
    program.set("to_rim", view.to_rim);
    program.set("camera_up", view.up);
    program.set("model", Eigen::Matrix4d::Identity().eval());
}

void set_material(const Program& program, Look look) {
    const Material& material = material_of(look);
    program.set("base", material.base);
    program.set("gloss", material.gloss);
    program.set("sharpness", material.sharpness);
    program.set("wrap", material.wrap);
    program.set("vignette", material.vignette);
}

void draw_solids(Gpu& gpu, const Scene& scene, const Picture& picture, const View& view, Level level) {
    const bool full = level == Level::full;
    const auto program_of = [&](Look look) -> const Program& {
        if (look == Look::flesh) return full ? gpu.flesh : gpu.light_flesh;
        if (look == Look::steel) return full ? gpu.steel : gpu.light_steel;
        return full ? gpu.solid : gpu.light_matt;
    };
    for (const Look look : {Look::flesh, Look::suture, Look::steel}) {
        const Program& program = program_of(look);
        use(gpu, program, view, level);
        set_material(program, look);
        draw_parts(gpu, scene, program, [&](const Part& part) { return part.look == look; });
    }
    for (const ToolPicture& tool : picture.tools) draw_tool(gpu, tool, level, program_of(Look::steel));
}

void draw_ghosts(Gpu& gpu, const Picture& picture, const View& view, Level level) {
    gpu.ghost.use();
    gpu.ghost.set("clip_from_world", view.clip_from_world);
    gpu.ghost.set("eye", view.eye);
    for (const ToolPicture& tool : picture.ghosts) draw_tool(gpu, tool, level, gpu.ghost);
}

void go_to(Gpu& gpu, const Viewport& viewport, const Picture& picture) {
    gpu.gl.BindFramebuffer(GL_FRAMEBUFFER, viewport.framebuffer);
    gpu.gl.Viewport(viewport.x, viewport.y, picture.width, picture.height);
}

// Mean of the fine pixels, corners darkened.
void draw_result(Gpu& gpu, const Picture& picture, const Viewport& viewport) {
    const Camera& camera = picture.camera;
    const double tall = half_height(camera), distance = (camera.position - camera.target).norm();
    go_to(gpu, viewport, picture);
    gpu.gl.Disable(GL_DEPTH_TEST);
    gpu.final.use();
    gpu.final.texture("fine_depth", 1, gpu.fine->depth);
    gpu.final.texture("fine", 0, gpu.fine->color);
    gpu.final.set("lens", Vec3(tall * picture.width / picture.height, tall, 0));
    gpu.final.set("planes", Vec3(near_plane(camera), far_plane(camera), 0.05 * tall * distance));
    gpu.final.set("corner", viewport.x, viewport.y);
    gpu.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

/// What lies on the drape: everything solid, laid flat.
void draw_cast(Gpu& gpu, const Scene& scene, const Picture& picture, const View& view, Level level) {
    constexpr double grazing = 0.1;
    if (view.to_key.z() < grazing) return;
    const Program& program = gpu.cast;
    use(gpu, program, view, level);
    set_material(program, Look::cloth);
    program.set("alpha", level == Level::full ? 0.0f : 1.0f);
    program.set("flat_at", static_cast<float>(*picture.drape));
    draw_parts(gpu, scene, program, [](const Part& part) { return part.casts; });
    for (const ToolPicture& tool : picture.tools) draw_tool(gpu, tool, level, program);
}

void draw_background(Gpu& gpu) {
    gpu.background.use();
    gpu.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

/// Whether the drape fills the picture: each corner's sight meets it.
bool fills(const Picture& picture) {
    const Camera& camera = picture.camera;
    const double up = half_height(camera), across = up * picture.width / picture.height;
    for (const double x : {-across, across})
        for (const double y : {-up, up}) {
            const Vec3 sight = axes_of(camera).transpose() * Vec3(x, y, -1);
            if (sight.z() >= 0) return false;
            const Vec3 at = camera.position + (*picture.drape - camera.position.z()) / sight.z() * sight;
            if (at.head<2>().cwiseAbs().maxCoeff() > cloth_reach) return false;
        }
    return true;
}

// From below it would hide the field. What it fills needs no background, and no depth but that of what lies on it.
void draw_ground(Gpu& gpu, const Scene& scene, const Picture& picture, const View& view, Level level) {
    const bool draped = picture.drape && picture.camera.position.z() > *picture.drape;
    const bool filled = draped && fills(picture);
    if (draped) {
        draw_cast(gpu, scene, picture, view, level);
        use(gpu, gpu.cloth, view, level);
        set_material(gpu.cloth, Look::cloth);
        gpu.cloth.set("alpha", level == Level::full ? 0.0f : 1.0f);
        gpu.cloth.set("model", Eigen::Isometry3d(Eigen::Translation3d(0, 0, *picture.drape)).matrix());
        gpu.gl.DepthMask(filled ? GL_FALSE : GL_TRUE);
        gpu.drape.buffers.draw(0, gpu.drape.count);
        gpu.gl.DepthMask(GL_TRUE);
    }
    if (!filled) draw_background(gpu);
}

void draw_marks(Gpu& gpu, const Marks& marks, const View& view) {
    if (marks.marks.empty()) return;
    gpu.marks.fill(marks.surface);
    gpu.mark.use();
    gpu.mark.set("clip_from_world", view.clip_from_world);
    gpu.mark.set("model", Eigen::Matrix4d::Identity().eval());
    gpu.mark.set("eye", view.eye);
    for (const Mark& mark : marks.marks) {
        gpu.mark.set("tint", mark.tint);
        gpu.mark.set("soft", mark.soft);
        if (mark.on_top) gpu.gl.Disable(GL_DEPTH_TEST);
        gpu.marks.draw(mark.first, mark.count);
        if (mark.on_top) gpu.gl.Enable(GL_DEPTH_TEST);
    }
}

// Blended, seen from outside only, so that each is blended once.
void draw_translucent(Gpu& gpu, const Picture& picture, const View& view, Level level) {
    gpu.gl.Enable(GL_BLEND);
    gpu.gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gpu.gl.DepthMask(GL_FALSE);
    draw_ghosts(gpu, picture, view, level);
    gpu.gl.Enable(GL_CULL_FACE);
    draw_marks(gpu, marks_of(picture), view);
    gpu.gl.DepthMask(GL_TRUE);
    gpu.gl.Disable(GL_CULL_FACE);
    gpu.gl.Disable(GL_BLEND);
}

// From the front to the back: what is hidden costs nothing.
void paint(Gpu& gpu, const Scene& scene, const Picture& picture, const View& view, Level level) {
    gpu.gl.Enable(GL_DEPTH_TEST);
    gpu.gl.DepthFunc(GL_LEQUAL);
    gpu.gl.Clear(GL_DEPTH_BUFFER_BIT);
    draw_solids(gpu, scene, picture, view, level);
    draw_ground(gpu, scene, picture, view, level);
    draw_translucent(gpu, picture, view, level);
}

void check(const Picture& picture) {
    const Camera& camera = picture.camera;
    if (std::min(picture.width, picture.height) < 1 || std::max(picture.width, picture.height) > 4096)
        throw DrawError("a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                        " pixels: each must be from 1 to 4096");
    const Vec3 sight = camera.position - camera.target;
    const double lean = camera.up.normalized().cross(sight.normalized()).norm();  // NaN where either has no direction
    if (!(sight.norm() > 0) || !(lean > 0) || !(camera.field_of_view > 0) || !(camera.field_of_view < std::numbers::pi))
        throw DrawError("a camera must look from one place at another, up not along its sight, its field of view " +
                        std::string("between 0 and pi"));
    if (!(camera.cut_off > 0) || !(camera.cut_off < 1)) throw DrawError("a camera's cut_off must be between 0 and 1");
}

Image read(Gpu& gpu) {
    const int width = gpu.result->width, height = gpu.result->height;
    Image image{width, height, std::vector<unsigned char>(3u * width * height)};
    std::vector<unsigned char> upward(image.pixels.size());
    gpu.gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gpu.gl.ReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upward.data());
    for (int y = 0; y < height; ++y)
        std::copy_n(upward.begin() + 3l * width * (height - 1 - y), 3l * width, image.pixels.begin() + 3l * width * y);
    if (const unsigned error = gpu.gl.GetError()) throw DrawError("OpenGL failed with error " + std::to_string(error));
    return image;
}

}  // namespace

void draw(Canvas& canvas, const Picture& picture, Level level, const Viewport& viewport) {
    check(picture);
    Gpu& gpu = canvas.gpu();
    Gl& gl = gpu.gl;
    gpu.context.make_current();
    for (const unsigned off : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) gl.Disable(off);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.DepthMask(GL_TRUE);
    gl.CullFace(GL_BACK);
    Scene& scene = gpu.scene;
    const View view = view_of(picture);
    fill(scene, picture, level, view.to_key);
    gpu.moving.fill(scene.surface);
    draw_shadow(gpu, scene, picture, view, level);
    if (level == Level::full) {
        resize(gpu, gpu.fine, 2 * picture.width, 2 * picture.height);
        gpu.fine->draw_here();
        paint(gpu, scene, picture, view, level);
        draw_result(gpu, picture, viewport);
    } else {
        go_to(gpu, viewport, picture);
        gl.Enable(GL_SCISSOR_TEST);  // or the depth beside it would be cleared too
        gl.Scissor(viewport.x, viewport.y, picture.width, picture.height);
        paint(gpu, scene, picture, view, level);
        gl.Disable(GL_SCISSOR_TEST);
    }
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(0);
}

Image render(Canvas& canvas, const Picture& picture, Level level) {
    check(picture);
    Gpu& gpu = canvas.gpu();
    gpu.context.make_current();
    resize(gpu, gpu.result, picture.width, picture.height);
    draw(canvas, picture, level, {.framebuffer = gpu.result->frame()});
    return read(gpu);
}

}  // namespace app::draw
