#pragma once
#include <string>

namespace bench::lab {

/// Numbers as ids and words of rows have them.
std::string whole(double value);   ///< To the nearest one: "12".
std::string tenths(double value);  ///< Of it as many: "12" for 1.2, where no id may have a point.
std::string digits(double value);  ///< Six at most: "0.25".
std::string figure(double value);  ///< Four at most, as tables and plots show it.

}  // namespace bench::lab
