#pragma once
#include <algorithm>
#include <vector>

#include "sim/geometry/shapes.hpp"

namespace sim::knot {

/// Boxes of numbered things in a binary tree over their numbers: neighbours on a curve are neighbours in space. A leaf
/// holds some of them.
class ChainTree {
  public:
    /// A tree over these boxes, things numbered from 0. O(n).
    explicit ChainTree(const std::vector<geometry::Box>& boxes) : count_(static_cast<int>(boxes.size())) {
        while (leaves_ * of_leaf < count_) leaves_ *= 2;
        node_.resize(static_cast<std::size_t>(2 * leaves_));
        for (int i = 0; i < count_; ++i) node(leaves_ + i / of_leaf).include(boxes[static_cast<std::size_t>(i)]);
        for (int i = leaves_ - 1; i > 0; --i) node(i) = joined(node(2 * i), node(2 * i + 1));
    }

    /// Thing i now also fills this box.
    void grow(int i, const geometry::Box& box) {
        for (int n = leaves_ + i / of_leaf; n > 0; n /= 2) node(n).include(box);
    }

    /// Calls visit(i) for every thing from `first` on whose box may overlap, ascending, until it returns false.
    /// False when it was stopped.
    template <class Visit>
    bool visit_overlapping(const geometry::Box& box, int first, const Visit& visit) const {
        return descend(1, 0, leaves_ * of_leaf, box, first, visit);
    }

  private:
    static constexpr int of_leaf = 4;

    template <class Visit>
    bool descend(int n, int low, int size, const geometry::Box& box, int first, const Visit& visit) const {
        if (low + size <= first || low >= count_ || !box.overlaps(node(n))) return true;
        if (size > of_leaf)
            return descend(2 * n, low, size / 2, box, first, visit) &&
                   descend(2 * n + 1, low + size / 2, size / 2, box, first, visit);
        for (int i = std::max(low, first); i < std::min(low + size, count_); ++i)
            if (!visit(i)) return false;
        return true;
    }

    static geometry::Box joined(geometry::Box a, const geometry::Box& b) {
        a.include(b);
        return a;
    }
    geometry::Box& node(int i) { return node_[static_cast<std::size_t>(i)]; }
    const geometry::Box& node(int i) const { return node_[static_cast<std::size_t>(i)]; }

    std::vector<geometry::Box> node_;
    int count_, leaves_ = 1;
};

}  // namespace sim::knot
