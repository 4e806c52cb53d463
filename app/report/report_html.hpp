#pragma once
#include <string>
#include <vector>

#include "scenarios/drill/result.hpp"

namespace app::report {

/// A picture of the scene worth showing beside the scores.
struct Moment {
    double t_s;
    std::string caption;
    std::vector<unsigned char> png;  ///< A whole PNG file; if empty, the caption stands alone.
};

/// report.html: one page for the resident and her teacher that needs nothing but itself: no scripts, no requests.
/// Verdict; what to work on, each item with the picture nearest to its moment; then, folded, all scores in the order of
/// drill::by_importance(), key moments, timeline, the thread's own figures. Light, dark and on paper; nothing by colour
/// alone.
/// All text that came from files is escaped.
std::string report_html(const scenarios::drill::Result& result, const std::vector<Moment>& moments);

}  // namespace app::report
