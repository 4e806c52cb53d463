#pragma once
#include <immintrin.h>

#include "sim/geometry/lane.hpp"

namespace tissue {

using sim::geometry::Lane;

/// c - a b, rounded once: said outright, for compilers are told not to choose.
inline Lane less_product(Lane c, const Lane& a, const Lane& b) { return c.q = _mm256_fnmadd_pd(a.q, b.q, c.q), c; }

/// Four numbers to 24 bits, half as much to fetch.
struct ShortLane {
    typedef float Quad __attribute__((vector_size(16)));
    Quad q{};

    ShortLane() = default;
    explicit ShortLane(const Lane& lane) : q(_mm256_cvtpd_ps(lane.q)) {}
    operator Lane() const {
        Lane lane;
        return lane.q = _mm256_cvtps_pd(q), lane;
    }
};

/// Four vectors at once.
struct Lanes {
    Lane x, y, z;

    Lanes& operator+=(const Lanes& o) { return x += o.x, y += o.y, z += o.z, *this; }
    Lanes& operator-=(const Lanes& o) { return x -= o.x, y -= o.y, z -= o.z, *this; }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Lanes operator*(const Lane& a, const Lanes& b) { return {a * b.x, a * b.y, a * b.z}; }
};

inline Lane dot(const Lanes& a, const Lanes& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Lanes cross(const Lanes& a, const Lanes& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

}  // namespace tissue
