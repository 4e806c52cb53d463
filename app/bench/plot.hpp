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
};

/// Axis titles carry the units. x is logarithmic and above 0.
struct Chart {
    std::string x_title, y_title;
    std::vector<Series> series;
};

/// The charts side by side, as a picture that needs nothing else. What is no number is left out.
std::string svg(const std::vector<Chart>& charts);

}  // namespace app::bench
