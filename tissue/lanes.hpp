#pragma once
#include <immintrin.h>

#include "sim/geometry/lane.hpp"

namespace tissue {

using sim::geometry::Lane;
using sim::geometry::Lanes;

/// c - a b, rounded once. It is written as an instruction because compilers are told not to contract.
inline Lane less_product(Lane c, const Lane& a, const Lane& b) {
    return c.q = _mm256_fnmadd_pd(a.q, b.q, c.q), c;
}

/// Four numbers from here on that are kept to 24 bits: half as much memory to fetch.
inline Lane from_short(const float* first) {
    Lane lane;
    return lane.q = _mm256_cvtps_pd(_mm_loadu_ps(first)), lane;
}
/// Keeps four numbers to 24 bits, from here on.
inline void to_short(const Lane& lane, float* first) {
    _mm_storeu_ps(first, _mm256_cvtpd_ps(lane.q));
}

/// Four cross products.
inline Lanes cross(const Lanes& a, const Lanes& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace tissue
