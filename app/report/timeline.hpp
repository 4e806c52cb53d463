#pragma once
#include <string>
#include <vector>

#include "scenarios/drill/result.hpp"

namespace app::report {

/// Inline SVG of the session over time, drawn with the classes of the report's style sheet: a row a kind of event, the
/// knot's name, what each tool holds, then tension, speed and lag, a chart each with its largest value at its peak.
/// `moments` [s] are numbered from 1 across all rows. Every row carries its name, so no colour has to be told apart.
/// Long sessions are thinned to two points a column, the least and the largest, so that no peak is lost.
/// Figures that are not finite leave gaps. Empty if the session has no samples.
std::string timeline_svg(const scenarios::drill::Result& result, const std::vector<double>& moments);

}  // namespace app::report
