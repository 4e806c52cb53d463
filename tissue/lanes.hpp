#pragma once
#include <immintrin.h>

#include <cstddef>

namespace tissue {

/// Four numbers that the processor treats as one: of four cells, or a vector and a zero. Eigen's arrays of four are copied in halves, which
/// makes a factorisation 2.5 times as slow (GCC 12).
struct Lane {
    typedef double Quad __attribute__((vector_size(32)));
    Quad q{};

    Lane() = default;
    explicit Lane(double all) : q{all, all, all, all} {}
    Lane(double a, double b, double c, double d) : q{a, b, c, d} {}

    double operator[](std::size_t k) const { return q[k]; }
    double sum() const { return (q[0] + q[1]) + (q[2] + q[3]); }
    void clear_from(std::size_t k) {
        for (; k < 4; ++k) q[k] = 0;
    }

    Lane& operator+=(const Lane& o) { return q += o.q, *this; }
    Lane& operator-=(const Lane& o) { return q -= o.q, *this; }
    friend Lane operator+(const Lane& a, const Lane& b) { return Lane(a) += b; }
    friend Lane operator-(const Lane& a, const Lane& b) { return Lane(a) -= b; }
    friend Lane operator*(Lane a, const Lane& b) { return a.q *= b.q, a; }
    friend Lane operator/(Lane a, const Lane& b) { return a.q /= b.q, a; }
    friend Lane operator*(double a, const Lane& b) { return Lane(a) * b; }
    friend Lane operator*(const Lane& a, double b) { return a * Lane(b); }
};

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
