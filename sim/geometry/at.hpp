#pragma once

#include <cstddef>

// Indices of what is counted in int, as neighbours and differences are, or has three numbers each.
namespace sim {

/// The index of item i, at least 0.
constexpr std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Where the three numbers of item i begin.
constexpr std::ptrdiff_t axes(std::size_t i) {
    return static_cast<std::ptrdiff_t>(3 * i);
}

}  // namespace sim
