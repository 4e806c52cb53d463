#include "app/draw/surface.hpp"

namespace app::draw {

void Surface::add(const Surface& more) {
    const auto offset = static_cast<unsigned>(vertices.size());
    vertices.insert(vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const unsigned index : more.indices) indices.push_back(offset + index);
}

namespace {

using Vec3f = Eigen::Vector3f;

/// For each corner the faces that meet there: faces[first[c]] to faces[first[c + 1] - 1].
struct FacesAtCorners {
    std::vector<int> first, faces;

    explicit FacesAtCorners(const assets::Mesh& mesh)
        : first(mesh.vertices.size() + 2), faces(3 * mesh.triangles.size()) {
        for (const auto& triangle : mesh.triangles)
            for (const int corner : triangle) ++first[static_cast<std::size_t>(corner) + 2];
        for (std::size_t i = 2; i < first.size(); ++i) first[i] += first[i - 1];
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const int corner : mesh.triangles[t])
                faces[static_cast<std::size_t>(first[static_cast<std::size_t>(corner) + 1]++)] = static_cast<int>(t);
    }
};

}  // namespace

Surface shaded(const assets::Mesh& mesh, float crease_cosine) {
    std::vector<Vec3f> areas, units;
    areas.reserve(mesh.triangles.size()), units.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3& p = mesh.vertices[a];
        areas.push_back((1e6 * (mesh.vertices[b] - p).cross(mesh.vertices[c] - p)).cast<float>());  // [mm^2]
        units.push_back(areas.back().normalized());
    }
    const FacesAtCorners at(mesh);
    Surface surface;
    surface.vertices.reserve(2 * mesh.vertices.size()), surface.indices.reserve(3 * mesh.triangles.size());
    // The vertices made of a corner, one for each of its normals: the last, and from each to the one before.
    std::vector<int> made(mesh.vertices.size(), -1), before;
    const auto vertex = [&](std::size_t corner, const Vec3f& unit) {
        Vec3f sum = Vec3f::Zero();
        for (int i = at.first[corner]; i < at.first[corner + 1]; ++i)
            if (units[at.faces[i]].dot(unit) >= crease_cosine) sum += areas[at.faces[i]];
        const Vec3f normal = sum.normalized();
        for (int v = made[corner]; v >= 0; v = before[v])
            if (surface.vertices[v].normal == normal) return static_cast<unsigned>(v);
        surface.vertices.push_back({mesh.vertices[corner].cast<float>(), normal});
        before.push_back(made[corner]);
        made[corner] = static_cast<int>(before.size()) - 1;
        return static_cast<unsigned>(made[corner]);
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (areas[t].isZero(0)) continue;
        for (const int corner : mesh.triangles[t])
            surface.indices.push_back(vertex(static_cast<std::size_t>(corner), units[t]));
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
