// What of a needle is in no wall: it pushes, and never passes.
#include <algorithm>

#include "tissue/bite.hpp"

namespace tissue {

namespace {

constexpr int pieces = 12;      // straight ones: a 3/8 circle of 9 mm is off by a fifth of its wire's radius
constexpr double clear = 5;     // wire radii along the wire from a hole: where it goes in aslant its side is that near the skin

Capsule piece(const Arc& arc, int k) {
    return {arc.at(arc.length() * k / pieces), arc.at(arc.length() * (k + 1) / pieces), arc.wire};
}

}  // namespace

bool Bites::is_outside(int k) const {
    const double length = needle_.length(), low = length * k / pieces, high = length * (k + 1) / pieces, margin = clear * needle_.wire;
    if (high > length - margin) return false;  // the tip is touched as a tip
    for (std::size_t i = 0; i < crossings_.size(); i += 2) {
        const double tail = crossings_[i].along - margin, tip = i + 1 < crossings_.size() ? crossings_[i + 1].along + margin : length;
        if (low < tip && high > tail) return false;
    }
    return true;
}

void Bites::press_shaft(const Arc& before, const Skin& skin) {
    for (int k = 0; k < pieces; ++k)
        if (is_outside(k)) shaft_.press(skin, piece(needle_, k), piece(before, k), forces_);
}

void Bites::settle_shaft(const Skin& skin) {
    for (int k = 0; k < pieces; ++k)
        if (is_outside(k)) force_ += shaft_.force(skin, piece(needle_, k));
}

}  // namespace tissue
