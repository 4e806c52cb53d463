#pragma once
#include <optional>
#include <string>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/result.hpp"

namespace scenarios::drill {

/// A figure that is shown, and judged where a drill has a band for it.
struct Reading {
    std::string name, title, unit;
    double value;
    int digits;  ///< After the point.
    double at_s;
    std::string too_much, too_little;  ///< One sentence each for the resident.
};

/// Passed where there is no band. A value outside is shown with as many digits as tell.
ScoreItem judged(const Reading& reading, const std::optional<Band>& band);

/// 0.25 -> "0.3" by one digit.
std::string fixed(double value, int digits);

/// "3 to 8", "at most 120", "2".
std::string in_words(const Band& band);

}  // namespace scenarios::drill
