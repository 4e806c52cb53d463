#include "app/draw/scene.hpp"

#include "app/draw/camera.hpp"

namespace app::draw {

void Scene::add(const Surface& more, Look look, bool closed, bool casts) {
    parts.push_back({look, surface.indices.size(), more.indices.size(), closed, casts});
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

// What is some pixels wide needs no more sides.
static Roundness roundness_of(Level level, double pixels_wide) {
    if (level == Level::full) return {};
    return {.around = pixels_wide < 8 ? 6 : 8, .cap_rings = 2, .pieces = 2, .straight = 0.12};
}

namespace {

using Radius = std::function<double(const Vec3&)>;

/// Adds round things; at the light level a band casts their shadow, which has a sixth of their triangles.
struct RoundThings {
    Scene& scene;
    Level level;
    Vec3 to_key;
    double pixel;  ///< Size of one at the target [m].

    void add(const std::vector<Vec3>& points, const Radius& radius_at, double radius, Look look) const {
        const bool full = level == Level::full || points.size() < 2;
        scene.add(tube(points, radius_at, roundness_of(level, 2 * radius / pixel)), look, true, full);
        if (!full) scene.add(band(points, radius_at, to_key), Look::shadow, false);
    }
};

}  // namespace

void fill(Scene& scene, const Picture& picture, Level level, const Vec3& to_key) {
    const Camera& camera = picture.camera;
    const double pixel = 2 * half_height(camera) / picture.height;  // at one metre
    const auto thread_radius = [&](const Vec3& p) {
        return std::max(picture.thread_radius, 1.6 * pixel * project(picture, p).z());
    };
    scene.surface.vertices.clear();
    scene.surface.indices.clear();
    scene.parts.clear();
    for (const assets::Mesh& vessel : picture.vessels)
        scene.add(shaded(vessel, flesh_crease), Look::flesh, is_closed(vessel));
    for (const Continued& end : picture.continued)
        scene.add(shaded(continuation(picture, end), flesh_crease), Look::flesh);
    const RoundThings round{scene, level, to_key, pixel * (camera.position - camera.target).norm()};
    for (const auto& piece : picture.thread) round.add(piece, thread_radius, picture.thread_radius, Look::suture);
    const auto wire_radius = [&](const Vec3&) { return picture.wire_radius; };
    for (const auto& wire : picture.wires) round.add(wire, wire_radius, picture.wire_radius, Look::steel);
    for (const auto& needle : picture.needles) {
        // A taper point: ten times as long as its wire is thick.
        const auto radius = [&](const Vec3& p) {
            return std::min(picture.needle_radius, 0.02 * picture.needle_radius + (p - needle.back()).norm() / 20);
        };
        round.add(needle, radius, picture.needle_radius, Look::steel);
    }
}

Scene tool_scene(instruments::Kind kind, Level level) {
    Scene scene;
    for (const ToolPart part : {ToolPart::shaft, ToolPart::pin, ToolPart::jaw})
        scene.add(shaded(tool_part(kind, part, level == Level::full), steel_crease), Look::steel);
    return scene;
}

}  // namespace app::draw
