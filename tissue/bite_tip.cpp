// A needle's tip and the skin that it has not pierced yet.
#include <algorithm>
#include <cmath>

#include "sim/geometry/closest_points.hpp"
#include "tissue/bite.hpp"

namespace tissue {

// The direction in which the tip pushes the wall, unit.
Vec3 Bites::direction_of_touch(const Skin& skin) const {
    const Vec3 up = skin.normal_of_face(touch_.face);
    return touch_.inwards ? Vec3(-up) : up;
}

// Pressure grows with how far the tip has gone past the skin's point; friction is limited to its share of that.
Vec3 Bites::touch_force(const Skin& skin) const {
    const Vec3 direction = direction_of_touch(skin), off = touch_.tip - skin.at_face(touch_.face, touch_.weights);
    const double deep = std::max(0.0, off.dot(direction)), most = def_.grip * deep;
    const Vec3 across = off - off.dot(direction) * direction;
    const double far = across.norm();
    return def_.tip_stiffness * (deep * direction + (far > most ? most / far : 1) * across);
}

void Bites::touch_at(const Skin& skin, const Skin::Spot& spot) {
    const int face = skin.face(spot.triangle);
    touch_ = {.active = true,
              .inwards = !tip_is_in_wall(),
              .face = face,
              .weights = skin.weights_in_face(face, spot.at),
              .first_side = skin.side_of_face(face),
              .first_normal = skin.normal_of_face(face),
              .first_direction = needle_.tangent(needle_.length()),
              .tip = needle_.tip()};
}

// Advances the touch to the needle's tip, or to where the last step foretells that the skin gives way: a quick needle's
// step would go far beyond.
void Bites::advance_touch() {
    const Vec3 gone = needle_.tip() - touch_.tip;
    const double far = gone.norm(), more = touch_.gain * far, lacks = def_.puncture - touch_.force;
    touch_.gives_way = more > lacks;
    const double share = touch_.gives_way ? lacks / more : 1;
    touch_.tip += share * gone;
    touch_.gone = share * far;
}

void Bites::settle_touch(Skin& skin) {
    const Vec3 on_wall = touch_force(skin);
    const double force = touch_.is_through ? touch_.force : on_wall.norm();
    force_ -= on_wall;
    constexpr double nearly = 0.9;  // where more is lacking, the wall gives way instead
    if (!touch_.is_through && force < def_.puncture && !(touch_.gives_way && force > nearly * def_.puncture)) {
        if (touch_.gone > 0 && !touch_.gives_way) touch_.gain = std::max(0.0, force - touch_.force) / touch_.gone;
        touch_.force = force;
        return;
    }
    const int hole = skin.pierce(touch_.face, skin.at_face(touch_.face, touch_.weights),
                                 needle_.tangent(needle_.length()), def_.hole);
    cross(skin, hole, touch_.inwards, touch_.first_normal, touch_.first_direction, force);
}

// The touched point follows the tip as far as friction does not hold it. False where the tip has left the wall, or an
// edge of it.
bool Bites::stays(const Skin& skin) {
    const Vec3 direction = direction_of_touch(skin), off = touch_.tip - skin.at_face(touch_.face, touch_.weights);
    const double deep = off.dot(direction), most = def_.grip * deep;
    const Vec3 across = off - deep * direction;
    const double far = across.norm();
    if (deep <= 0 || far <= most) return deep > 0;
    const Vec3 goal = touch_.tip - deep * direction - most / far * across;
    const Skin::Spot spot = skin.closest(goal, goal, far + deep, touch_.inwards ? Vec3(-direction) : direction);
    const bool found = spot.triangle >= 0 && spot.distance < deep + def_.hole;
    touch_.face = found ? skin.face(spot.triangle) : -1;
    if (!found) return false;
    touch_.weights = skin.weights_in_face(touch_.face, spot.at);
    return (touch_.tip - spot.at).dot(direction_of_touch(skin)) > 0;
}

// A wall that gives way, or that is met flat, is pierced by however little force once the tip is out again on the other
// side, or a wall's thickness beyond a skin.
bool Bites::goes_through(const Skin& skin) {
    const Vec3 tip = needle_.tip();
    const bool is_out = !touch_.active && touch_.inwards && !is_in_wall(rest_.tetrahedra, skin.nodes(), tip);
    if (touch_.active && (tip - skin.at_face(touch_.face, touch_.weights)).norm() <= def_.wall) return false;
    const Skin::Spot spot = behind_tip(skin);
    if (spot.triangle < 0 || (!is_out && (tip - spot.at).norm() <= def_.wall)) return false;
    const int face = skin.face(spot.triangle);
    if (is_out && from_cut(skin.point_of_face(face, skin.weights_in_face(face, spot.at))) < def_.wall)
        return false;  // the wall is pressed off over the cut
    const double force = touch_.force;
    touch_at(skin, spot);
    touch_.tip = spot.at, touch_.force = force, touch_.is_through = true;
    return true;
}

// The same edge may slip off a tip several times: it is told once within a wall's thickness.
void Bites::slide_touch(const Skin& skin) {
    touch_.active = stays(skin);
    if (goes_through(skin)) return;
    const bool on_first_side = touch_.face >= 0 && skin.side_of_face(touch_.face) == touch_.first_side;
    if (touch_.active || on_first_side || !touch_.inwards || (touch_.tip - slipped_at_).norm() < def_.wall) return;
    slipped_at_ = touch_.tip;
    events_.push_back({BiteEvent::slipped, -1, touch_.force});
}

// Where the wire comes through a skin, looking back from the tip along it, at most to the last hole: walls may have
// moved onto it.
Skin::Spot Bites::behind_tip(const Skin& skin) const {
    constexpr double length = 2e-3;  // [m], beyond what a needle and a wall move in a step
    constexpr int pieces = 16;
    const double tip = needle_.length(),
                 end = std::max({0.0, tip - length, crossings_.empty() ? 0.0 : std::min(tip, crossings_.back().along)});
    const auto facing = tip_is_in_wall() ? Skin::Facing::along : Skin::Facing::against;
    Skin::Spot found;
    for (int k = 0; k < pieces && found.triangle < 0; ++k)
        found = skin.hit(needle_.at(tip + (end - tip) * (k + 1) / pieces), needle_.at(tip + (end - tip) * k / pieces),
                         facing);
    return found;
}

// A hole that the wire goes through next to its tip counts as if it were pierced anew; none: -1.
int Bites::hole_behind_tip(const Skin& skin) const {
    const double tip = needle_.length();
    int best = -1;
    double nearest = 0;
    for (int hole = 0; hole < skin.holes(); ++hole) {
        const bool taken =
            std::any_of(crossings_.begin(), crossings_.end(), [&](const Crossing& c) { return c.hole == hole; });
        const double reach = std::min(tip, 4 * skin.radius(hole));
        const auto pair =
            sim::geometry::closest_points(needle_.at(tip - reach), needle_.tip(), skin.centre(hole), skin.centre(hole));
        const bool fits = skin.normal_of_hole(hole).dot(needle_.tangent(tip)) * (tip_is_in_wall() ? 1 : -1) > 0;
        const double far = pair.distance_squared / (skin.radius(hole) * skin.radius(hole));
        if (!taken && fits && far < 1.2 && (best < 0 || far < nearest))
            best = hole, nearest = far;  // the corners of an octagon are that far out
    }
    return best;
}

void Bites::begin_touch(const Vec3& tip_before, const Skin& skin) {
    const bool was_in = tip_is_in_wall();
    Skin::Spot spot;
    if (!was_in) spot = skin.hit(tip_before, needle_.tip(), Skin::Facing::against);
    if (spot.triangle < 0 && is_in_wall(rest_.tetrahedra, skin.nodes(), needle_.tip()) == was_in) return;
    if (spot.triangle < 0) {
        const int hole = hole_behind_tip(skin);
        if (hole >= 0)
            return cross(skin, hole, !was_in, skin.normal_of_hole(hole), needle_.tangent(needle_.length()), 0);
        spot = behind_tip(skin);
    }
    if (spot.triangle < 0) spot = skin.closest(needle_.tip(), needle_.tip(), 1e-3);
    if (spot.triangle >= 0) touch_at(skin, spot);
}

}  // namespace tissue
