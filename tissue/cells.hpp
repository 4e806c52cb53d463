#pragma once
#include "tissue/lanes.hpp"
#include "tissue/mesh.hpp"

namespace tissue {

/// Up to four hexahedra or prisms that are split into tetrahedra in the same way, so that they can be looked at
/// together.
struct Cells {
    static constexpr std::size_t lanes = 4;            ///< Cells that are looked at together.
    static constexpr std::size_t most_nodes = 8;       ///< Most nodes of a cell.
    static constexpr std::size_t most_tetrahedra = 6;  ///< Most tetrahedra of a cell.
    static constexpr std::size_t most_pairs = most_nodes * (most_nodes - 1) / 2;  ///< Most pairs of nodes.

    std::array<std::array<int, lanes>, most_nodes> nodes{};  ///< Nodes of each cell; unused places repeat the last.
    std::size_t count = 0;                                   ///< Nodes of each cell.
    /// Corners of their tetrahedra, as places in `nodes`.
    std::array<std::array<unsigned char, 4>, most_tetrahedra> corners{};
    std::size_t tetrahedra = 0;  ///< Tetrahedra of each cell.
    std::size_t used = 0;        ///< How many cells, 1 to `lanes`.
    Lane rest_volume;            ///< Volume of each cell at rest [m^3].
};

/// All cells of a mesh, maybe in another order. Each has at most eight nodes and six tetrahedra.
std::vector<Cells> cells_of(const Mesh& mesh);

/// Volumes of cells, and how they change with their nodes.
struct Volumes {
    Lane value;                                     ///< Volume of each cell [m^3], negative where it is inside out.
    std::array<Lanes, Cells::most_nodes> gradient;  ///< Derivative of the volumes by each node's place [m^2].
};
/// The volumes of cells whose mesh has its nodes here [m].
Volumes volumes(const Cells& cells, std::span<const Vec3> nodes);

/// Volumes as polynomials of how far nodes have gone along a direction.
struct Bulge {
    Lane second;  ///< Coefficient of the second power [m^3].
    Lane third;   ///< Coefficient of the third power [m^3].
};
/// These polynomials for nodes here, each going along its entry of `direction` [m].
Bulge bulge(const Cells& cells, std::span<const Vec3> nodes, std::span<const Vec3> direction);

/// Number of the pair of nodes a < b.
constexpr std::size_t pair(std::size_t a, std::size_t b) {
    return b * (b - 1) / 2 + a;
}
/// Second derivatives of volumes for nodes here [m]: between nodes a < b the matrix of the cross product with entry
/// pair(a, b) of these; a node by itself has none.
std::array<Lanes, Cells::most_pairs> second_derivatives(const Cells& cells, std::span<const Vec3> nodes);

/// What node number `node` of each of these cells carries, of what all nodes carry.
inline Lanes gathered(const Cells& cells, std::size_t node, std::span<const Vec3> all) {
    const auto of = [&](std::size_t k) -> const Vec3& { return all[static_cast<std::size_t>(cells.nodes[node][k])]; };
    const Vec3 &a = of(0), &b = of(1), &c = of(2), &d = of(3);
    return {Lane(a.x(), b.x(), c.x(), d.x()), Lane(a.y(), b.y(), c.y(), d.y()), Lane(a.z(), b.z(), c.z(), d.z())};
}

}  // namespace tissue
