#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/knot/chain_tree.hpp"
#include "sim/knot/curve.hpp"

namespace sim::knot {

namespace {

using geometry::Box;

constexpr double plain = 1e-7;  // of the curve's size: a hundred times what in_general_position displaces

// Sign of the volume of a, b, c, d: +-2 when it is plain, +-1 when a ten-millionth would change it, 0 when rounding
// could have (bound after Shewchuk 1997, made simpler).
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double volume = u.dot(v.cross(w));
    const Vec3 m(std::abs(v.y() * w.z()) + std::abs(v.z() * w.y()), std::abs(v.z() * w.x()) + std::abs(v.x() * w.z()),
                 std::abs(v.x() * w.y()) + std::abs(v.y() * w.x()));
    const double size = u.cwiseAbs().dot(m), magnitude = std::abs(volume);
    const int sure = magnitude > plain * size ? 2 : magnitude > 1e-15 * size ? 1 : 0;
    return volume > 0 ? sure : -sure;
}

// How an edge a-b passes the triangle p, q, r: 2 it certainly misses it, by far; 1 it misses it, perhaps closely; 0 in
// doubt.
int misses(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& a, const Vec3& b) {
    const int sa = side(p, q, r, a), sb = side(p, q, r, b);
    if (sa * sb > 0) return std::min(std::abs(sa), std::abs(sb));
    const int s1 = side(a, b, p, q), s2 = side(a, b, q, r), s3 = side(a, b, r, p);
    const int positive = std::max({s1, s2, s3, 0}), negative = std::min({s1, s2, s3, 0});
    return std::min(positive, -negative);
}

Box box_of(const Vec3& a, const Vec3& b) {
    Box box;
    box.include(a);
    box.include(b);
    return box;
}

// The polygons' vertices, their edges in a tree. Edge i leads from vertex i to the next that is left.
class Sweep {
  public:
    Sweep(const Polygons& polygons, const std::vector<bool>& pinned) : tree_(link(polygons, pinned)) {}

    // Whether any vertex went.
    bool run(long& budget) {
        const int before = dropped_;
        int kept = -1;
        for (int i = 0; i < static_cast<int>(points_.size()) && budget > 0; ++i) {
            if (gone_[at(i)] || pinned_[at(i)] || i == kept) continue;
            const int last = previous_[at(i)], next = next_[at(i)];
            if (last == next || previous_[at(last)] == next) continue;  // a triangle stays
            if (!empty(last, i, next, budget)) continue;
            next_[at(last)] = next, previous_[at(next)] = last;
            gone_[at(i)] = 1, ++dropped_;
            kept = next;
            tree_.grow(last, box_of(points_[at(last)], points_[at(next)]));
        }
        return dropped_ > before;
    }

    // Boxes of edges that went are in the tree still; where they are the most a new tree is quicker.
    bool is_sparse() const { return 2 * dropped_ > static_cast<int>(points_.size()); }

    Polygons result() const {
        Polygons polygons;
        std::size_t i = 0;
        for (const std::size_t end : ends_) {
            auto& polygon = polygons.emplace_back();
            for (; i < end; ++i)
                if (!gone_[i]) polygon.push_back(points_[i]);
        }
        return polygons;
    }

  private:
    ChainTree link(const Polygons& polygons, const std::vector<bool>& pinned) {
        std::vector<Box> boxes;
        for (std::size_t c = 0; c < polygons.size(); ++c) {
            const auto& polygon = polygons[c];
            const int first = static_cast<int>(points_.size()), n = static_cast<int>(polygon.size());
            for (int i = 0; i < n; ++i) {
                points_.push_back(polygon[at(i)]);
                next_.push_back(first + (i + 1) % n);
                previous_.push_back(first + (i + n - 1) % n);
                boxes.push_back(box_of(polygon[at(i)], polygon[at((i + 1) % n)]));
            }
            ends_.push_back(points_.size());
            pinned_.resize(points_.size(), 0);
            if (c < pinned.size() && pinned[c] && n > 0) pinned_[at(first)] = pinned_.back() = 1;
        }
        gone_.assign(points_.size(), 0);
        blocker_.assign(points_.size(), -1);
        return ChainTree(boxes);
    }

    // No edge but those at its corners meets the triangle. An edge that starts at a corner leaves its plane there. What
    // was in the way last time most often still is. Nor does one come so near the edge that is to be that views could
    // not tell which is over which: in drawings on a grid many would lie upon each other but for the 1e-9 of
    // in_general_position.
    bool empty(int before, int i, int after, long& budget) {
        const Vec3 &p = points_[at(before)], &q = points_[at(i)], &r = points_[at(after)];
        Box box = box_of(p, r);
        box.include(q);
        const auto lets_pass = [&](int edge) {
            if (gone_[at(edge)]) return true;
            const int end = next_[at(edge)];
            if (edge == i || end == i || end == before || edge == after) return true;
            if (edge == before || end == after) return true;
            --budget;
            const Vec3 &a = points_[at(edge)], &b = points_[at(end)];
            if (!box_of(a, b).overlaps(box)) return true;
            const int missed = misses(p, q, r, a, b);
            return missed == 2 ||
                   (missed == 1 && geometry::closest_points(p, r, a, b).distance_squared > plain * plain);
        };
        int& blocker = blocker_[at(i)];
        if (blocker >= 0 && !lets_pass(blocker)) return false;
        blocker = -1;
        return tree_.visit_overlapping(box, 0, [&](int edge) {
            if (lets_pass(edge)) return true;
            blocker = edge;
            return false;
        });
    }

    std::vector<Vec3> points_;
    std::vector<int> next_, previous_, blocker_;
    std::vector<char> gone_, pinned_;
    std::vector<std::size_t> ends_;
    int dropped_ = 0;
    ChainTree tree_;
};

}  // namespace

void drop_empty_triangles(Polygons& polygons, const std::vector<bool>& pinned) {
    for (long budget = 10000000; budget > 0;) {
        Sweep sweep(polygons, pinned);
        bool more = sweep.run(budget);
        while (more && !sweep.is_sparse()) more = sweep.run(budget);
        polygons = sweep.result();
        if (!more) return;
    }
}

}  // namespace sim::knot
