#include "tests/bench/suites/plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/bench/lab/words.hpp"

namespace bench::suites {

using namespace lab;

namespace {

// Pixels: the room around a chart's plot for figures and titles, and the plot, twice as large where it is the only one.
constexpr double left_room = 85, bottom_room = 50, room_between = 15;
struct Plot {
    double width, height, top;  // names of series go above the top
};
constexpr const char* colours[] = {"#1b6ca8", "#c2571a", "#3a7d44", "#7a4fa3", "#a3293d", "#5b5b5b"};

std::string px(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string text(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& more = "") {
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" + words +
           "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2) {
    return "<line x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) + "\" y2=\"" + px(y2) +
           "\" stroke=\"#999\"/>\n";
}

struct Axis {
    double low, high;
    double share(double value) const { return (value - low) / (high - low); }
};

// A distance of figures along an axis that reads well: 1, 2 or 5 times a power of ten, about four of them.
double nice_step(const Axis& axis) {
    const double rough = (axis.high - axis.low) / 4, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= rough) return digit * power;
    return 10 * power;
}

Axis axis_of(const std::vector<double>& values) {
    if (values.empty()) return {0, 1};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    Axis axis{*least, *most};
    if (axis.high == axis.low) axis = {axis.low - 0.5, axis.high + 0.5};
    const double step = nice_step(axis);
    return {step * std::floor(axis.low / step), step * std::ceil(axis.high / step)};
}

Axis decades_of(const std::vector<double>& logarithms) {
    const Axis axis = axis_of(logarithms);
    return {std::floor(axis.low), std::ceil(axis.high)};
}

// Draws one chart with its plot's upper left corner at (x0, plot.top).
class Drawing {
  public:
    Drawing(const Chart& chart, double x0, const Plot& plot) : chart_(chart), x0_(x0), plot_(plot) {
        std::vector<double> xs, ys;
        for (const Series& series : chart.series)
            for (const Point& p : series.points)
                if (is_drawn(p)) xs.push_back(std::log10(p.x)), ys.push_back(along_y(p.y));
        x_axis_ = decades_of(xs);
        y_axis_ = chart.log_y ? decades_of(ys) : axis_of(ys);
    }

    std::string drawn() {
        out_ += "<rect x=\"" + px(x0_) + "\" y=\"" + px(plot_.top) + "\" width=\"" + px(plot_.width) + "\" height=\"" +
                px(plot_.height) + "\" fill=\"none\" stroke=\"#333\"/>\n";
        draw_axes();
        for (std::size_t i = 0; i < chart_.series.size(); ++i) draw(chart_.series[i], i);
        return out_;
    }

  private:
    double x(double value) const { return x0_ + plot_.width * x_axis_.share(std::log10(value)); }
    double y(double value) const { return plot_.top + plot_.height * (1 - y_axis_.share(along_y(value))); }
    double along_y(double value) const { return chart_.log_y ? std::log10(value) : value; }
    bool is_drawn(const Point& p) const { return p.x > 0 && std::isfinite(p.x) && std::isfinite(along_y(p.y)); }

    void draw_axes() {
        const double under = plot_.top + plot_.height;
        for (double decade = x_axis_.low; decade <= x_axis_.high; ++decade) {
            const double at = x(std::pow(10, decade));
            out_ += line(at, under, at, under + 5) + text(at, under + 18, "middle", figure(std::pow(10, decade)));
        }
        const double step = chart_.log_y ? 1 : nice_step(y_axis_);
        for (double at = y_axis_.low; at < y_axis_.high + 0.5 * step; at += step) {
            const double value = chart_.log_y ? std::pow(10, at) : at;
            out_ += line(x0_ - 5, y(value), x0_, y(value)) + text(x0_ - 8, y(value) + 4, "end", figure(value));
        }
        out_ += text(x0_ + plot_.width / 2, under + 38, "middle", chart_.x_title);
        const std::string centre = px(x0_ - 62) + " " + px(plot_.top + plot_.height / 2);
        out_ += text(x0_ - 62, plot_.top + plot_.height / 2, "middle", chart_.y_title,
                     " transform=\"rotate(-90 " + centre + ")\"");
    }

    void draw(const Series& series, std::size_t number) {
        const std::string colour = colours[number % std::size(colours)];
        std::string path;
        for (const Point& p : series.points) {
            if (!is_drawn(p)) continue;
            path += px(x(p.x)) + "," + px(y(p.y)) + " ";
            out_ += "<circle cx=\"" + px(x(p.x)) + "\" cy=\"" + px(y(p.y)) + "\" r=\"3\" fill=\"" + colour + "\"/>\n";
            // Above, below, higher above: where points of several series meet their words do not.
            constexpr double beside[] = {-6, 14, -16, 24, -26, 34};
            out_ += text(x(p.x), y(p.y) + beside[number % std::size(beside)], "middle", p.label,
                         " font-size=\"9\" fill=\"" + colour + "\"");
        }
        out_ += "<polyline points=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\"" +
                (series.dashed ? " stroke-dasharray=\"5 3\"" : "") + "/>\n";
        const double row = plot_.top + 5 - 13 * static_cast<double>(chart_.series.size() - number);
        out_ += text(x0_ + plot_.width, row, "end", series.name, " fill=\"" + colour + "\"");
    }

    const Chart& chart_;
    double x0_;
    Plot plot_;
    Axis x_axis_, y_axis_;
    std::string out_;
};

}  // namespace

double value_in(const Suite& suite, const std::string& id) {
    const auto row = std::find_if(suite.rows.begin(), suite.rows.end(), [&](const Row& of) { return of.id == id; });
    return row == suite.rows.end() ? NAN : row->value;
}

std::string svg(const std::vector<Chart>& charts) {
    std::size_t names = 0;
    for (const Chart& chart : charts) names = std::max(names, chart.series.size());
    const double large = charts.size() == 1 ? 2 : 1;
    const Plot plot{260 * large, 220 * large, 7 + 13 * static_cast<double>(names)};
    const double pitch = left_room + plot.width + room_between;
    const std::string size = "width=\"" + px(pitch * static_cast<double>(charts.size()) + room_between) +
                             "\" height=\"" + px(plot.top + plot.height + bottom_room) + "\"";
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size +
                      " font-family=\"sans-serif\" font-size=\"12\" fill=\"#333\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    for (std::size_t i = 0; i < charts.size(); ++i)
        out += Drawing(charts[i], left_room + pitch * static_cast<double>(i), plot).drawn();
    return out + "</svg>\n";
}

}  // namespace bench::suites
