#pragma once
#include <array>

namespace tissue {

/// The energy along a line, less what it is at the start: coefficients of the first to the sixth power of the way gone.
/// [J]
using Descent = std::array<double, 6>;

/// How far to go to where it stops falling for the first time that bisection finds; 0 where it does not fall, at
/// most 4.
double lowest(const Descent& energy);

}  // namespace tissue
