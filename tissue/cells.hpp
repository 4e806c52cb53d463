#pragma once
#include "tissue/lanes.hpp"
#include "tissue/mesh.hpp"

namespace tissue {

/// Up to four hexahedra or prisms that are split into tetrahedra in the same way, so that they can be looked at
/// together.
struct Cells {
    static constexpr std::size_t lanes = 4, most_nodes = 8, most_tetrahedra = 6,
                                 most_pairs = most_nodes * (most_nodes - 1) / 2;
    std::array<std::array<int, lanes>, most_nodes> nodes{};  ///< Where there are fewer cells, the last one again.
    std::size_t count = 0;                                   ///< Of nodes of each.
    std::array<std::array<unsigned char, 4>, most_tetrahedra>
        corners{};  ///< Of their tetrahedra, as places in `nodes`.
    std::size_t tetrahedra = 0;
    std::size_t used = 0;  ///< How many cells.
    Lane rest_volume;      ///< [m^3]
};

/// All cells of a mesh, but maybe in another order.
std::vector<Cells> cells_of(const Mesh& mesh);

/// What the volumes of cells come to, and how they change with their nodes.
struct Volumes {
    Lane value;                                     ///< [m^3], negative where a cell is inside out.
    std::array<Lanes, Cells::most_nodes> gradient;  ///< [m^2]
};
Volumes volumes(const Cells& cells, std::span<const Vec3> nodes);

/// Second and third coefficient of volumes as polynomials of how far their nodes went along `way`.
struct Bulge {
    Lane second, third;
};
Bulge bulge(const Cells& cells, std::span<const Vec3> nodes, std::span<const Vec3> way);

/// Second derivatives of volumes: between nodes a < b the matrix of the cross product with number pair(a, b) of these;
/// none of a node by itself.
constexpr std::size_t pair(std::size_t a, std::size_t b) {
    return b * (b - 1) / 2 + a;
}
std::array<Lanes, Cells::most_pairs> second_derivatives(const Cells& cells, std::span<const Vec3> nodes);

/// What nodes of these cells carry.
inline Lanes gathered(const Cells& cells, std::size_t node, std::span<const Vec3> all) {
    const auto of = [&](std::size_t k) -> const Vec3& { return all[static_cast<std::size_t>(cells.nodes[node][k])]; };
    const Vec3 &a = of(0), &b = of(1), &c = of(2), &d = of(3);
    return {Lane(a.x(), b.x(), c.x(), d.x()), Lane(a.y(), b.y(), c.y(), d.y()), Lane(a.z(), b.z(), c.z(), d.z())};
}

}  // namespace tissue
