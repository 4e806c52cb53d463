#include <cmath>
#include <numbers>

#include "sim/geometry/portable_math.hpp"
#include "sim/rod/bend.hpp"
#include "sim/rod/rod.hpp"

namespace sim::rod {

// A vector across `from`, turned by the least rotation that brings `from` to `to`; both of unit length.
static Vec3 transported(const Vec3& v, const Vec3& from, const Vec3& to) {
    return v - v.dot(to) / (1 + from.dot(to)) * (from + to);
}

// A vector across the first link, carried along the rod to the last.
Vec3 Rod::along_rod(Vec3 across, const std::vector<Vec3>& x) const {
    Vec3 before = (x[1] - x[0]).normalized();
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
        const Vec3 now = (x[k + 1] - x[k]).normalized();
        across = transported(across, before, now);
        before = now;
    }
    return across;
}

// Directors are carried in time with the links at either end; what they then differ by along the rod is the twist that
// the rod's writhe took off.
std::array<Vec3, 2> Rod::directors_at(const std::vector<Vec3>& x) const {
    const std::size_t n = x.size() - 1;
    const auto carried = [&](const Vec3& director, std::size_t k) {
        return transported(director, (now_.nodes[k + 1] - now_.nodes[k]).normalized(), (x[k + 1] - x[k]).normalized());
    };
    return {carried(now_.directors[0], 0), carried(now_.directors[1], n - 1)};
}

double Rod::twist_at(const std::vector<Vec3>& x) const {
    if (!turn_) return 0;
    const auto directors = directors_at(x);
    const Vec3 along = along_rod(directors[0], x), axis = (x[x.size() - 1] - x[x.size() - 2]).normalized();
    const double angle = geometry::portable_atan2(axis.dot(along.cross(directors[1])), along.dot(directors[1]));
    // The turn that is nearest to the one before: no step turns a rod by half a turn.
    constexpr double whole = 2 * std::numbers::pi;
    return *turn_ + angle - whole * std::round((angle - now_.turned) / whole);
}

double Rod::twist_moment() const {
    return def_.twisting_stiffness() / twisted_length_ * now_.twist;
}

void Rod::add_twist() {
    for (std::size_t i = 1; i + 1 < now_.nodes.size(); ++i) {
        const auto second = Bend(now_.nodes[i] - now_.nodes[i - 1], now_.nodes[i + 1] - now_.nodes[i]).turn_by_nodes();
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = r; c < 3; ++c) matrix_.add(i - 1 + r, i - 1 + c, twist_moment() * second[r][c]);
    }
}

// How the writhe, and so the twist, changes with the nodes (Bergou et al. 2010, eq. 10).
void Rod::find_twist_gradient() {
    gradient_.assign(now_.nodes.size(), Vec3::Zero());
    for (std::size_t i = 1; i + 1 < now_.nodes.size(); ++i) {
        const Bend bend(now_.nodes[i] - now_.nodes[i - 1], now_.nodes[i + 1] - now_.nodes[i]);
        const Vec3 before = -0.5 / bend.la * bend.binormal(), after = 0.5 / bend.lb * bend.binormal();
        gradient_[i - 1] += before, gradient_[i] -= before + after, gradient_[i + 1] += after;
    }
}

}  // namespace sim::rod
