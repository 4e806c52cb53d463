#pragma once
#include <cstddef>
#include <cstring>

namespace sim::geometry {

/// Four numbers that the processor treats as one: of four cells or four contacts, or a vector and a zero. Eigen's
/// arrays of four are copied in halves, which makes a factorisation 2.5 times as slow (GCC 12), and it fuses products
/// with sums in some places and not in others.
struct Lane {
    typedef double Quad __attribute__((vector_size(32)));  ///< Four numbers as the compiler knows them.
    Quad q{};                                              ///< The numbers, in order.

    Lane() = default;
    /// Four times the same number.
    explicit Lane(double all) : q{all, all, all, all} {}
    /// These four numbers, in order.
    Lane(double a, double b, double c, double d) : q{a, b, c, d} {}

    /// Reads four numbers, one after the other in memory; they need no alignment.
    static Lane from(const double* first) {
        Lane lane;
        return std::memcpy(&lane.q, first, sizeof lane.q), lane;
    }
    /// Writes the four numbers, one after the other in memory.
    void to(double* first) const { std::memcpy(first, &q, sizeof q); }
    /// Writes the first three numbers, for what is stored as vectors.
    void three_to(double* first) const { std::memcpy(first, &q, 3 * sizeof(double)); }

    /// Number k, 0 to 3.
    double operator[](std::size_t k) const { return q[k]; }
    /// The sum of the four, in pairs: the order is part of the result.
    double sum() const { return (q[0] + q[1]) + (q[2] + q[3]); }
    /// Makes number k, 0 to 4, and all after it zero.
    void clear_from(std::size_t k) {
        for (; k < 4; ++k) q[k] = 0;
    }

    /// Adds number by number.
    Lane& operator+=(const Lane& o) { return q += o.q, *this; }
    /// Subtracts number by number.
    Lane& operator-=(const Lane& o) { return q -= o.q, *this; }
    friend Lane operator+(const Lane& a, const Lane& b) { return Lane(a) += b; }
    friend Lane operator-(const Lane& a, const Lane& b) { return Lane(a) -= b; }
    friend Lane operator*(Lane a, const Lane& b) { return a.q *= b.q, a; }
    friend Lane operator/(Lane a, const Lane& b) { return a.q /= b.q, a; }
    friend Lane operator*(double a, const Lane& b) { return Lane(a) * b; }
    friend Lane operator*(const Lane& a, double b) { return a * Lane(b); }
};

/// Four vectors at once.
struct Lanes {
    Lane x, y, z;  ///< Each axis of the four.

    /// Adds vector by vector.
    Lanes& operator+=(const Lanes& o) { return x += o.x, y += o.y, z += o.z, *this; }
    /// Subtracts vector by vector.
    Lanes& operator-=(const Lanes& o) { return x -= o.x, y -= o.y, z -= o.z, *this; }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Lanes operator*(const Lane& a, const Lanes& b) { return {a * b.x, a * b.y, a * b.z}; }
};

/// The four inner products, vector by vector.
inline Lane dot(const Lanes& a, const Lanes& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace sim::geometry
