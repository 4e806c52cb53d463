#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/draw/camera.hpp"
#include "app/draw/gl.hpp"
#include "app/draw/shaders.hpp"
#include "app/draw/surface.hpp"

namespace app::draw {

constexpr int shadow_size = 2048;  // as in the shader

struct Canvas::Gpu {
    Context context;
    Gl& gl = context.gl;
    Program solid{gl, shaders::solid_vertex, shaders::solid_fragment};
    Program shadow_caster{gl, shaders::solid_vertex, shaders::nothing_fragment};
    Program background{gl, shaders::screen_vertex, shaders::background_fragment};
    Program final{gl, shaders::screen_vertex, shaders::final_fragment};
    Target shadow{gl, shadow_size, shadow_size, false};
    std::unique_ptr<Target> fine, result;  // twice the picture's width and height; the picture
    unsigned array = 0, buffers[2] = {};

    Gpu() {
        gl.GenVertexArrays(1, &array);
        gl.BindVertexArray(array);
        gl.GenBuffers(2, buffers);
        gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
        for (unsigned i = 0; i < 2; ++i) {
            gl.EnableVertexAttribArray(i);
            gl.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                   reinterpret_cast<const void*>(i * sizeof(Eigen::Vector3f)));
        }
        gl.BindTexture(GL_TEXTURE_2D, shadow.depth);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl.DepthFunc(GL_LEQUAL);
    }
    ~Gpu() {
        context.make_current();
        gl.DeleteBuffers(2, buffers);
        gl.DeleteVertexArrays(1, &array);
    }
    void resize(int width, int height) {
        if (result && result->width == width && result->height == height) return;
        fine = std::make_unique<Target>(gl, 2 * width, 2 * height, true);
        result = std::make_unique<Target>(gl, width, height, true);
    }
};

Canvas::Canvas() : gpu_(std::make_unique<Gpu>()) {}
Canvas::~Canvas() = default;

namespace {

using Gpu = Canvas::Gpu;

struct Material {
    Vec3 base;  ///< Share of red, green and blue light sent back.
    float gloss, sharpness, metal, mottle;
};
const Material suture{{0.02, 0.07, 0.52}, 0.55f, 50, 0, 0};
const Material flesh{{0.60, 0.085, 0.075}, 0.40f, 45, 0, 1};
const Material steel{{0.80, 0.82, 0.84}, 0.50f, 90, 1, 0};

/// Triangles of one material, where they lie in the buffers.
struct Part {
    Material material;
    std::size_t first, count;
};

struct Scene {
    Surface surface;
    std::vector<Part> parts;

    void add(const assets::Mesh& mesh, const Material& material) {
        const Surface more = shaded(mesh);
        const auto offset = static_cast<unsigned>(surface.vertices.size());
        parts.push_back({material, surface.indices.size(), more.indices.size()});
        surface.vertices.insert(surface.vertices.end(), more.vertices.begin(), more.vertices.end());
        for (const unsigned index : more.indices) surface.indices.push_back(offset + index);
    }
};

Scene scene_of(const Picture& picture) {
    const double pixel = 2 * half_height(picture.camera) / picture.height;  // at one metre
    const auto radius_at = [&](const Vec3& p) {
        return std::max(picture.thread_radius, 1.6 * pixel * project(picture, p).z());
    };
    Scene scene;
    for (const assets::Mesh& vessel : picture.vessels) scene.add(vessel, flesh);
    for (const ToolPicture& one : picture.tools)
        for (const assets::Mesh& part : tool(one)) scene.add(part, steel);
    for (const std::vector<Vec3>& piece : picture.thread) scene.add(tube(piece, radius_at), suture);
    for (const std::vector<Vec3>& wire : picture.wires)
        scene.add(tube(wire, [&](const Vec3&) { return picture.wire_radius; }), steel);
    // A taper point: ten times as long as its wire is thick.
    for (const std::vector<Vec3>& needle : picture.needles)
        scene.add(tube(needle,
                       [&](const Vec3& p) {
                           return std::min(picture.needle_radius,
                                           0.02 * picture.needle_radius + (p - needle.back()).norm() / 20);
                       }),
                  steel);
    return scene;
}

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

void upload(Gpu& gpu, const Surface& surface) {
    gpu.gl.BindVertexArray(gpu.array);
    gpu.gl.BindBuffer(GL_ARRAY_BUFFER, gpu.buffers[0]);
    gpu.gl.BufferData(GL_ARRAY_BUFFER, surface.vertices.size() * sizeof(Vertex), surface.vertices.data(),
                      GL_STREAM_DRAW);
    gpu.gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, surface.indices.size() * sizeof(unsigned), surface.indices.data(),
                      GL_STREAM_DRAW);
}

void draw(Gpu& gpu, std::size_t first, std::size_t count) {
    gpu.gl.DrawElements(GL_TRIANGLES, static_cast<int>(count), GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(first * sizeof(unsigned)));
}

void draw_shadow(Gpu& gpu, const Scene& scene, const Eigen::Matrix4d& shadow) {
    gpu.shadow.draw_here();
    gpu.gl.Enable(GL_DEPTH_TEST);
    gpu.gl.Clear(GL_DEPTH_BUFFER_BIT);
    gpu.shadow_caster.use();
    gpu.shadow_caster.set("clip_from_world", shadow);
    draw(gpu, 0, scene.surface.indices.size());
}

void draw_solids(Gpu& gpu, const Scene& scene, const Picture& picture) {
    const Camera& camera = picture.camera;
    const Eigen::Matrix3d axes = axes_of(camera);
    const auto towards = [&](double right, double up, double back) -> Vec3 {
        return axes.transpose() * Vec3(right, up, back).normalized();
    };
    // The lamps go with the camera: the key over its left shoulder, the fill low on the right, the rim behind.
    const Vec3 key = towards(-0.45, 0.85, 0.65);
    const double half = 1.8 * half_height(camera) * (camera.position - camera.target).norm();
    const Eigen::Matrix4d shadow = shadow_from_world(camera.target, key, half);
    draw_shadow(gpu, scene, shadow);

    gpu.fine->draw_here();
    gpu.gl.Clear(GL_DEPTH_BUFFER_BIT);
    gpu.background.use();
    gpu.gl.DrawArrays(GL_TRIANGLES, 0, 3);
    const Program& solid = gpu.solid;
    solid.use();
    solid.set("clip_from_world", clip_from_world(camera, static_cast<double>(picture.width) / picture.height));
    solid.set("shadow_from_world", shadow);
    solid.set("texel", static_cast<float>(2 * half / shadow_size));
    solid.texture("shadow", 0, gpu.shadow.depth);
    solid.set("eye", camera.position);
    solid.set("to_key", key);
    solid.set("to_fill", towards(0.9, -0.1, 0.6));
    solid.set("to_rim", towards(0.4, 0.5, -0.8));
    solid.set("camera_up", towards(0, 1, 0));
    for (const auto& [material, first, count] : scene.parts) {
        solid.set("base", material.base);
        solid.set("gloss", material.gloss);
        solid.set("sharpness", material.sharpness);
        solid.set("metal", material.metal);
        solid.set("mottle", material.mottle);
        draw(gpu, first, count);
    }
}

void draw_result(Gpu& gpu, const Picture& picture) {
    const Camera& camera = picture.camera;
    const double tall = half_height(camera), distance = (camera.position - camera.target).norm();
    gpu.result->draw_here();
    gpu.gl.Disable(GL_DEPTH_TEST);
    gpu.final.use();
    gpu.final.texture("fine", 0, gpu.fine->color);
    gpu.final.texture("fine_depth", 1, gpu.fine->depth);
    gpu.final.set("lens", Vec3(tall * picture.width / picture.height, tall, 0));
    gpu.final.set("planes", Vec3(near_plane(camera), far_plane(camera), 0.05 * tall * distance));
    gpu.gl.DrawArrays(GL_TRIANGLES, 0, 3);
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
    gpu.gl.ReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upward.data());
    for (int y = 0; y < height; ++y)
        std::copy_n(upward.begin() + 3l * width * (height - 1 - y), 3l * width, image.pixels.begin() + 3l * width * y);
    if (const unsigned error = gpu.gl.GetError()) throw DrawError("OpenGL failed with error " + std::to_string(error));
    return image;
}

}  // namespace

Image render(Canvas& canvas, const Picture& picture) {
    check(picture);
    Gpu& gpu = canvas.gpu();
    gpu.context.make_current();
    gpu.resize(picture.width, picture.height);
    const Scene scene = scene_of(picture);
    upload(gpu, scene.surface);
    draw_solids(gpu, scene, picture);
    draw_result(gpu, picture);
    return read(gpu);
}

}  // namespace app::draw
