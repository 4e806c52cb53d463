#include "app/draw/surface.hpp"

namespace app::draw {

constexpr double crease_cosine = 0.75;  // 41 degrees: past a 9-gon's corner, short of any edge meant to be one

Surface shaded(const assets::Mesh& mesh) {
    std::vector<Vec3> areas;
    std::vector<std::vector<int>> faces_at(mesh.vertices.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3& p = mesh.vertices[a];
        areas.push_back((mesh.vertices[b] - p).cross(mesh.vertices[c] - p));
        for (const int corner : {a, b, c}) faces_at[corner].push_back(static_cast<int>(areas.size()) - 1);
    }
    Surface surface;
    std::vector<std::vector<unsigned>> made(mesh.vertices.size());  // one vertex for each normal of a corner
    const auto vertex = [&](int corner, const Vec3& area) {
        Vec3 sum = Vec3::Zero();
        for (const int face : faces_at[corner])
            if (areas[face].dot(area) >= crease_cosine * areas[face].norm() * area.norm()) sum += areas[face];
        const Eigen::Vector3f normal = sum.normalized().cast<float>();
        for (const unsigned v : made[corner])
            if (surface.vertices[v].normal == normal) return v;
        surface.vertices.push_back({mesh.vertices[corner].cast<float>(), normal});
        made[corner].push_back(static_cast<unsigned>(surface.vertices.size()) - 1);
        return made[corner].back();
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (areas[t].isZero(0)) continue;
        for (const int corner : mesh.triangles[t]) surface.indices.push_back(vertex(corner, areas[t]));
    }
    return surface;
}

assets::Mesh loft(const Vec3& first_pole, const std::vector<std::vector<Vec3>>& rings, const Vec3& last_pole) {
    assets::Mesh mesh;
    const int around = static_cast<int>(rings.front().size()), count = static_cast<int>(rings.size());
    for (const auto& ring : rings) mesh.vertices.insert(mesh.vertices.end(), ring.begin(), ring.end());
    mesh.vertices.push_back(first_pole);
    mesh.vertices.push_back(last_pole);
    const int first = count * around, last = first + 1;
    for (int k = 0; k < around; ++k) {
        const int next = (k + 1) % around, end = (count - 1) * around;
        mesh.triangles.push_back({first, next, k});
        for (int i = 0; i + 1 < count; ++i) {
            const int row = i * around;
            mesh.triangles.push_back({row + k, row + next, row + around + next});
            mesh.triangles.push_back({row + k, row + around + next, row + around + k});
        }
        mesh.triangles.push_back({end + k, end + next, last});
    }
    return mesh;
}

}  // namespace app::draw
