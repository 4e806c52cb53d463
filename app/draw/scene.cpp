#include "app/draw/scene.hpp"

#include "app/draw/camera.hpp"

namespace app::draw {

void Scene::add(const Surface& more, Look look) {
    parts.push_back({look, surface.indices.size(), more.indices.size()});
    surface.add(more);
}

static Roundness roundness_of(Level level) {
    return level == Level::full ? Roundness{} : Roundness{.around = 8, .cap_rings = 2, .pieces = 2};
}

Scene scene_of(const Picture& picture, Level level) {
    const double pixel = 2 * half_height(picture.camera) / picture.height;  // at one metre
    const auto thread_radius = [&](const Vec3& p) {
        return std::max(picture.thread_radius, 1.6 * pixel * project(picture, p).z());
    };
    const Roundness round = roundness_of(level);
    Scene scene;
    for (const assets::Mesh& vessel : picture.vessels) scene.add(shaded(vessel), Look::flesh);
    for (const std::vector<Vec3>& piece : picture.thread) scene.add(tube(piece, thread_radius, round), Look::suture);
    for (const std::vector<Vec3>& wire : picture.wires)
        scene.add(tube(
                      wire, [&](const Vec3&) { return picture.wire_radius; }, round),
                  Look::steel);
    for (const std::vector<Vec3>& needle : picture.needles) {
        // A taper point: ten times as long as its wire is thick.
        const auto radius = [&](const Vec3& p) {
            return std::min(picture.needle_radius, 0.02 * picture.needle_radius + (p - needle.back()).norm() / 20);
        };
        scene.add(tube(needle, radius, round), Look::steel);
    }
    return scene;
}

Scene tool_scene(instruments::Kind kind, Level level) {
    Scene scene;
    for (const ToolPart part : {ToolPart::shaft, ToolPart::pin, ToolPart::jaw})
        scene.add(shaded(tool_part(kind, part, level == Level::full ? 32 : 12)), Look::steel);
    return scene;
}

}  // namespace app::draw
