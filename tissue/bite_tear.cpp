// Holes that tear out.
#include <algorithm>
#include <cmath>

#include "sim/geometry/closest_points.hpp"
#include "tissue/bite.hpp"

namespace tissue {

double Bites::from_cut(const MaterialPoint& point) const {
    constexpr double most = 3e-3;  // [m], to where retention grows with the bite
    const Tetrahedron& tet = tetrahedra_[static_cast<std::size_t>(point.tetrahedron)];
    Vec3 at = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) at += point.weights[k] * rest_[static_cast<std::size_t>(tet[k])];
    double squared = most * most;
    for (const Triangle& triangle : cut_) squared = std::min(squared, sim::geometry::closest_points(at, at, triangle).distance_squared);
    return std::sqrt(squared);
}

double Bites::bears(const Bite& bite) const {
    return def_.retention * def_.wall * std::max(from_cut(bite.entry.at), bite.exit.hole >= 0 ? from_cut(bite.exit.at) : 0);
}

bool Bites::pull(int hole, double force) {
    for (std::size_t i = bites_.size(); i-- > 0;) {
        const Bite& bite = bites_[i];
        if (bite.entry.hole != hole && bite.exit.hole != hole) continue;
        if (!bite.torn && bite.state == BiteState::open && force > bears(bite)) tear(static_cast<int>(i), force);
        return bites_[i].torn;
    }
    return false;
}

void Bites::tear(int number, double force) {
    Bite& bite = bites_[static_cast<std::size_t>(number)];
    bite.torn = true, bite.on_needle = false;
    const auto gone = std::remove_if(crossings_.begin(), crossings_.end(), [&](const Crossing& crossing) { return crossing.bite == number; });
    crossings_.erase(gone, crossings_.end());
    touch_.active = false;
    events_.push_back({BiteEvent::torn, number, force});
}

}  // namespace tissue
