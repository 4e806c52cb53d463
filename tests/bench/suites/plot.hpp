#pragma once
#include <string>
#include <vector>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// A point and the words beside it.
struct Point {
    double x, y;
    std::string label;
};

struct Series {
    std::string name;
    std::vector<Point> points;
    bool dashed = false;
};

/// Axis titles carry the units. x is logarithmic and above 0, and so is y if it says so.
struct Chart {
    std::string x_title, y_title;
    std::vector<Series> series;
    bool log_y = false;
};

/// What the row of this id says, in its unit; not a number where there is none. As many comparisons as rows.
double value_in(const lab::Suite& suite, const std::string& id);

/// The charts side by side, as a picture that needs nothing else. What is no number is left out.
std::string svg(const std::vector<Chart>& charts);

}  // namespace bench::suites
