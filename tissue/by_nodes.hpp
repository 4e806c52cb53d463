#pragma once
#include <span>

#include "tissue/mesh.hpp"

// Vectors with a row for each node.
namespace tissue {

/// Scalar product of two of one length.
inline double dot(std::span<const Vec3> a, std::span<const Vec3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

/// Adds a force at a point of a tetrahedron, by its barycentric weights, to the forces on its corners.
inline void share(const Tetrahedron& tet, const std::array<double, 4>& weights, const Vec3& force, std::span<Vec3> to) {
    for (std::size_t k = 0; k < 4; ++k) to[static_cast<std::size_t>(tet[k])] += weights[k] * force;
}

}  // namespace tissue
