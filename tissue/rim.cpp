// Closed lines of edges between two sides of a wall, walked from edge to edge.
#include "tissue/rim.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "sim/geometry/closest_points.hpp"

namespace tissue {

namespace {

struct Edge {
    const Vec3 &from, &to;
    double length() const { return (to - from).norm(); }
};

Edge edge(const Rim& rim, std::size_t k, std::span<const Vec3> nodes) {
    const auto at = [&](std::size_t i) -> const Vec3& {
        return nodes[static_cast<std::size_t>(rim.nodes[i % rim.nodes.size()])];
    };
    return {at(k), at(k + 1)};
}

void measure(Rim& rim, std::span<const Vec3> nodes) {
    for (std::size_t k = 0; k < rim.nodes.size(); ++k) {
        rim.places.push_back(rim.length);
        rim.length += edge(rim, k, nodes).length();
    }
}

}  // namespace

std::vector<Rim> rims(const Mesh& rest, Side side) {
    const auto each_edge = [&](Side of, const auto& use) {
        for (const Face& face : rest.faces)
            for (std::size_t k = 0; k < 3 && face.side == of; ++k) use(face.nodes[k], face.nodes[(k + 1) % 3]);
    };
    std::set<std::pair<int, int>> others;
    each_edge(side, [&](int from, int to) { others.emplace(from, to); });
    std::map<int, int> next;
    each_edge(Side::cut, [&](int from, int to) {
        if (others.contains({to, from})) next.emplace(from, to);  // neighbours go along their edge opposite ways
    });
    std::vector<Rim> found;
    while (!next.empty()) {
        Rim rim;
        int node = next.begin()->first;
        for (auto here = next.find(node); here != next.end(); here = next.find(node)) {
            rim.nodes.push_back(node);
            node = here->second;
            next.erase(here);
        }
        if (node != rim.nodes.front()) continue;
        measure(rim, rest.nodes);
        found.push_back(std::move(rim));
    }
    return found;
}

RimPoint nearest(const Rim& rim, const Mesh& rest, const Vec3& point) {
    assert(!rim.nodes.empty() && "a rim of something");
    double place = 0, least = -1;
    for (std::size_t k = 0; k < rim.nodes.size(); ++k) {
        const Edge e = edge(rim, k, rest.nodes);
        const auto pair = sim::geometry::closest_points(e.from, e.to, point, point);
        if (least < 0 || pair.distance_squared < least)
            least = pair.distance_squared, place = rim.places[k] + pair.s * e.length();
    }
    return {place < rim.length ? place : 0, std::sqrt(std::max(0.0, least))};
}

Vec3 position(const Rim& rim, double place, std::span<const Vec3> nodes) {
    assert(rim.length > 0 && std::isfinite(place));
    place -= rim.length * std::floor(place / rim.length);
    const std::size_t k =
        static_cast<std::size_t>(std::upper_bound(rim.places.begin(), rim.places.end(), place) - rim.places.begin()) -
        1;
    const double from = rim.places[k], to = k + 1 < rim.places.size() ? rim.places[k + 1] : rim.length;
    const Edge e = edge(rim, k, nodes);
    return e.from + (to > from ? std::min(1.0, (place - from) / (to - from)) : 0) * (e.to - e.from);
}

double length(const Rim& rim, std::span<const Vec3> nodes) {
    double sum = 0;
    for (std::size_t k = 0; k < rim.nodes.size(); ++k) sum += edge(rim, k, nodes).length();
    return sum;
}

Vec3 middle(const Rim& rim, std::span<const Vec3> nodes) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < rim.nodes.size(); ++k) {
        const Edge e = edge(rim, k, nodes);
        sum += 0.5 * e.length() * (e.from + e.to);
    }
    return sum / length(rim, nodes);
}

}  // namespace tissue
