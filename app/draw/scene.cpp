#include "app/draw/scene.hpp"

#include "app/draw/camera.hpp"

namespace app::draw {

void Scene::add(const Surface& more, Look look, bool closed) {
    parts.push_back({look, surface.indices.size(), more.indices.size(), closed});
    surface.add(more);
}

// The areas of a closed surface, as vectors, add up to nothing.
static bool is_closed(const assets::Mesh& mesh) {
    Vec3 sum = Vec3::Zero();
    double all = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 area = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
        sum += area;
        all += area.norm();
    }
    return sum.norm() < 1e-6 * all;
}

static Roundness roundness_of(Level level) {
    return level == Level::full ? Roundness{} : Roundness{.around = 8, .cap_rings = 2, .pieces = 2};
}

void fill(Scene& scene, const Picture& picture, Level level) {
    const double pixel = 2 * half_height(picture.camera) / picture.height;  // at one metre
    const auto thread_radius = [&](const Vec3& p) {
        return std::max(picture.thread_radius, 1.6 * pixel * project(picture, p).z());
    };
    const Roundness round = roundness_of(level);
    scene.surface.vertices.clear();
    scene.surface.indices.clear();
    scene.parts.clear();
    for (const assets::Mesh& vessel : picture.vessels)
        scene.add(shaded(vessel, flesh_crease), Look::flesh, is_closed(vessel));
    for (const Continued& end : picture.continued)
        scene.add(shaded(continuation(picture, end), flesh_crease), Look::flesh);
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
}

Scene tool_scene(instruments::Kind kind, Level level) {
    Scene scene;
    for (const ToolPart part : {ToolPart::shaft, ToolPart::pin, ToolPart::jaw})
        scene.add(shaded(tool_part(kind, part, level == Level::full), steel_crease), Look::steel);
    return scene;
}

}  // namespace app::draw
