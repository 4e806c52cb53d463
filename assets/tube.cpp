#include <cstdio>
#include <ostream>

#include "assets/mesh.hpp"
#include "sim/geometry/portable_math.hpp"

namespace assets {

Mesh make_tube(double outer_diameter, double wall, double length, int around, int along) {
    Mesh mesh;
    // Vertex of ring i, side k, on the outer (wall 0) or inner (1) wall.
    const auto index = [&](int side, int i, int k) { return (side * (along + 1) + i) * around + k % around; };
    for (int side = 0; side < 2; ++side)
        for (int i = 0; i <= along; ++i)
            for (int k = 0; k < around; ++k) {
                const auto [sin, cos] = sim::geometry::portable_sin_cos(2 * EIGEN_PI * k / around);
                const double radius = outer_diameter / 2 - side * wall;
                mesh.vertices.emplace_back(length * i / along - length / 2, radius * cos, radius * sin);
            }
    const auto quad = [&](int a, int b, int c, int d) {  // counter-clockwise
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (int k = 0; k < around; ++k) {
        for (int i = 0; i < along; ++i) {
            quad(index(0, i, k), index(0, i, k + 1), index(0, i + 1, k + 1), index(0, i + 1, k));
            quad(index(1, i, k), index(1, i + 1, k), index(1, i + 1, k + 1), index(1, i, k + 1));
        }
        quad(index(0, 0, k), index(1, 0, k), index(1, 0, k + 1), index(0, 0, k + 1));
        quad(index(0, along, k), index(0, along, k + 1), index(1, along, k + 1), index(1, along, k));
    }
    return mesh;
}

void write_obj(const Mesh& mesh, const std::string& comment, std::ostream& out) {
    out << "# " << comment << '\n';
    char line[128];
    for (const Vec3& p : mesh.vertices) {
        const Vec3 mm = (1e9 * p).array().round() / 1e6 + 0.0;  // to the nanometre; + 0 leaves no "-0"
        std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", mm.x(), mm.y(), mm.z());
        out << line;
    }
    for (const auto& [a, b, c] : mesh.triangles) out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
}

}  // namespace assets
