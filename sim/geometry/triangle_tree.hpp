#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "sim/geometry/shapes.hpp"

namespace sim::geometry {

/// Triangles in a tree of boxes, for "which are near here".
class TriangleTree {
  public:
    /// A tree over any number of triangles with finite corners [m].
    explicit TriangleTree(std::vector<Triangle> triangles);

    /// Moves the triangles; one new place for each. O(n), allocates nothing; the tree stays as it was split, so it
    /// finds them more slowly the less they are where they were.
    void move(std::span<const Triangle> triangles);

    /// Appends to `found` the indices of triangles whose box overlaps `box`, in ascending order of tree leaves (the
    /// same every time). Allocates only if `found` must grow.
    void near(const Box& box, std::vector<int>& found) const;

    /// A lower bound of the distance of the segment a0-a1 from triangle `i` [m]: the distance from its plane.
    double plane_gap(int i, const Vec3& a0, const Vec3& a1) const {
        const Vec3& up = normals_[static_cast<std::size_t>(i)];
        const double h0 = up.dot(a0 - (*this)[i].a), h1 = up.dot(a1 - (*this)[i].a);
        return (h0 > 0) == (h1 > 0) ? std::min(std::abs(h0), std::abs(h1)) : 0;
    }

    /// The box about triangle i.
    const Box& box(int i) const { return boxes_[static_cast<std::size_t>(i)]; }
    /// Triangle i, 0 to size() - 1, where it is now.
    const Triangle& operator[](int i) const { return triangles_[static_cast<std::size_t>(i)]; }
    /// All triangles where they are now, in the order they were given in.
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// The number of triangles.
    int size() const { return static_cast<int>(triangles_.size()); }

  private:
    struct Node {
        Box box;
        int first, count;  ///< Leaf: range in order_. Inner: count 0, children at first and first + 1.
    };
    std::vector<Triangle> triangles_;
    std::vector<Box> boxes_;
    std::vector<Vec3> normals_;  ///< Of unit length; zero for a triangle without area.
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

/// The first piece of a path, from 0, that is nearer than `distance` [m] to a triangle; -1: none. O(points log
/// triangles).
int first_nearer(std::span<const Vec3> path, const TriangleTree& triangles, double distance);

}  // namespace sim::geometry
