#include "tissue/mesh.hpp"

namespace tissue {

bool is_in_wall(std::span<const Tetrahedron> tetrahedra, std::span<const Vec3> nodes, const Vec3& point) {
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const Vec3& node : nodes) low = low.cwiseMin(node), high = high.cwiseMax(node);
    if ((point.array() < low.array()).any() || (point.array() > high.array()).any()) return false;
    for (const Tetrahedron& tet : tetrahedra) {
        const auto at = [&](std::size_t k) -> const Vec3& { return nodes[static_cast<std::size_t>(tet[k])]; };
        low = at(0).cwiseMin(at(1)).cwiseMin(at(2)).cwiseMin(at(3)),
        high = at(0).cwiseMax(at(1)).cwiseMax(at(2)).cwiseMax(at(3));
        if ((point.array() < low.array()).any() || (point.array() > high.array()).any()) continue;
        const Vec3 a = at(0) - point, b = at(1) - point, c = at(2) - point, d = at(3) - point;
        const double v0 = b.dot(c.cross(d)), v1 = -a.dot(c.cross(d)), v2 = a.dot(b.cross(d)), v3 = -a.dot(b.cross(c));
        if ((v0 >= 0 && v1 >= 0 && v2 >= 0 && v3 >= 0) || (v0 <= 0 && v1 <= 0 && v2 <= 0 && v3 <= 0)) return true;
    }
    return false;
}

}  // namespace tissue
