#include "sim/thread/contact/audit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/geometry/triangle_tree.hpp"

// An independent witness: it knows nothing of contacts, reach or bounds, only where every link was and is. Two segments
// whose ends move linearly can pass through each other only when the four ends are coplanar, so the volume they span,
// a cubic in time, has a root at which the segments meet ([Provot1997] for cloth edges).
namespace sim::thread::contact {

namespace {

struct Moving {
    Vec3 a0, b0, a1, b1;  ///< Ends before and after.

    Vec3 a(double t) const { return a0 + t * (a1 - a0); }
    Vec3 b(double t) const { return b0 + t * (b1 - b0); }
    Box swept() const {
        Box box;
        for (const Vec3* p : {&a0, &b0, &a1, &b1}) box.include(*p);
        return box;
    }
};

double volume(const Moving& p, const Moving& q, double t) {
    return (p.b(t) - p.a(t)).cross(q.b(t) - q.a(t)).dot(q.a(t) - p.a(t));
}

// At the moment the four points are coplanar: do the segments meet? Each must have its ends on both sides of the other.
bool meet_at(const Moving& p, const Moving& q, double t) {
    const Vec3 u = p.b(t) - p.a(t), v = q.b(t) - q.a(t), r = q.a(t) - p.a(t), normal = u.cross(v);
    const double nn = normal.squaredNorm();
    if (nn == 0) return false;  // parallel: they slide along each other and part the same way
    const double s = r.cross(v).dot(normal) / nn, w = r.cross(u).dot(normal) / nn;
    return s >= 0 && s <= 1 && w >= 0 && w <= 1;
}

double root_between(const Moving& p, const Moving& q, double low, double high) {
    const bool rising = volume(p, q, low) < 0;
    for (int i = 0; i < 60; ++i) {  // bisection to the last bit of a time in [0, 1]
        const double middle = 0.5 * (low + high);
        ((volume(p, q, middle) < 0) == rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// Crossed once or thrice is a pass-through; twice is in and out again, which counts too: it must never happen at all.
int crossings(const Moving& p, const Moving& q) {
    // The cubic through its values at 0, 1/3, 2/3, 1; its turning points split [0, 1] into monotone pieces.
    const double f0 = volume(p, q, 0), f1 = volume(p, q, 1.0 / 3), f2 = volume(p, q, 2.0 / 3), f3 = volume(p, q, 1);
    const double c1 = -5.5 * f0 + 9 * f1 - 4.5 * f2 + f3, c2 = 9 * f0 - 22.5 * f1 + 18 * f2 - 4.5 * f3;
    const double c3 = 4.5 * (f3 - f0) + 13.5 * (f1 - f2);
    std::array<double, 4> cut{0, 1, 1, 1};
    int cuts = 1;
    const double disc = c2 * c2 - 3 * c1 * c3;
    if (disc > 0) {
        const double q_root = -(c2 + (c2 < 0 ? -1 : 1) * std::sqrt(disc));
        for (const double t : {c3 != 0 ? q_root / (3 * c3) : -1.0, q_root != 0 ? c1 / q_root : -1.0})
            if (t > 0 && t < 1) cut[static_cast<std::size_t>(cuts++)] = t;
    }
    cut[static_cast<std::size_t>(cuts)] = 1;
    std::sort(cut.begin(), cut.begin() + cuts + 1);
    int met = 0;
    for (int i = 0; i < cuts; ++i) {
        const double low = cut[static_cast<std::size_t>(i)], high = cut[static_cast<std::size_t>(i + 1)];
        if ((volume(p, q, low) < 0) == (volume(p, q, high) < 0)) continue;
        if (meet_at(p, q, root_between(p, q, low, high))) ++met;
    }
    return met;
}

// Cheap and certain: what starts farther apart than both can move along any axis cannot meet.
bool apart(const Box& a, const Box& b) {
    return !a.overlaps(b);
}

Box box_of(const geometry::Triangle& tri) {
    Box box;
    for (const Vec3* corner : {&tri.a, &tri.b, &tri.c}) box.include(*corner);
    return box;
}

bool pierces(const Moving& p, const geometry::Triangle& tri) {
    // A static triangle: the ends' paths and the final link against it. A link that slid over an edge shows at its ends
    // or in its final place, for it cannot leave a closed surface again within one substep.
    const auto through = [&](const Vec3& from, const Vec3& to) {
        const Vec3 normal = (tri.b - tri.a).cross(tri.c - tri.a);
        const double h0 = normal.dot(from - tri.a), h1 = normal.dot(to - tri.a);
        if ((h0 < 0) == (h1 < 0)) return false;
        const Vec3 hit = from + h0 / (h0 - h1) * (to - from);
        const auto inside = [&](const Vec3& u, const Vec3& v) { return (v - u).cross(hit - u).dot(normal) >= 0; };
        return inside(tri.a, tri.b) && inside(tri.b, tri.c) && inside(tri.c, tri.a);
    };
    return through(p.a0, p.a1) || through(p.a1, p.b1);
}

/// Where each link was and is.
Moving link_of(const State& state, int i) {
    const auto k = static_cast<std::size_t>(i);
    return {state.before[k], state.before[k + 1], state.nodes[k], state.nodes[k + 1]};
}

constexpr int block = 8;  // links, whose boxes are joined in one

}  // namespace

Audit::Audit(std::size_t most_links) {
    for (auto* boxes : {&boxes_, &swept_by_}) boxes->reserve(most_links);
}

// Links in blocks of eight: boxes of blocks first, then of links. Plain and separate from the link tree.
int Audit::count_pass_throughs(const State& state) {
    measure(state);
    return count_strands(state) + count_capsules(state) + count_surface(state);
}

void Audit::measure(const State& state) {
    const int n = state.links(), blocks = (n + block - 1) / block;
    boxes_.assign(static_cast<std::size_t>(blocks), Box{});
    swept_by_.resize(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        swept_by_[static_cast<std::size_t>(i)] = {};
        if (state.is_cut(static_cast<std::size_t>(i))) continue;  // nothing: meets nothing
        swept_by_[static_cast<std::size_t>(i)] = link_of(state, i).swept();
        boxes_[static_cast<std::size_t>(i / block)].include(swept_by_[static_cast<std::size_t>(i)]);
    }
}

int Audit::count_strands(const State& state) const {
    const int n = state.links(), blocks = static_cast<int>(boxes_.size());
    int met = 0;
    for (int p = 0; p < blocks; ++p)
        for (int q = p; q < blocks; ++q) {
            if (apart(boxes_[static_cast<std::size_t>(p)], boxes_[static_cast<std::size_t>(q)])) continue;
            for (int i = p * block; i < std::min(n, (p + 1) * block); ++i) {
                const Box& swept = swept_by_[static_cast<std::size_t>(i)];
                for (int j = std::max(i + 2, q * block); j < std::min(n, (q + 1) * block); ++j)
                    if (!(state.sleeps(i) && state.sleeps(j)) && !apart(swept, swept_by_[static_cast<std::size_t>(j)]))
                        met += crossings(link_of(state, i), link_of(state, j));
            }
        }
    return met;
}

int Audit::count_capsules(const State& state) const {
    const int n = state.links(), blocks = static_cast<int>(boxes_.size());
    int met = 0;
    for (std::size_t c = 0; c < state.capsules.size(); ++c) {
        const Capsule &from = state.capsules_before[c], &to = state.capsules[c];
        const Moving core{from.a, from.b, to.a, to.b};
        const Box swept = core.swept();
        for (int p = 0; p < blocks; ++p) {
            if (apart(boxes_[static_cast<std::size_t>(p)], swept)) continue;
            for (int i = p * block; i < std::min(n, (p + 1) * block); ++i)
                if (!apart(swept_by_[static_cast<std::size_t>(i)], swept)) met += crossings(link_of(state, i), core);
        }
    }
    return met;
}

int Audit::count_surface(const State& state) {
    if (!state.input.surface) return 0;
    const int n = state.links(), blocks = static_cast<int>(boxes_.size());
    int met = 0;
    for (int p = 0; p < blocks; ++p) {
        found_.clear();
        state.input.surface->near(boxes_[static_cast<std::size_t>(p)], found_);
        for (const int t : found_) {
            const geometry::Triangle& tri = (*state.input.surface)[t];
            const Box box = box_of(tri);
            for (int i = p * block; i < std::min(n, (p + 1) * block); ++i)
                if (!apart(box, swept_by_[static_cast<std::size_t>(i)])) met += pierces(link_of(state, i), tri);
        }
    }
    return met;
}

}  // namespace sim::thread::contact
