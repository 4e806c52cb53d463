#pragma once
#include <bit>
#include <cstdint>
#include <ranges>
#include <type_traits>

#include "sim/geometry/arc.hpp"
#include "sim/geometry/shapes.hpp"

namespace sim::geometry {

/// FNV-1a over numbers, 64 bits at a time: the same numbers in the same order give the same value on every machine. A
/// class is hashed by a function `void add_to(Hash&, const Class&)` beside it.
class Hash {
  public:
    /// Goes on from `start`: FNV's own, or the value of what was hashed before.
    explicit Hash(std::uint64_t start = 0xcbf29ce484222325u) : value_(start) {}

    std::uint64_t value() const { return value_; }  ///< Of all that was added so far.

    /// Adds numbers, vectors, matrices, optionals, ranges (their length first, so that nothing moves unseen from one to
    /// the next) and what has an add_to().
    template <class... Values>
    void add(const Values&... values) {
        (..., add_one(values));
    }

  private:
    void add_word(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3u; }

    template <class Value>
    void add_one(const Value& value) {
        if constexpr (std::is_same_v<Value, std::uint64_t>) {
            add_word(value);
        } else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
            add_word(std::bit_cast<std::uint64_t>(static_cast<double>(value)));
        } else if constexpr (std::is_base_of_v<Eigen::DenseBase<Value>, Value>) {
            for (Eigen::Index i = 0; i < value.size(); ++i) add_one(value.data()[i]);
        } else if constexpr (std::ranges::sized_range<Value>) {
            add_word(std::ranges::size(value));
            for (const auto& one : value) add_one(one);
        } else if constexpr (requires { value.has_value(); }) {
            add_one(value.has_value());
            if (value) add_one(*value);
        } else {
            add_to(*this, value);
        }
    }

    std::uint64_t value_;
};

/// Adds its corners.
inline void add_to(Hash& hash, const Triangle& triangle) {
    hash.add(triangle.a, triangle.b, triangle.c);
}
/// Adds its ends and its radius.
inline void add_to(Hash& hash, const Capsule& capsule) {
    hash.add(capsule.a, capsule.b, capsule.radius);
}
/// Adds its corners.
inline void add_to(Hash& hash, const Box& box) {
    hash.add(box.low, box.high);
}
/// Adds its place, its frame and its sizes.
inline void add_to(Hash& hash, const Arc& arc) {
    hash.add(arc.centre, arc.to_tail, arc.onwards, arc.radius, arc.angle, arc.wire);
}

}  // namespace sim::geometry
