// The parts of a needle that are in no wall, or should be and are not: they push the wall aside, and never pass.
#include <algorithm>

#include "tissue/bite.hpp"

namespace tissue {

namespace {

constexpr int pieces = 12;  // of a 3/8 circle of 9 mm: straight, they are off by a fifth of its wire's radius
constexpr double clear =
    5;  // wire radii along the wire from a hole: where it goes in aslant its side is that near the skin

Capsule piece(const Arc& arc, int k) {
    return {arc.at(arc.length() * k / pieces), arc.at(arc.length() * (k + 1) / pieces), arc.wire};
}

}  // namespace

bool Bites::is_outside(int k) const {
    const double length = needle_.length(), low = length * k / pieces, high = length * (k + 1) / pieces,
                 margin = clear * needle_.wire;
    if (high > length - margin) return false;  // the tip is touched as a tip
    for (std::size_t i = 0; i < crossings_.size(); i += 2) {
        const double tail = crossings_[i].along - margin,
                     tip = i + 1 < crossings_.size() ? crossings_[i + 1].along + margin : length;
        if (low < tip && high > tail) return false;
    }
    return true;
}

// A bite whose needle came out where it went in bulges the skin across the wall where the wire is that deep. The wire
// made no hole there, and thread that came after it would be on the wrong side of that skin once the wall closes.
template <class Push>
void Bites::bulge(const Skin& skin, const Push& push) const {
    constexpr int samples = 8;
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
        const Bite& bite = bites_[static_cast<std::size_t>(crossings_[i].bite)];
        if (bite.entry.side != bite.exit.side) continue;
        const Vec3 across = -skin.normal_of_hole(crossings_[i].hole);
        const double tail = std::max(0.0, crossings_[i].along),
                     tip = std::min(needle_.length(), crossings_[i + 1].along);
        for (int k = 1; k < samples && tail < tip; ++k) {
            const Vec3 at = needle_.at(tail + (tip - tail) * k / samples);
            const Skin::Spot spot = skin.closest(at, at, def_.wall, across);
            if (spot.triangle < 0 || skin.side_of_face(skin.face(spot.triangle)) == bite.entry.side) continue;
            const int face = skin.face(spot.triangle);
            const Vec3 out = skin.normal_of_face(face);
            const double deep = (at - spot.at).dot(out) + needle_.wire;
            if (deep > 0)
                push(skin.point_of_face(face, skin.weights_in_face(face, spot.at)), def_.stiffness * deep, out);
        }
    }
}

void Bites::press_shaft(const Arc& before, const Skin& skin) {
    for (int k = 0; k < pieces; ++k)
        if (is_outside(k)) shaft_.press(skin, piece(needle_, k), piece(before, k), forces_);
    bulge(skin, [&](const MaterialPoint& at, double size, const Vec3& out) {
        forces_.push_back({at, size * out, def_.stiffness, out});
    });
}

void Bites::settle_shaft(const Skin& skin) {
    for (int k = 0; k < pieces; ++k)
        if (is_outside(k)) force_ += shaft_.force(skin, piece(needle_, k));
    bulge(skin, [&](const MaterialPoint&, double size, const Vec3& out) { force_ -= size * out; });
}

}  // namespace tissue
