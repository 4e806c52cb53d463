// Holes that tear out.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/geometry/closest_points.hpp"
#include "tissue/bite.hpp"

namespace tissue {

Triangle Bites::cut_face(int face) const {
    const auto corner = [&](std::size_t k) -> const Vec3& {
        return rest_.nodes[static_cast<std::size_t>(rest_.faces[static_cast<std::size_t>(face)].nodes[k])];
    };
    return {corner(0), corner(1), corner(2)};
}

double Bites::from_cut(const MaterialPoint& point) const {
    constexpr double most = 3e-3;  // [m], to where retention grows with the bite
    const Vec3 at = position(point, rest_, rest_.nodes);
    double squared = most * most;
    for (const int face : cut_)
        squared = std::min(squared, (sim::geometry::closest_point(at, cut_face(face)) - at).squaredNorm());
    return std::sqrt(squared);
}

double Bites::bears(const Bite& bite) const {
    return def_.retention * def_.wall *
           std::max(from_cut(bite.entry.at), bite.exit.hole >= 0 ? from_cut(bite.exit.at) : 0);
}

bool Bites::pull(int number, double force, Skin& skin) {
    assert(number >= 0 && static_cast<std::size_t>(number) < bites_.size() && "a bite of this wall");
    const Bite& bite = bites_[static_cast<std::size_t>(number)];
    if (bite.torn || bite.state != BiteState::open || force <= bears(bite)) return bite.torn;
    tear(number, force);
    slit(bite, skin);
    return true;
}

// A slit is twice as wide as the hole: no rim keeps it open, and the wall, which is whole below, draws together.
constexpr double gapes = 2;

// Slits the skin straight from a hole to the rim of its side. Returns where the slit ends; for a hole in neither side,
// where the hole is.
Vec3 Bites::slit(const BiteEnd& end, Skin& skin) const {
    const Vec3 from = position(end.at, rest_, rest_.nodes);
    if (end.side != Side::outer && end.side != Side::inner) return from;
    Vec3 to = from;
    double least = -1;
    for (const Rim& rim : end.side == Side::outer ? outer_ : inner_) {
        const RimPoint point = nearest(rim, rest_, from);
        if (least < 0 || point.distance < least) least = point.distance, to = position(rim, point.place, rest_.nodes);
    }
    if (least > 0) skin.slit(skin.face_of_hole(end.hole), from, to, gapes * skin.radius(end.hole));
    return to;
}

// Slits both skins and, from the end of the one slit to that of the other, the cut.
void Bites::slit(const Bite& bite, Skin& skin) const {
    const Vec3 from = slit(bite.entry, skin), to = slit(bite.exit, skin), middle = 0.5 * (from + to);
    int nearest_face = -1;
    double least = 0;
    for (const int face : cut_) {
        const double squared = (sim::geometry::closest_point(middle, cut_face(face)) - middle).squaredNorm();
        if (nearest_face < 0 || squared < least) nearest_face = face, least = squared;
    }
    if (nearest_face >= 0) skin.slit(nearest_face, from, to, gapes * def_.hole);
}

void Bites::tear(int number, double force) {
    Bite& bite = bites_[static_cast<std::size_t>(number)];
    bite.torn = true, bite.on_needle = false;
    const auto gone = std::remove_if(crossings_.begin(), crossings_.end(),
                                     [&](const Crossing& crossing) { return crossing.bite == number; });
    crossings_.erase(gone, crossings_.end());
    touch_.active = false;
    events_.push_back({BiteEvent::torn, number, force});
}

}  // namespace tissue
