#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "sim/geometry/shapes.hpp"

namespace sim::thread::contact {

using geometry::Box;
using geometry::Vec3;

/// Boxes over the links in their order along the thread: leaf k holds links leaf_links*k onwards, parent p has children
/// 2p and 2p+1. The shape is fixed by the number of links; refitting is one pass, O(n).
/// Near neighbours in order are near in space, which is what keeps self-tests cheap ([Guibas2004], necklaces).
class LinkTree {
  public:
    static constexpr int leaf_links = 4;  ///< Links in a leaf; the last leaf may hold fewer.

    /// Makes a tree over so many links, the most that it may come to have.
    explicit LinkTree(int most_links);

    /// Sets the number of links, no more than at first. Allocates nothing.
    void resize(int links);

    /// Brings all boxes to the links between consecutive `nodes` [m], one more than there are links, without radius.
    void refit(std::span<const Vec3> nodes);

    /// Calls visit(i, j) with i + skip <= j for every two links whose leaves come within `reach` [m] of each other.
    template <class Visit>
    void self_pairs(double reach, int skip, Visit&& visit);

    /// Calls visit(i) for the links of every leaf that overlaps `box`.
    template <class Visit>
    void near(const Box& box, Visit&& visit);

    /// Calls visit(box, first, last) for every leaf: its box and its links [first, last).
    template <class Visit>
    void leaves(Visit&& visit) const;

  private:
    int first_link(int leaf) const { return leaf * leaf_links; }
    int last_link(int leaf) const { return std::min(links_, (leaf + 1) * leaf_links); }

    int links_, leaves_, width_;  ///< width_: leaves rounded up to a power of two; leaf k is box width_ + k.
    std::vector<Box> boxes_;
    std::vector<std::pair<int, int>> stack_;
};

inline LinkTree::LinkTree(int most_links) {
    resize(most_links);
    stack_.reserve(256);
}

inline void LinkTree::resize(int links) {
    links_ = links;
    leaves_ = (links + leaf_links - 1) / leaf_links;
    for (width_ = 1; width_ < leaves_;) width_ *= 2;
    boxes_.resize(static_cast<std::size_t>(2 * width_));
}

inline void LinkTree::refit(std::span<const Vec3> nodes) {
    for (int leaf = 0; leaf < width_; ++leaf) {
        Box box;
        if (leaf < leaves_)
            for (int i = first_link(leaf); i <= last_link(leaf); ++i) box.include(nodes[static_cast<std::size_t>(i)]);
        boxes_[static_cast<std::size_t>(width_ + leaf)] = box;
    }
    for (int p = width_ - 1; p >= 1; --p) {
        Box box = boxes_[static_cast<std::size_t>(2 * p)];
        box.include(boxes_[static_cast<std::size_t>(2 * p + 1)]);
        boxes_[static_cast<std::size_t>(p)] = box;
    }
}

template <class Visit>
void LinkTree::self_pairs(double reach, int skip, Visit&& visit) {
    stack_.assign(1, {1, 1});
    while (!stack_.empty()) {
        const auto [a, b] = stack_.back();
        stack_.pop_back();
        const Box &box_a = boxes_[static_cast<std::size_t>(a)], &box_b = boxes_[static_cast<std::size_t>(b)];
        if (a != b && !box_a.grown(reach).overlaps(box_b)) continue;
        if (a >= width_) {  // both are leaves: the two sides descend together
            const int leaf_a = a - width_, leaf_b = b - width_;
            if (leaf_b >= leaves_) continue;
            for (int i = first_link(leaf_a); i < last_link(leaf_a); ++i)
                for (int j = std::max(i + skip, first_link(leaf_b)); j < last_link(leaf_b); ++j) visit(i, j);
            continue;
        }
        stack_.push_back({2 * a + 1, 2 * b + 1});
        stack_.push_back({2 * a, 2 * b + 1});
        if (a != b) stack_.push_back({2 * a + 1, 2 * b});
        stack_.push_back({2 * a, 2 * b});
    }
}

template <class Visit>
void LinkTree::near(const Box& box, Visit&& visit) {
    stack_.assign(1, {1, 1});
    while (!stack_.empty()) {
        const int a = stack_.back().first;
        stack_.pop_back();
        if (!boxes_[static_cast<std::size_t>(a)].overlaps(box)) continue;
        if (a < width_) {
            stack_.push_back({2 * a + 1, 0});
            stack_.push_back({2 * a, 0});
        } else {
            for (int i = first_link(a - width_); i < last_link(a - width_); ++i) visit(i);
        }
    }
}

template <class Visit>
void LinkTree::leaves(Visit&& visit) const {
    for (int leaf = 0; leaf < leaves_; ++leaf)
        visit(boxes_[static_cast<std::size_t>(width_ + leaf)], first_link(leaf), last_link(leaf));
}

}  // namespace sim::thread::contact
