#include "sim/knot/projection.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sim/geometry/at.hpp"

namespace sim::knot {

namespace {

struct Edge {
    Vec3 a, b;  // x, y in the picture, z towards the viewer
    int strand, index, count;
    double low_x() const { return std::min(a.x(), b.x()); }
    double high_x() const { return std::max(a.x(), b.x()); }
};

struct Hit {
    double place;  // along the edge, 0 to 1
    int strand, index, crossing;
    bool over;
};

// Twice the area of a triangle in the picture, and by how much rounding may have changed it.
struct Area {
    double value, error;
    bool is_sure() const { return std::abs(value) > error; }
};

Area area(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
    return {left - right, 1e-14 * (std::abs(left) + std::abs(right))};
}

bool same_side(const Area& a, const Area& b) {
    return a.is_sure() && b.is_sure() && (a.value > 0) == (b.value > 0);
}

std::vector<Edge> edges_seen(const Polygons& polygons, const Vec3& view) {
    const Vec3 right = view.unitOrthogonal(), up = view.cross(right);
    const auto seen = [&](const Vec3& p) { return Vec3(p.dot(right), p.dot(up), p.dot(view)); };
    std::vector<Edge> edges;
    for (std::size_t s = 0; s < polygons.size(); ++s) {
        const int n = static_cast<int>(polygons[s].size());
        for (int i = 0; i < n; ++i)
            edges.push_back({seen(polygons[s][at(i)]), seen(polygons[s][at((i + 1) % n)]), static_cast<int>(s), i, n});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.low_x() < f.low_x(); });
    return edges;
}

bool neighbours(const Edge& e, const Edge& f) {
    return e.strand == f.strand && ((e.index + 1) % e.count == f.index || (f.index + 1) % f.count == e.index);
}

// False when the pair is not generic.
bool cross(const Edge& e, const Edge& f, Diagram& diagram, std::vector<Hit>& hits) {
    if (std::max(e.a.y(), e.b.y()) < std::min(f.a.y(), f.b.y()) ||
        std::max(f.a.y(), f.b.y()) < std::min(e.a.y(), e.b.y()))
        return true;
    const Area fa = area(e.a, e.b, f.a), fb = area(e.a, e.b, f.b);
    if (same_side(fa, fb)) return true;
    const Area ea = area(f.a, f.b, e.a), eb = area(f.a, f.b, e.b);
    if (same_side(ea, eb)) return true;
    if (!fa.is_sure() || !fb.is_sure() || !ea.is_sure() || !eb.is_sure()) return false;
    const double s = ea.value / (ea.value - eb.value), t = fa.value / (fa.value - fb.value);
    const double rise_e = e.b.z() - e.a.z(), rise_f = f.b.z() - f.a.z();
    const double height = e.a.z() + s * rise_e - f.a.z() - t * rise_f;
    const double error = 1e-15 + std::abs(rise_e) * (ea.error + eb.error) / std::abs(ea.value - eb.value) +
                         std::abs(rise_f) * (fa.error + fb.error) / std::abs(fa.value - fb.value);
    if (std::abs(height) <= error) return false;
    const bool e_over = height > 0.0;
    const Vec3 de = e.b - e.a, df = f.b - f.a;
    const double turn = de.x() * df.y() - de.y() * df.x();
    const int crossing = diagram.crossings();
    diagram.sign.push_back((turn > 0.0) == e_over ? 1 : -1);
    hits.push_back({s, e.strand, e.index, crossing, e_over});
    hits.push_back({t, f.strand, f.index, crossing, !e_over});
    return true;
}

std::optional<Diagram> crossings_of(const std::vector<Edge>& edges, std::size_t strands, int most,
                                    std::vector<Hit>& hits) {
    Diagram diagram;
    diagram.strands.resize(strands);
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size() && edges[j].low_x() <= edges[i].high_x(); ++j) {
            if (neighbours(edges[i], edges[j])) continue;
            if (!cross(edges[i], edges[j], diagram, hits)) return std::nullopt;
            if (diagram.crossings() > most) return diagram;
        }
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return std::tie(a.strand, a.index, a.place) < std::tie(b.strand, b.index, b.place);
    });
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Hit& h = hits[i];
        // Places 1e-13 apart on one edge are within rounding of each other: their order is not known.
        if (i > 0 && hits[i - 1].strand == h.strand && hits[i - 1].index == h.index &&
            h.place - hits[i - 1].place < 1e-13)
            return std::nullopt;
        diagram.strands[at(h.strand)].push_back({h.crossing, h.over});
    }
    return diagram;
}

}  // namespace

std::optional<Diagram> project(const Polygons& polygons, const Vec3& view, int most) {
    std::vector<Hit> hits;
    return crossings_of(edges_seen(polygons, view), polygons.size(), most, hits);
}

std::optional<OpenDiagram> project_open(const std::vector<Vec3>& strand, const Vec3& view, int most) {
    std::vector<Edge> edges = edges_seen({strand}, view);
    std::erase_if(edges, [](const Edge& e) { return e.index == e.count - 1; });
    std::vector<Hit> hits;
    auto diagram = crossings_of(edges, 1, most, hits);
    if (!diagram || diagram->crossings() > most) return std::nullopt;
    OpenDiagram open{std::move(*diagram), {}};
    for (const Hit& h : hits) open.positions.push_back(h.index + h.place);
    return open;
}

}  // namespace sim::knot
