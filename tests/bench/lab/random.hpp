#pragma once
#include <cstdint>

namespace bench::lab {

/// Splitmix64: the same numbers from a seed with every compiler and library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(0x9e3779b97f4a7c15u * (seed + 1)) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
    double between(double low, double high) { return low + (high - low) * 0x1p-53 * static_cast<double>(next() >> 11); }

  private:
    std::uint64_t state_;
};

}  // namespace bench::lab
