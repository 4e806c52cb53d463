#pragma once
#include <string>
#include <vector>

namespace app::bench {

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

/// The charts side by side, as a picture that needs nothing else. What is no number is left out.
std::string svg(const std::vector<Chart>& charts);

}  // namespace app::bench
