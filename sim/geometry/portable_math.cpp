#include "sim/geometry/portable_math.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace sim::geometry {

SinCos portable_sin_cos(double angle) {
    assert(std::isfinite(angle));
    // Halve until the Taylor series is short, then double back: sin 2x = 2 sin x cos x, cos 2x - 1 = -2 sin^2 x.
    int halvings = 0;
    while (angle > 0.25 || angle < -0.25) angle *= 0.5, ++halvings;
    const double q = angle * angle;
    double sin = angle * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110 * (1 - q / 156))))));
    double versine = q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56 * (1 - q / 90 * (1 - q / 132)))));  // 1 - cos
    for (; halvings > 0; --halvings) {
        const double doubled = 2 * sin * sin;
        sin = 2 * sin * (1 - versine);
        versine = doubled;
    }
    return {sin, 1 - versine};
}

double portable_atan2(double y, double x) {
    assert((x != 0 || y != 0) && "the origin is in no direction");
    // Halve until the series is short.
    constexpr int halvings = 4;
    const double size = std::max(std::abs(x), std::abs(y));
    double cos = x / size, sin = y / size;
    const double length = std::sqrt(cos * cos + sin * sin);
    cos /= length, sin /= length;
    for (int i = 0; i < halvings; ++i) {
        const double larger = std::sqrt(0.5 * (1 + std::abs(cos))), smaller = 0.5 * std::abs(sin) / larger;
        sin = std::copysign(cos < 0 ? larger : smaller, sin);
        cos = cos < 0 ? smaller : larger;
    }
    const double t = sin / cos, q = t * t;
    double sum = 0;
    for (int k = 21; k >= 1; k -= 2) sum = 1.0 / k - q * sum;
    return (1 << halvings) * t * sum;
}

double portable_exp(double x) {
    int halvings = 0;
    for (; std::abs(x) > 0.25 && std::abs(x) < 1e4; x *= 0.5) ++halvings;  // of more the answer is 0 or infinity
    if (std::abs(x) > 0.25) return x < 0 ? 0 : std::numeric_limits<double>::infinity();
    double sum = 1;
    for (int k = 11; k >= 1; --k) sum = 1 + x / k * sum;  // what is left out is 0.25^12 / 12!, 1e-16
    for (; halvings > 0; --halvings) sum *= sum;
    return sum;
}

Quat portable_slerp(const Quat& from, const Quat& to, double t) {
    // Halving the arc needs only a sum and a normalisation, so bisect on t. After 26 halvings what is left of the arc
    // is below 1e-7 rad and linear interpolation differs from slerp by less than its cube: rounding.
    Eigen::Vector4d low = from.coeffs(), high = to.coeffs();
    if (low.dot(high) < 0) high = -high;
    double low_t = 0, high_t = 1;
    for (int i = 0; i < 26; ++i) {
        const double middle_t = 0.5 * (low_t + high_t);
        const Eigen::Vector4d middle = (low + high).normalized();
        (t < middle_t ? high : low) = middle;
        (t < middle_t ? high_t : low_t) = middle_t;
    }
    const double u = (t - low_t) / (high_t - low_t);
    return Quat(Eigen::Vector4d(((1 - u) * low + u * high).normalized()));
}

Quat rotation_between(const Vec3& from, const Vec3& to) {
    assert(!from.isZero(0) && !to.isZero(0) && "two directions");
    const Vec3 a = from.normalized(), sum = a + to.normalized();
    const Vec3 half = sum.isZero(0) ? a.unitOrthogonal() : sum.normalized();  // twice the way to it is the way to `to`
    const Vec3 axis = a.cross(half);
    return Quat(a.dot(half), axis.x(), axis.y(), axis.z());
}

}  // namespace sim::geometry
