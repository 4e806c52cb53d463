#pragma once
#include "sim/geometry/vec.hpp"

// Functions the simulation may use instead of libm's: they need only + - * / and sqrt, which IEEE 754 rounds the same
// way on every x86-64 processor, while libm picks a variant by CPU.
namespace sim::geometry {

/// Sine and cosine of one angle.
struct SinCos {
    double sin, cos;  ///< Each -1..1.
};

/// Sine and cosine of `angle` [rad], any finite angle of moderate size; error below 1e-15 within +-pi.
SinCos portable_sin_cos(double angle);

/// Angle from the x axis to (x, y), in [-pi, pi]; error below 2e-15, a few units in the last place. Not both zero.
double portable_atan2(double y, double x);

/// e to the power of x; a relative error below 2e-15 (1 + |x|): the series is off by a rounding or two, and each
/// doubling back doubles that.
double portable_exp(double x);

/// Rotation from `from` (t = 0) to `to` (t = 1) along the shorter arc at constant rate.
/// Unit quaternions in, unit quaternion out; opposite signs of the same rotation give the same answer.
Quat portable_slerp(const Quat& from, const Quat& to, double t);

/// The shortest rotation that turns the direction of `from` into that of `to`; half a turn about any axis across when
/// they are opposite. Neither may be zero. Eigen's own drags a singular value decomposition into every file that calls
/// it.
Quat rotation_between(const Vec3& from, const Vec3& to);

}  // namespace sim::geometry
