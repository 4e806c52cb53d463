#include <cmath>

#include "sim/knot/chain_tree.hpp"
#include "sim/knot/curve.hpp"

namespace sim::knot {

namespace {

using geometry::Box;

// Sign of the volume of a, b, c, d; 0 when rounding could have changed it (bound after Shewchuk 1997, made simpler).
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double volume = u.dot(v.cross(w));
    const Vec3 m(std::abs(v.y() * w.z()) + std::abs(v.z() * w.y()), std::abs(v.z() * w.x()) + std::abs(v.x() * w.z()),
                 std::abs(v.x() * w.y()) + std::abs(v.y() * w.x()));
    const double unsure = 1e-15 * u.cwiseAbs().dot(m);
    return volume > unsure ? 1 : volume < -unsure ? -1 : 0;
}

// Whether the segment certainly misses the triangle; in doubt it does not.
bool misses(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& a, const Vec3& b) {
    const int sa = side(p, q, r, a), sb = side(p, q, r, b);
    if (sa != 0 && sa == sb) return true;
    const int s1 = side(a, b, p, q), s2 = side(a, b, q, r), s3 = side(a, b, r, p);
    const bool positive = s1 > 0 || s2 > 0 || s3 > 0, negative = s1 < 0 || s2 < 0 || s3 < 0;
    return positive && negative;
}

Box box_of(const Vec3& a, const Vec3& b) {
    Box box;
    box.include(a);
    box.include(b);
    return box;
}

class Sweep {
  public:
    explicit Sweep(const Polygons& polygons) : tree_(link(polygons)) {}

    int dropped() const { return dropped_; }

    void run(long& budget) {
        for (int i = 0; i < static_cast<int>(points_.size()) && budget > 0; ++i) {
            const int before = previous_[at(i)], after = next_[at(i)];
            if (before == after || previous_[at(before)] == after) continue;  // a triangle stays
            if (!empty(before, i, after, budget)) continue;
            next_[at(before)] = after, previous_[at(after)] = before;
            gone_[at(i)] = 1, ++dropped_;
            tree_.grow(before, box_of(points_[at(before)], points_[at(after)]));
        }
    }

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
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    ChainTree link(const Polygons& polygons) {
        std::vector<Box> boxes;
        for (const auto& polygon : polygons) {
            const int first = static_cast<int>(points_.size()), n = static_cast<int>(polygon.size());
            for (int i = 0; i < n; ++i) {
                points_.push_back(polygon[at(i)]);
                next_.push_back(first + (i + 1) % n);
                previous_.push_back(first + (i + n - 1) % n);
                boxes.push_back(box_of(polygon[at(i)], polygon[at((i + 1) % n)]));
            }
            ends_.push_back(points_.size());
        }
        gone_.assign(points_.size(), 0);
        return ChainTree(boxes);
    }

    // No edge but those at its corners meets the triangle. An edge that starts at a corner leaves its plane there.
    bool empty(int before, int i, int after, long& budget) const {
        const Vec3 &p = points_[at(before)], &q = points_[at(i)], &r = points_[at(after)];
        Box box = box_of(p, r);
        box.include(q);
        return tree_.visit_overlapping(box, 0, [&](int edge) {
            if (gone_[at(edge)]) return true;
            const int end = next_[at(edge)];
            if (edge == i || end == i || end == before || edge == after) return true;
            if (edge == before || end == after) return true;
            --budget;
            const Vec3 &a = points_[at(edge)], &b = points_[at(end)];
            return !box_of(a, b).overlaps(box) || misses(p, q, r, a, b);
        });
    }

    std::vector<Vec3> points_;
    std::vector<int> next_, previous_;
    std::vector<char> gone_;
    std::vector<std::size_t> ends_;
    int dropped_ = 0;
    ChainTree tree_;
};

}  // namespace

void drop_empty_triangles(Polygons& polygons) {
    for (long budget = 10000000; budget > 0;) {
        Sweep sweep(polygons);
        sweep.run(budget);
        if (sweep.dropped() == 0) return;
        polygons = sweep.result();
    }
}

}  // namespace sim::knot
