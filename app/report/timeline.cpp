#include "app/report/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "app/report/text.hpp"

namespace app::report {

using scenarios::drill::Result;
using scenarios::drill::Sample;

namespace {

// Pixels of the drawing's own coordinates: labels, then the plot, then room for the last tick's figure.
constexpr double width = 960, left = 150, right = 940, row = 22, chart = 64, gap = 10;

using Reading = std::function<double(const Sample&)>;
using Label = std::function<std::string(const Sample&)>;

std::string px(double value) {
    return number(value, 1);
}

std::string text(double x, double y, const std::string& kind, const std::string& words) {
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" class=\"" + kind + "\">" + escaped(words) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& kind) {
    return "<line x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) + "\" y2=\"" + px(y2) + "\" class=\"" +
           kind + "\"/>\n";
}

double entry(const std::vector<double>& list, std::size_t i) {
    return i < list.size() ? list[i] : NAN;
}

// Draws downwards, row after row; `y_` is where the next row begins.
class Sheet {
  public:
    explicit Sheet(const Result& result) : result_(result) {
        if (std::isfinite(result.duration_s)) end_s_ = std::max(end_s_, result.duration_s);
        for (const Sample& sample : result.samples)
            if (std::isfinite(sample.t_s)) end_s_ = std::max(end_s_, sample.t_s);
        if (end_s_ <= 0) end_s_ = 1;
    }

    void add_events();
    void add_strip(const std::string& title, const Label& label, const std::string& kind);
    void add_chart(const std::string& title, const Reading& reading, double top, int decimals);
    std::string finish(const std::vector<double>& moments) const;

  private:
    double x(double t_s) const { return left + (right - left) * std::clamp(t_s / end_s_, 0.0, 1.0); }
    std::string moment_numbers(const std::vector<double>& moments) const;
    void add_bar(double from_s, double to_s, const std::string& words, const std::string& kind);

    const Result& result_;
    double end_s_ = 0;
    double y_ = 26;  // below the numbers of the moments
    std::string body_;
};

// A row a kind, in the order in which the kinds first appeared.
void Sheet::add_events() {
    std::vector<scenarios::world::EventKind> kinds;
    for (const auto& event : result_.events)
        if (std::find(kinds.begin(), kinds.end(), event.kind) == kinds.end()) kinds.push_back(event.kind);
    for (const auto kind : kinds) {
        std::string words = scenarios::world::words_of(kind).name;
        std::replace(words.begin(), words.end(), '_', ' ');
        body_ += text(left - 10, y_ + 15, "label", words) + line(left, y_ + row / 2, right, y_ + row / 2, "rule");
        for (const auto& event : result_.events) {
            if (event.kind != kind || !std::isfinite(event.t_s)) continue;
            const double at = x(event.t_s), middle = y_ + row / 2;
            body_ += "<path class=\"event\" d=\"M" + px(at) + " " + px(middle - 7) + "l5 7l-5 7l-5 -7z\"><title>" +
                     escaped(number(event.t_s, 2) + " s: " + words + ", " + event.what) + "</title></path>\n";
        }
        y_ += row;
    }
    if (!kinds.empty()) y_ += gap;
}

void Sheet::add_bar(double from_s, double to_s, const std::string& words, const std::string& kind) {
    const double begin = x(from_s), wide = std::max(x(to_s) - begin, 1.0);
    body_ += "<rect x=\"" + px(begin) + "\" y=\"" + px(y_ + 3) + "\" width=\"" + px(wide) + "\" height=\"" +
             px(row - 6) + "\" class=\"" + kind + "\"><title>" +
             escaped(number(from_s, 2) + " to " + number(to_s, 2) + " s: " + words) + "</title></rect>\n";
    const double letter = 7;  // of the 12 px face, generously
    if (kind == "named" && wide > letter * static_cast<double>(words.size()) + 6)
        body_ += text(begin + 4, y_ + 15, "inside", words);
}

// Bars where the label stays the same; none where it is empty.
void Sheet::add_strip(const std::string& title, const Label& label, const std::string& kind) {
    body_ += text(left - 10, y_ + 15, "label", title) + line(left, y_ + row / 2, right, y_ + row / 2, "rule");
    std::string open;
    double since = 0;
    const auto turn = [&](double t_s, const std::string& next) {
        if (next == open) return;
        if (!open.empty()) add_bar(since, t_s, open, kind);
        open = next;
        since = t_s;
    };
    for (const Sample& sample : result_.samples)
        if (std::isfinite(sample.t_s)) turn(sample.t_s, label(sample));
    turn(end_s_, "");
    y_ += row;
}

// `top` is the value at the upper edge: charts of one quantity share it, so that tools can be compared.
void Sheet::add_chart(const std::string& title, const Reading& reading, double top, int decimals) {
    struct Column {
        double low_s, low, high_s, high;
    };
    std::vector<std::optional<Column>> columns(static_cast<std::size_t>(right - left) + 1);
    double peak = -INFINITY, peak_s = 0;
    for (const Sample& sample : result_.samples) {
        const double value = reading(sample);
        if (!std::isfinite(value) || !std::isfinite(sample.t_s)) continue;
        auto& column = columns[static_cast<std::size_t>(x(sample.t_s) - left)];
        if (!column) column = {sample.t_s, value, sample.t_s, value};
        if (value < column->low) column->low = value, column->low_s = sample.t_s;
        if (value > column->high) column->high = value, column->high_s = sample.t_s;
        if (value > peak) peak = value, peak_s = sample.t_s;
    }
    const double base = y_ + chart - 8, tall = chart - 22, scale = top > 0 ? tall / top : 0;
    const auto point = [&](double t_s, double value) {
        return px(x(t_s)) + " " + px(base - scale * std::max(value, 0.0));
    };
    std::string path;
    for (const auto& column : columns) {
        if (!column) continue;
        const bool low_first = column->low_s <= column->high_s;
        const std::string low = point(column->low_s, column->low), high = point(column->high_s, column->high);
        path += (path.empty() ? "M" : "L") + (low_first ? low : high);
        if (low != high) path += "L" + (low_first ? high : low);
    }
    body_ += text(left - 10, base - tall / 2 + 4, "label", title) + line(left, base, right, base, "rule");
    if (!path.empty()) {
        const bool late = x(peak_s) > right - 60;
        body_ += "<path class=\"curve\" d=\"" + path + "\"/>\n" +
                 text(x(peak_s) + (late ? -4 : 4), base - scale * std::max(peak, 0.0) - 3, late ? "peak late" : "peak",
                      number(peak, decimals));
    }
    y_ += chart;
}

// The step of 1, 2 or 5 times a power of ten that gives at most eight parts.
double nice_step(double span) {
    double step = 0.001;
    for (int i = 0; span / step > 8; ++i) step *= i % 3 == 1 ? 2.5 : 2;
    return step;
}

// Moments too near to each other for a number each share one: "3–4".
std::string Sheet::moment_numbers(const std::vector<double>& moments) const {
    constexpr double apart = 28;  // pixels: half of "10–12" and half of its like
    std::string out;
    for (std::size_t first = 0, next = 0; first < moments.size(); first = next) {
        for (next = first + 1; next < moments.size() && x(moments[next]) - x(moments[next - 1]) < apart;) ++next;
        if (!std::isfinite(moments[first])) continue;
        const std::string last = next - first > 1 ? "–" + std::to_string(next) : "";
        out +=
            text((x(moments[first]) + x(moments[next - 1])) / 2, 16, "moment-number", std::to_string(first + 1) + last);
    }
    return out;
}

std::string Sheet::finish(const std::vector<double>& moments) const {
    const double step = nice_step(end_s_), foot = y_ + 6;
    std::string back, front;
    for (int i = 0; i * step <= end_s_; ++i) {
        back += line(x(i * step), 22, x(i * step), foot, "grid");
        front += text(x(i * step), foot + 16, "tick",
                      number(i * step, step < 0.01  ? 3
                                       : step < 0.1 ? 2
                                       : step < 1   ? 1
                                                    : 0));
    }
    front += text(left - 10, foot + 16, "label", "time [s]");
    for (const double moment : moments)
        if (std::isfinite(moment)) back += line(x(moment), 22, x(moment), foot, "moment");
    front += moment_numbers(moments);
    return "<svg viewBox=\"0 0 " + px(width) + " " + px(foot + 26) +
           "\" role=\"img\" aria-label=\"Events, knot, grasps, tension, speed and how far tools are behind their hands "
           "over time\">\n" +
           back + body_ + front + "</svg>\n";
}

double largest(const Result& result, const Reading& reading) {
    double top = 0;
    for (const Sample& sample : result.samples)
        if (const double value = reading(sample); std::isfinite(value)) top = std::max(top, value);
    return top;
}

}  // namespace

std::string timeline_svg(const Result& result, const std::vector<double>& moments) {
    if (result.samples.empty()) return "";
    const auto speed = [](std::size_t i) { return [i](const Sample& s) { return entry(s.tool_speed_mm_s, i); }; };
    const auto lag = [](std::size_t i) { return [i](const Sample& s) { return entry(s.tool_lag_mm, i); }; };
    const auto tension = [](const Sample& s) { return s.tension_N; };
    const auto& tools = result.instruments;
    double fastest = 0, farthest = 0;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        fastest = std::max(fastest, largest(result, speed(i)));
        farthest = std::max(farthest, largest(result, lag(i)));
    }
    Sheet sheet(result);
    sheet.add_events();
    sheet.add_strip(
        "knot is", [](const Sample& s) { return s.knot; }, "named");
    for (std::size_t i = 0; i < tools.size(); ++i)
        sheet.add_strip(
            tools[i] + " holds", [i](const Sample& s) { return i < s.held.size() ? s.held[i] : ""; }, "held");
    sheet.add_chart("tension [N]", tension, largest(result, tension), 2);
    for (std::size_t i = 0; i < tools.size(); ++i) sheet.add_chart(tools[i] + " speed [mm/s]", speed(i), fastest, 0);
    for (std::size_t i = 0; i < tools.size(); ++i)
        sheet.add_chart(tools[i] + " behind its hand [mm]", lag(i), farthest, 2);
    return sheet.finish(moments);
}

}  // namespace app::report
