#include "sim/geometry/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "sim/geometry/closest_points.hpp"

namespace sim::geometry {

constexpr int leaf_size = 4;  // Triangles tested one by one rather than split further.

static Box box_of(const Triangle& t) {
    return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

// Median split on the longest axis of the centres' box. Equal keys fall back on the index: one tree per input.
TriangleTree::TriangleTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    for (const Triangle& t : triangles_)
        boxes_.push_back(box_of(t)), normals_.push_back((t.b - t.a).cross(t.c - t.a).normalized());
    order_.resize(triangles_.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (triangles_.empty()) return;

    std::vector<Vec3> centre;
    for (const Box& box : boxes_) centre.push_back((box.low + box.high) / 2);
    nodes_.push_back({{}, 0, size()});
    for (std::size_t at = 0; at < nodes_.size(); ++at) {  // children are appended, so this visits every node
        const int first = nodes_[at].first, count = nodes_[at].count;
        Box centres;
        for (int i = first; i < first + count; ++i) {
            const auto index = static_cast<std::size_t>(order_[static_cast<std::size_t>(i)]);
            nodes_[at].box.include(boxes_[index]);
            centres.include(centre[index]);
        }
        if (count <= leaf_size) continue;
        int axis = 0;
        (centres.high - centres.low).maxCoeff(&axis);
        const auto before = [&](int i, int j) {
            const double a = centre[static_cast<std::size_t>(i)][axis], b = centre[static_cast<std::size_t>(j)][axis];
            return a < b || (a == b && i < j);
        };
        const int half = count / 2;
        const auto begin = order_.begin() + first;
        std::sort(begin, begin + count, before);
        nodes_[at].count = 0;
        nodes_[at].first = static_cast<int>(nodes_.size());
        nodes_.push_back({{}, first, half});
        nodes_.push_back({{}, first + half, count - half});
    }
}

void TriangleTree::move(std::span<const Triangle> triangles) {
    assert(triangles.size() == triangles_.size() && "one new place for each triangle");
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        if (t.a == triangles_[i].a && t.b == triangles_[i].b && t.c == triangles_[i].c) continue;
        triangles_[i] = t;
        boxes_[i] = box_of(t);
        normals_[i] = (t.b - t.a).cross(t.c - t.a).normalized();
    }
    for (std::size_t at = nodes_.size(); at-- > 0;) {  // children come after their node
        Node& node = nodes_[at];
        node.box = {};
        if (node.count == 0) {
            for (int child : {node.first, node.first + 1})
                node.box.include(nodes_[static_cast<std::size_t>(child)].box);
        } else {
            for (int i = node.first; i < node.first + node.count; ++i)
                node.box.include(boxes_[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])]);
        }
    }
}

void TriangleTree::near(const Box& box, std::vector<int>& found) const {
    // Depth is at most log2 of 2^31 triangles, and each level leaves one node waiting.
    std::array<int, 34> waiting;
    std::size_t top = 0;
    if (!nodes_.empty()) waiting[top++] = 0;
    while (top > 0) {
        const Node& node = nodes_[static_cast<std::size_t>(waiting[--top])];
        if (!node.box.overlaps(box)) continue;
        if (node.count == 0) {
            waiting[top++] = node.first + 1;
            waiting[top++] = node.first;
        }
        for (int i = node.first; i < node.first + node.count; ++i) {
            const int index = order_[static_cast<std::size_t>(i)];
            if (boxes_[static_cast<std::size_t>(index)].overlaps(box)) found.push_back(index);
        }
    }
}

int first_nearer(std::span<const Vec3> path, const TriangleTree& triangles, double distance) {
    assert(distance >= 0);
    std::vector<int> near;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        Box box;
        box.include(path[i]);
        box.include(path[i + 1]);
        near.clear();
        triangles.near(box.grown(distance), near);
        for (const int triangle : near)
            if (closest_points(path[i], path[i + 1], triangles[triangle]).distance_squared < distance * distance)
                return static_cast<int>(i);
    }
    return -1;
}

}  // namespace sim::geometry
