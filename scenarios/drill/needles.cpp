#include "scenarios/drill/needles.hpp"

#include <algorithm>
#include <array>

namespace scenarios::drill {

using sim::geometry::Arc;
using sim::geometry::Vec3;

constexpr std::array<NeedleCode, 8> codes = {{{"BV75-3", 0.375, 3.8e-3, 0.075e-3},
                                              {"BV100-4", 0.375, 5.1e-3, 0.100e-3},
                                              {"BV130-5", 0.375, 6.5e-3, 0.130e-3},
                                              {"BV175-6", 0.375, 8.0e-3, 0.175e-3},
                                              {"BV-1", 0.375, 9.3e-3, 0.20e-3},
                                              {"C-1", 0.375, 13e-3, 0.35e-3},
                                              {"RB-1", 0.5, 17e-3, 0.43e-3},
                                              {"SH", 0.5, 26e-3, 0.60e-3}}};

std::span<const NeedleCode> needle_codes() {
    return codes;
}

const NeedleCode& needle_named(const std::string& name) {
    return *std::find_if(codes.begin(), codes.end(), [&](const NeedleCode& code) { return name == code.name; });
}

Arc needle_at(const NeedleCode& code, const Vec3& tail, const Vec3& towards, const Vec3& bulge) {
    constexpr double whole = 6.28318530717958648;
    Arc arc;
    arc.angle = whole * code.circle;
    arc.radius = code.length / arc.angle;
    arc.wire = code.wire / 2;
    const auto half = sim::geometry::portable_sin_cos(arc.angle / 2);
    const Vec3 along = towards.normalized(), up = (bulge - bulge.dot(along) * along).normalized();
    arc.to_tail = half.cos * up - half.sin * along;
    arc.onwards = half.cos * along + half.sin * up;
    arc.centre = tail - arc.radius * arc.to_tail;
    return arc;
}

}  // namespace scenarios::drill
