#pragma once
#include "tissue/mesh.hpp"

namespace tissue {

/// The energy of the gradient of what nodes carry, 1/2 x L x = 1/2 sum of rest volume |F|^2: a constant matrix of one
/// number a pair of nodes, in rows.
class Laplacian {
  public:
    explicit Laplacian(const Mesh& mesh);

    void multiply(std::span<const Vec3> x, std::vector<Vec3>& to) const;  ///< to = L x [m^2, for x in m].
    std::span<const int> neighbours(int node) const;                      ///< Itself among them.
    std::span<const double> weights(int node) const;                      ///< [m], in the same order.

  private:
    std::vector<std::size_t> first_;
    std::vector<int> column_;
    std::vector<double> weight_;
};

}  // namespace tissue
