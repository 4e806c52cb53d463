#pragma once
#include <Eigen/Core>

namespace tissue {

/// Four numbers at once, of four cells.
using Lane = Eigen::Array4d;

/// Four vectors at once.
struct Lanes {
    Lane x = Lane::Zero(), y = Lane::Zero(), z = Lane::Zero();

    Lanes& operator+=(const Lanes& o) { return x += o.x, y += o.y, z += o.z, *this; }
    Lanes& operator-=(const Lanes& o) { return x -= o.x, y -= o.y, z -= o.z, *this; }
};

inline Lanes operator-(const Lanes& a, const Lanes& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Lane dot(const Lanes& a, const Lanes& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Lanes cross(const Lanes& a, const Lanes& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

}  // namespace tissue
