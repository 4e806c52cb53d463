// Stiffness matrix of linear tetrahedra (finite elements, Zienkiewicz and Taylor 2000), mixed with that of the
// gradient's mean over a cell, which bends more easily. Found once; a step only multiplies.
#include "tissue/laplacian.hpp"

#include <cassert>
#include <map>

#include "tissue/cells.hpp"

namespace tissue {

namespace {

using Rows = std::vector<std::map<int, double>>;

// How much of the energy is that of the tetrahedra, each with a gradient of its own; the rest is that of the gradient's
// mean over a cell. Tetrahedra alone are too stiff in bending: the edge of a cut, pulled at 20 mN, lacked a fifth of
// its way instead of a tenth (24 cells around, 2 far). With less than a half a cube that is cramped on one side and
// spread on the other, its volume kept, would hold no energy.
constexpr double own_share = 0.5;

void add_tetrahedra(const Mesh& mesh, Rows& rows) {
    for (const Tetrahedron& tet : mesh.tetrahedra) {
        const auto at = [&](std::size_t k) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(tet[k])]; };
        const double six = 6 * volume(tet, mesh.nodes);
        std::array<Vec3, 4> slope;  // of the shape functions
        slope[1] = (at(2) - at(0)).cross(at(3) - at(0)) / six;
        slope[2] = (at(3) - at(0)).cross(at(1) - at(0)) / six;
        slope[3] = (at(1) - at(0)).cross(at(2) - at(0)) / six;
        slope[0] = -slope[1] - slope[2] - slope[3];
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b)
                rows[static_cast<std::size_t>(tet[a])][tet[b]] += own_share * six / 6 * slope[a].dot(slope[b]);
    }
}

void add_cells(const Mesh& mesh, Rows& rows) {
    for (const Cells& cells : cells_of(mesh)) {
        const auto [volume, gradient] = volumes(cells, mesh.nodes);
        for (std::size_t k = 0; k < cells.used; ++k)
            for (std::size_t a = 0; a < cells.count; ++a)
                for (std::size_t b = 0; b < cells.count; ++b)
                    rows[static_cast<std::size_t>(cells.nodes[a][k])][cells.nodes[b][k]] +=
                        (1 - own_share) * dot(gradient[a], gradient[b])[k] / volume[k];
    }
}

}  // namespace

Laplacian::Laplacian(const Mesh& mesh) {
    Rows rows(mesh.nodes.size());
    add_tetrahedra(mesh, rows);
    add_cells(mesh, rows);
    for (const auto& row : rows) {
        first_.push_back(column_.size());
        for (const auto& [column, weight] : row) column_.push_back(column), weight_.push_back(weight);
    }
    first_.push_back(column_.size());
}

void Laplacian::multiply(std::span<const Vec3> x, std::vector<Vec3>& to) const {
    assert(x.size() + 1 == first_.size() && "one entry for each node");
    to.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
            sum += weight_[k] * x[static_cast<std::size_t>(column_[k])];
        to[i] = sum;
    }
}

std::span<const int> Laplacian::neighbours(int node) const {
    const auto i = static_cast<std::size_t>(node);
    return {column_.data() + first_[i], column_.data() + first_[i + 1]};
}

std::span<const double> Laplacian::weights(int node) const {
    const auto i = static_cast<std::size_t>(node);
    return {weight_.data() + first_[i], weight_.data() + first_[i + 1]};
}

}  // namespace tissue
