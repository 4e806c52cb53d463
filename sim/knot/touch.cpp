#include <algorithm>
#include <optional>

#include "sim/geometry/closest_points.hpp"
#include "sim/knot/chain_tree.hpp"
#include "sim/knot/namer.hpp"

namespace sim::knot {

namespace {

struct Edge {
    Vec3 a, b;
    int component, vertex;
    int place, count;  // among the edges of its component
    bool closed;
};

// Edges of some length; repeated vertices make none.
std::vector<Edge> edges_of(const std::vector<Component>& components, double nearest) {
    std::vector<Edge> edges;
    for (std::size_t c = 0; c < components.size(); ++c) {
        const auto& points = components[c].vertices;
        const std::size_t first = edges.size(), n = points.size();
        std::size_t start = 0;
        for (std::size_t i = 1; i <= (components[c].closed ? n : n - 1); ++i) {
            const Vec3 &a = points[start], &b = points[i % n];
            if ((b - a).norm() <= nearest) continue;
            edges.push_back({a, b, static_cast<int>(c), static_cast<int>(start), static_cast<int>(edges.size() - first),
                             0, components[c].closed});
            start = i;
        }
        for (std::size_t e = first; e < edges.size(); ++e) edges[e].count = static_cast<int>(edges.size() - first);
    }
    return edges;
}

bool follows(const Edge& e, const Edge& f) {
    return e.component == f.component &&
           (e.place + 1 == f.place || (e.closed && f.place == 0 && e.place + 1 == e.count));
}

bool folds_back(const Edge& e, const Edge& f, double nearest) {
    const Vec3 u = e.b - e.a, v = f.b - f.a;
    if (u.dot(v) >= 0.0) return false;
    const Vec3 shorter = u.norm() < v.norm() ? e.a : f.b;
    const Edge& longer = u.norm() < v.norm() ? f : e;
    return geometry::closest_points(shorter, shorter, longer.a, longer.b).distance_squared <= nearest * nearest;
}

bool meet(const Edge& e, const Edge& f, double nearest) {
    const bool ef = follows(e, f), fe = follows(f, e);
    if (ef || fe) return (ef && folds_back(e, f, nearest)) || (fe && folds_back(f, e, nearest));
    return geometry::closest_points(e.a, e.b, f.a, f.b).distance_squared <= nearest * nearest;
}

}  // namespace

std::optional<Touch> first_touch(const std::vector<Component>& components) {
    geometry::Box all;
    for (const Component& c : components)
        for (const Vec3& p : c.vertices) all.include(p);
    const double size = (all.high - all.low).maxCoeff(), nearest = same_place * size;
    const std::vector<Edge> edges = edges_of(components, nearest);
    std::vector<geometry::Box> boxes(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        boxes[i].include(edges[i].a);
        boxes[i].include(edges[i].b);
    }
    const ChainTree tree(boxes);
    long budget = 200000000;
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
        const Edge& e = edges[static_cast<std::size_t>(i)];
        int other = -1;
        const auto meets = [&](int j) {
            if (--budget < 0) return false;
            if (!meet(e, edges[static_cast<std::size_t>(j)], nearest)) return true;
            other = j;
            return false;
        };
        if (tree.visit_overlapping(boxes[static_cast<std::size_t>(i)].grown(nearest), i + 1, meets)) continue;
        if (other < 0) return std::nullopt;
        const Edge& f = edges[static_cast<std::size_t>(other)];
        return Touch{e.component, e.vertex, f.component, f.vertex};
    }
    return std::nullopt;
}

}  // namespace sim::knot
