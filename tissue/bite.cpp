// A needle in a wall.
//
// Method: before the tip is through a skin, a spring with a friction cone stands for the dimple that the mesh does not
// resolve; at the puncture force a hole is opened. From then on each hole is held on the needle's arc by a spring
// across the wire, and along it by one that is capped by friction. All of these are PointForces of the wall's next
// implicit step, so that stiff springs stay stable. Cost: some 50 us a step where the needle is near.
#include "tissue/bite.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace tissue {

namespace {

double angle(double across, double along) {
    return across == 0 && along == 0 ? 0 : sim::geometry::portable_atan2(std::abs(across), std::abs(along));
}

// Place along the wire of its point nearest to `point`: of all turns the one next to `about` [m].
double place_on(const Arc& arc, const Vec3& point, double about) {
    const Vec3 out = point - arc.centre;
    const double x = out.dot(arc.to_tail), y = out.dot(arc.onwards), turn = 2 * EIGEN_PI * arc.radius;
    if (x == 0 && y == 0) return about;
    const double place = arc.radius * sim::geometry::portable_atan2(y, x);
    return place + turn * std::round((about - place) / turn);
}

// A dimple is so stiff that the tip is still in the wall when the skin gives way.
BiteDef with_shallow_dimple(BiteDef def) {
    constexpr double deepest = 0.6;  // of the wall
    def.tip_stiffness = std::max(def.tip_stiffness, def.puncture / (deepest * def.wall));
    return def;
}

}  // namespace

Bites::Bites(const BiteDef& def, const Mesh& rest)
    : def_(with_shallow_dimple(def)),
      shaft_({.stiffness = def.stiffness}),
      rest_(rest),
      outer_(rims(rest, Side::outer)),
      inner_(rims(rest, Side::inner)) {
    assert(def.puncture >= 0 && def.stiffness > 0 && def.tip_stiffness > 0 && def.hole > 0 && def.wall > 0);
    for (std::size_t f = 0; f < rest.faces.size(); ++f)
        if (rest.faces[f].side == Side::cut) cut_.push_back(static_cast<int>(f));
    constexpr std::size_t room = 64;
    crossings_.reserve(room), forces_.reserve(4 * room), bites_.reserve(room), events_.reserve(room),
        pulls_.reserve(room), wires_.reserve(room);
}

void Bites::press(const Arc* needle, const Skin& skin) {
    assert((!needle || (needle->radius > 0 && needle->wire > 0 && needle->angle > 0)) && "a needle, or none");
    forces_.clear(), events_.clear();
    if (!needle) return let_go();
    if (has_needle_ && (needle->tip() - needle_.tip()).norm() > 0.25 * needle->length()) let_go();
    const Arc before = has_needle_ ? needle_ : *needle;
    needle_ = *needle;
    has_needle_ = true;
    follow(skin);
    leave_by_tip();
    if (touch_.active) advance_touch(), slide_touch(skin);
    if (!touch_.active && !is_at_last_hole()) begin_touch(before.tip(), skin);
    if (touch_.active)
        forces_.push_back({skin.point_of_face(touch_.face, touch_.weights), touch_force(skin), def_.tip_stiffness});
    for (std::size_t i = 0; i < crossings_.size(); ++i) hold(i, skin);
    press_shaft(before, skin);
}

void Bites::settle(Skin& skin) {
    force_ = Vec3::Zero();
    skin.set_wires({});
    if (!has_needle_) return;
    follow(skin);
    pulls_.clear();
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
        const Crossing& crossing = crossings_[i];
        const double most = friction_of(i),
                     along = std::clamp(def_.stiffness * (crossing.held - crossing.along), -most, most);
        const Vec3 on_wall =
            crossing.along < 0 ? Vec3(Vec3::Zero())
                               : Vec3(def_.stiffness * aside(crossing, skin) + along * needle_.tangent(crossing.along));
        force_ -= on_wall;
        pulls_.push_back(on_wall.norm());
    }
    for (std::size_t i = pulls_.size(); i-- > 0;)
        if (i < crossings_.size()) pull(crossings_[i].bite, pulls_[i], skin);
    settle_shaft(skin);
    if (touch_.active) settle_touch(skin);
    leave_by_tip();
    leave_by_tail();
    measure(skin);
    give_rims_to_wire(skin);
}

// Rims in the needle's rear half are drawn onto the wire, for the thread that is swaged to it. While the tip is near, a
// rim is as the tip pierced it.
void Bites::give_rims_to_wire(Skin& skin) {
    wires_.clear();
    for (const Crossing& crossing : crossings_)
        if (crossing.along >= 0 && crossing.along < 0.5 * needle_.length())
            wires_.push_back({crossing.hole, needle_.at(crossing.along), needle_.tangent(crossing.along)});
    skin.set_wires(wires_);
}

// The needle is taken away: bites that were open stay so, one that was only pricked is empty.
void Bites::let_go() {
    for (const Crossing& crossing : crossings_) {
        Bite& bite = of(crossing);
        if (bite.state == BiteState::pricked) bite.state = BiteState::empty;
        bite.on_needle = false;
    }
    crossings_.clear();
    touch_.active = has_needle_ = false;
}

// Finds where the holes are along the wire now.
void Bites::follow(const Skin& skin) {
    for (Crossing& crossing : crossings_)
        crossing.along = place_on(needle_, skin.centre(crossing.hole), crossing.along);
}

// Friction of the wire in the wall, half at each skin; in a bite that is only pricked all at the one [N].
double Bites::friction_of(std::size_t i) const {
    const std::size_t entry = i - i % 2;
    const bool open = entry + 1 < crossings_.size();
    const double tail = std::max(0.0, crossings_[entry].along),
                 tip = std::min(needle_.length(), open ? crossings_[entry + 1].along : needle_.length());
    return def_.friction * std::max(0.0, tip - tail) * (open ? 0.5 : 1);
}

Vec3 Bites::aside(const Crossing& crossing, const Skin& skin) const {
    const double place = std::clamp(crossing.along, 0.0, needle_.length());
    const Vec3 off = needle_.at(place) - skin.centre(crossing.hole), direction = needle_.tangent(place);
    return off - off.dot(direction) * direction;
}

// Draws a hole onto the wire, and along with it as far as friction does. The stiffness counts even where the wire
// slides: a wall that is drawn along gives way before it is drawn too far.
void Bites::hold(std::size_t i, const Skin& skin) {
    Crossing& crossing = crossings_[i];
    if (crossing.along < 0) return;  // the hole is the thread's
    const double reach = friction_of(i) / def_.stiffness;
    crossing.held = crossing.along + std::clamp(crossing.held - crossing.along, -reach, reach);
    const Vec3 pull = (crossing.held - crossing.along) * needle_.tangent(std::min(crossing.along, needle_.length()));
    forces_.push_back(
        {skin.point_of_hole(crossing.hole), def_.stiffness * (aside(crossing, skin) + pull), def_.stiffness});
}

void Bites::cross(const Skin& skin, int hole, bool inwards, const Vec3& normal, const Vec3& direction, double force) {
    touch_.active = false;
    const double along = place_on(needle_, skin.centre(hole), needle_.length());
    if (inwards) {
        Bite bite;
        if (crossings_.empty()) ++passes_;
        bite.pass = passes_;
        const Vec3 cut = normal.cross(needle_.to_tail.cross(needle_.onwards));
        bite.angle_to_wall = angle(direction.dot(normal), direction.cross(normal).norm());
        bite.angle_to_axis = angle(cut.cross(def_.axis).norm(), cut.dot(def_.axis));
        bites_.push_back(bite);
    }
    const int number = inwards ? static_cast<int>(bites_.size()) - 1 : crossings_.back().bite;
    Bite& bite = bites_[static_cast<std::size_t>(number)];
    BiteEnd& end = inwards ? bite.entry : bite.exit;
    end = BiteEnd{hole, skin.point_of_hole(hole), skin.side_of_face(skin.face_of_hole(hole)), force,
                  std::exchange(touch_.is_through, false)};
    if (inwards && !crossings_.empty()) {
        Bite& last = of(crossings_.back());
        if (last.exit.side == Side::inner && bite.entry.side == Side::inner) last.both_walls = bite.both_walls = true;
    }
    bite.state = inwards ? BiteState::pricked : BiteState::open;
    crossings_.push_back({number, hole, along, along});
    events_.push_back({inwards ? BiteEvent::pierced : BiteEvent::through, number, force});
}

// The needle leaves a hole once its tip is a hole's radius outside of it, so that a tip that trembles at the rim counts
// once.
void Bites::leave_by_tip() {
    while (!crossings_.empty() && crossings_.back().along > needle_.length() + def_.hole) {
        const bool entry = is_entry(crossings_.size() - 1);
        Bite& bite = of(crossings_.back());
        bite.state = entry ? BiteState::empty : BiteState::pricked;
        if (entry) bite.on_needle = false;
        events_.push_back({entry ? BiteEvent::withdrawn : BiteEvent::back_in, crossings_.back().bite, 0});
        crossings_.pop_back();
        touch_.active = false;
    }
}

// As long as the tip is in its last hole, give or take a hole's radius, it touches no other skin.
bool Bites::is_at_last_hole() const {
    return !crossings_.empty() && crossings_.back().along > needle_.length() - def_.hole;
}

void Bites::leave_by_tail() {
    while (crossings_.size() >= 2 && crossings_[0].along < 0 && crossings_[1].along < 0) {
        of(crossings_[0]).on_needle = false;
        events_.push_back({BiteEvent::drawn, crossings_[0].bite, 0});
        crossings_.erase(crossings_.begin(), crossings_.begin() + 2);
    }
}

void Bites::measure(const Skin& skin) {
    constexpr int samples = 8;
    for (std::size_t i = 0; i < crossings_.size(); i += 2) {
        const Crossing& entry = crossings_[i];
        Bite& bite = of(entry);
        const bool open = i + 1 < crossings_.size();
        const double end = open ? crossings_[i + 1].along : needle_.length();
        if (std::min(entry.along, end) < 0) continue;
        double deepest = 0;
        for (int k = 0; k <= samples; ++k) {
            const Vec3 at = needle_.at(entry.along + (end - entry.along) * k / samples);
            deepest = std::max(deepest, skin.normal_of_hole(entry.hole).dot(skin.centre(entry.hole) - at));
        }
        bite.depth = open ? deepest : std::max(bite.depth, deepest);
    }
}

}  // namespace tissue
