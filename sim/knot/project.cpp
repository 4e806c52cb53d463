#include <algorithm>
#include <cmath>

#include "sim/knot/diagram.hpp"

namespace sim::knot {

namespace {

// Points of a sequence that fills the unit cube evenly (the R3 sequence, Roberts 2018), taken as
// directions. No sine is needed, and nothing lines up with an axis or a grid.
Eigen::Matrix3d view_matrix(int view) {
    const auto walk = [&](double step) { return 2 * std::fmod(0.5 + (view + 1) * step, 1.0) - 1; };
    const Vec3 z = Vec3(walk(0.8191725133961645), walk(0.6710436067037893), walk(0.5497004779019703)).normalized();
    const Vec3 x = z.cross(Vec3(0.31, 0.83, -0.47)).normalized();
    Eigen::Matrix3d rows;
    rows << x.transpose(), z.cross(x).transpose(), z.transpose();
    return rows;
}

struct Hit {
    int edge = 0;
    double place = 0;
    Passage passage;
};

double cross(const Vec3& a, const Vec3& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

Vec3 view_direction(int view) {
    return view_matrix(view).row(2);
}

Diagram project(const std::vector<Vec3>& polygon, int view) {
    const int n = static_cast<int>(polygon.size());
    const Eigen::Matrix3d rows = view_matrix(view);
    std::vector<Vec3> p;
    p.reserve(n + 1);
    for (const Vec3& v : polygon) p.push_back(rows * v);
    p.push_back(p.front());

    struct Edge {
        double low = 0, high = 0;
        int index = 0;
    };
    std::vector<Edge> edges;
    for (int i = 0; i < n; ++i)
        edges.push_back({std::min(p[i].x(), p[i + 1].x()), std::max(p[i].x(), p[i + 1].x()), i});
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low < b.low; });

    Diagram diagram;
    std::vector<Hit> hits;
    for (int e = 0; e < n; ++e)
        for (int f = e + 1; f < n && edges[f].low <= edges[e].high; ++f) {
            const int i = edges[e].index, j = edges[f].index;
            if ((i + 1) % n == j || (j + 1) % n == i) continue;
            const Vec3 u = p[i + 1] - p[i], w = p[j + 1] - p[j], r = p[j] - p[i];
            const double both = cross(u, w), s = cross(r, w), t = cross(r, u);
            // 0 < s/both < 1 and 0 < t/both < 1 without dividing.
            if (both == 0 || s * both < 0 || t * both < 0 || std::abs(s) > std::abs(both) ||
                std::abs(t) > std::abs(both))
                continue;
            const double at_i = s / both, at_j = t / both;
            const bool i_over = p[i].z() + at_i * u.z() > p[j].z() + at_j * w.z();
            const int id = static_cast<int>(diagram.sign.size());
            diagram.sign.push_back((both > 0) == i_over ? 1 : -1);
            hits.push_back({i, at_i, {id, i_over}});
            hits.push_back({j, at_j, {id, !i_over}});
        }
    std::sort(hits.begin(), hits.end(),
              [](const Hit& a, const Hit& b) { return a.edge != b.edge ? a.edge < b.edge : a.place < b.place; });
    diagram.words.emplace_back();
    for (const Hit& hit : hits) diagram.words.front().push_back(hit.passage);
    return diagram;
}

}  // namespace sim::knot
