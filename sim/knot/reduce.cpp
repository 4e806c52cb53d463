#include "sim/knot/reduce.hpp"

#include <algorithm>
#include <cstdint>

namespace sim::knot {

namespace {

// A number in [-1, 1) from a counter: splitmix64 [Steele2014].
double scatter(std::uint64_t counter) {
    std::uint64_t z = (counter + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1.0;
}

// Six times the signed volume of a tetrahedron.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
}

bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    if ((volume(a, b, c, p) > 0) == (volume(a, b, c, q) > 0)) return false;
    const bool ab = volume(p, q, a, b) > 0, bc = volume(p, q, b, c) > 0, ca = volume(p, q, c, a) > 0;
    return ab == bc && bc == ca;
}

bool is_free(const std::vector<Vec3>& p, size_t i) {
    const size_t n = p.size(), before = (i + n - 1) % n, after = (i + 1) % n;
    const Vec3 &a = p[before], &b = p[i], &c = p[after];
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (size_t j = 0; j < n; ++j) {
        const size_t k = j + 1 == n ? 0 : j + 1;
        const Vec3 &u = p[j], &v = p[k];
        if ((u.x() < low.x() && v.x() < low.x()) || (u.x() > high.x() && v.x() > high.x()) ||
            (u.y() < low.y() && v.y() < low.y()) || (u.y() > high.y() && v.y() > high.y()) ||
            (u.z() < low.z() && v.z() < low.z()) || (u.z() > high.z() && v.z() > high.z()))
            continue;
        // Edges that start at a corner of the triangle leave its plane there and cannot come back.
        if (j == before || j == i || k == before || j == after) continue;
        if (pierces(u, v, a, b, c)) return false;
    }
    return true;
}

using Polygon = std::vector<Vec3>;

Polygon cut(const Polygon& polygon, const Vec3& normal) {
    Polygon kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = normal.dot(a), at_b = normal.dot(b);
        if (at_a > 0) kept.push_back(a);
        if ((at_a > 0) != (at_b > 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    return kept;
}

Polygon serving_directions(const std::vector<Vec3>& curve, size_t end, int axis, int side) {
    Polygon square;
    for (const auto& [u, w] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        Vec3 corner;
        corner[axis] = side, corner[(axis + 1) % 3] = u, corner[(axis + 2) % 3] = w;
        square.push_back(corner);
    }
    for (size_t i = 0; i < curve.size() && !square.empty(); ++i)
        if (i != end) square = cut(square, curve[end] - curve[i]);
    return square;
}

}  // namespace

std::vector<Vec3> general_position(const std::vector<Vec3>& curve) {
    Vec3 low = curve.front(), high = curve.front();
    for (const Vec3& v : curve) low = low.cwiseMin(v), high = high.cwiseMax(v);
    const double extent = (high - low).maxCoeff(), scale = extent > 0 ? 1 / extent : 1;
    std::vector<Vec3> result;
    result.reserve(curve.size());
    for (size_t i = 0; i < curve.size(); ++i) {
        if (i > 0 && curve[i] == curve[i - 1]) continue;
        const std::uint64_t seed = 3 * i;
        const Vec3 noise(scatter(seed), scatter(seed + 1), scatter(seed + 2));
        result.push_back(scale * (curve[i] - (low + high) / 2) + 1e-8 * noise);
    }
    return result;
}

// A direction d serves if d . (tip - v) > 0 for every other vertex v. On each face of a cube the directions that serve
// are a square cut by one line a vertex: exact, and no search.
std::optional<Vec3> outward(const std::vector<Vec3>& curve, size_t end) {
    std::optional<Vec3> best;
    double best_size = 0;
    for (int face = 0; face < 6; ++face) {
        const Polygon polygon = serving_directions(curve, end, face / 2, face % 2 ? -1 : 1);
        if (polygon.size() < 3) continue;
        Vec3 middle = Vec3::Zero();
        for (const Vec3& d : polygon) middle += d;
        middle /= static_cast<double>(polygon.size());
        double size = 0;
        for (const Vec3& d : polygon) size = std::max(size, (d - middle).squaredNorm());
        if (size > best_size) best_size = size, best = middle.normalized();
    }
    return best;
}

std::vector<Vec3> join_ends(std::vector<Vec3> curve, const Vec3& first, const Vec3& last) {
    const double far = 10;  // The curve has extent 1: straight lines between points this far out pass it by.
    const Vec3 a = curve.front() + far * first, b = curve.back() + far * last;
    curve.push_back(b);
    if (first.dot(last) < 0) {  // More than a right angle apart: go round.
        Vec3 side = first.cross(last);
        if (side.norm() < 0.1) side = first.cross(first.cwiseAbs().x() < 0.6 ? Vec3::UnitX() : Vec3::UnitY());
        curve.push_back(far * side.normalized());
    }
    curve.push_back(a);
    return curve;
}

std::vector<Vec3> drop_free_vertices(std::vector<Vec3> polygon) {
    for (size_t since_last = 0, i = 0; polygon.size() > 3 && since_last <= polygon.size();) {
        i %= polygon.size();
        if (is_free(polygon, i)) {
            polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
            since_last = 0;
        } else {
            ++since_last;
        }
        ++i;  // Leave the neighbour for the next round, so that triangles stay small.
    }
    return polygon;
}

}  // namespace sim::knot
