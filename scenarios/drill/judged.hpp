#pragma once
#include <optional>
#include <string>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/result.hpp"

namespace scenarios::drill {

/// A figure that is shown, and judged where a drill has a band for it.
struct Reading {
    std::string name, title, unit;     ///< As in ScoreItem.
    double value;                      ///< In `unit`.
    int digits;                        ///< Digits after the point that the value is shown with.
    double at_s;                       ///< When it was reached [s].
    std::string too_much, too_little;  ///< One sentence each for the resident.
};

/// The item of a reading, passed where there is no band. A value outside its band is shown with as many digits as it
/// takes to tell the two apart.
ScoreItem judged(const Reading& reading, const std::optional<Band>& band);

/// A number, or none where it is not one.
std::optional<double> number_or_none(double value);

/// A number with so many digits after the point: 0.25 is "0.3" with one.
std::string fixed(double value, int digits);

/// A band as people read it: "3 to 8", "at most 120", "2".
std::string in_words(const Band& band);

}  // namespace scenarios::drill
