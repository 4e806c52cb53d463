#pragma once
#include "tissue/mesh.hpp"

namespace tissue {

/// The matrix L of the energy of the gradient F of what nodes carry, 1/2 x L x = 1/2 sum of rest volume |F|^2:
/// constant, one number for each pair of nodes of a cell, kept in rows.
class Laplacian {
  public:
    /// Assembles it for a mesh at rest. O(cells).
    explicit Laplacian(const Mesh& mesh);

    /// The product L x, one entry a node: x in [m] gives [m^2] in `to`, which is resized.
    void multiply(std::span<const Vec3> x, std::vector<Vec3>& to) const;
    std::span<const int> neighbours(int node) const;  ///< Columns of a node's row, its own too.
    std::span<const double> weights(int node) const;  ///< Numbers of a node's row, in the order of neighbours() [m].

  private:
    std::vector<std::size_t> first_;
    std::vector<int> column_;
    std::vector<double> weight_;
};

}  // namespace tissue
