#pragma once
#include <array>

namespace tissue {

/// The energy along a line less that at its start, as a polynomial: coefficients of the first to the sixth power of how
/// far one has gone [J].
using Descent = std::array<double, 6>;

/// How far to go to where the energy stops falling, as bisection finds it first: 0 where it does not fall, at most 4.
double lowest(const Descent& energy);

}  // namespace tissue
