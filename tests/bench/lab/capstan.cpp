#include "tests/bench/lab/capstan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/thread/thread.hpp"
#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/gauge.hpp"

namespace bench::lab {

namespace {

using sim::thread::Hold;
using sim::thread::Thread;
using sim::thread::ThreadDef;
using sim::thread::Vec3;

constexpr double to_axis = 5 * default_diameter;     // from the cylinder's axis to the thread's centre line [m]
constexpr double turn_pitch = 3 * default_diameter;  // of a turn: turns beside each other never touch [m]
constexpr double tip_speed = 0.01;                   // [m/s]: median to fast tool tips
constexpr double pulled_way = 8 * default_diameter;  // pulled at least; the tension is read over the second half [m]
constexpr int least_ticks =
    128;  // 64 readings: they jump while a link is drawn on, and the median of eight is off by 0.05

// On the cylinder from -wrap/2 to wrap/2 about y, straight on either side of it. Nodes lie just so far out that the
// middle of each link touches.
struct Laid {
    std::vector<Vec3> nodes;
    Vec3 away;  ///< Where the last node is pulled to.
};

Laid lay(const CapstanCase& c) {
    const double link = c.link * default_diameter,
                 per_angle = std::sqrt(to_axis * to_axis + std::pow(turn_pitch / (2 * std::numbers::pi), 2));
    const double step = link / per_angle, out = to_axis / std::cos(step / 2);
    const auto on = [&](double a) {
        return Vec3(out * std::sin(a), turn_pitch * a / (2 * std::numbers::pi), out * std::cos(a));
    };
    const int arc = static_cast<int>(std::lround(c.wrap / step)), tail = 3 * arc + static_cast<int>(120 / c.link),
              lead = static_cast<int>(20 / c.link);
    std::vector<Vec3> nodes;
    for (int i = 0; i <= arc; ++i) nodes.push_back(on((i - 0.5 * arc) * step));
    // Straight on as the first and last link go, turned by half a link's angle: the last touch is in the middle of a
    // link.
    const Vec3 from = on((-0.5 * arc - 1) * step) - nodes.front(), to = on((0.5 * arc + 1) * step) - nodes.back();
    Laid laid{{}, to.normalized()};
    for (int i = tail; i >= 1; --i) laid.nodes.push_back(nodes.front() + i * from);
    laid.nodes.insert(laid.nodes.end(), nodes.begin(), nodes.end());
    for (int i = 1; i <= lead; ++i) laid.nodes.push_back(nodes.back() + i * to);
    return laid;
}

double turn_at(std::span<const Vec3> p, std::size_t i) {
    const Vec3 a = p[i] - p[i - 1], b = p[i + 1] - p[i];
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// What the pulling side would carry for this friction, from the tension `t` before the nodes [first, last] and the drag
// of every link.
double pulled_with(double friction, std::span<const double> turns, double t, double drag) {
    for (const double turn : turns) t = t * ratio_over_node(friction, turn) + drag;
    return t;
}

// The nodes on the cylinder are those that turn by a tenth of a link's angle or more.
struct Wrap {
    std::size_t first = 0, last = 0;
    std::vector<double> turns;
};

Wrap wrap_of(std::span<const Vec3> nodes, double angle_of_link) {
    Wrap wrap;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        if (turn_at(nodes, i) > 0.1 * angle_of_link) {
            if (wrap.first == 0) wrap.first = i;
            wrap.last = i;
        }
    for (std::size_t i = wrap.first; i > 0 && i <= wrap.last; ++i) wrap.turns.push_back(turn_at(nodes, i));
    return wrap;
}

double exponent(double friction, std::span<const double> turns) {
    double sum = 0;
    for (const double turn : turns) sum += std::log(ratio_over_node(friction, turn));
    return sum;
}

// The friction with which the law gives the tensions read on either side, by bisection; the drag of a link is the slope
// of the tail's tension.
std::optional<double> ratio_read(const Thread& thread, const CapstanCase& c) {
    const Wrap wrap = wrap_of(thread.nodes(), c.link * default_diameter / to_axis);
    if (wrap.first < 2) return {};
    const double before = thread.tension()[wrap.first - 1], after = thread.tension()[wrap.last];
    const double drag = before / static_cast<double>(wrap.first);
    if (before <= 0 || after <= 0) return {};
    double low = 0, high = 2;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (pulled_with(middle, wrap.turns, before, drag) < after ? low : high) = middle;
    }
    return exponent(low, wrap.turns) / exponent(c.friction, wrap.turns);
}

}  // namespace

double ratio_over_node(double friction, double turn) {
    const double t = friction * std::tan(turn / 2);
    return (1 + t) / (1 - t);
}

double Capstan::deviation() const {
    constexpr double enough = 0.5;  // of all ticks
    return followed < enough ? 1 : std::abs(ratio - 1);
}

Capstan capstan(const CapstanCase& c) {
    Laid laid = lay(c);
    Thread thread({.friction = c.friction, .friction_tool = c.friction}, std::move(laid.nodes));
    const int last = static_cast<int>(thread.nodes().size()) - 1;
    // The cylinder is a tool part that stands still: an exact cylinder, where a surface would be a prism with edges.
    const Vec3 half(0, 100 * default_diameter, 0);
    const sim::geometry::Capsule cylinder{-half, half, to_axis - 0.5 * default_diameter};
    const sim::thread::MovingCapsule capsules[] = {{cylinder, cylinder, 0}};
    const int owners[] = {-1},
              ticks = std::max(least_ticks, static_cast<int>(std::lround(pulled_way / (tip_speed * c.tick))));
    std::vector<double> ratios;
    Capstan result;
    result.cost.links = last;
    for (int i = 0; i < ticks; ++i) {
        const Vec3 at = thread.nodes().back();
        const Hold holds[] = {{last, at + tip_speed * c.tick * laid.away, at + 10 * default_diameter * laid.away}};
        const auto report = result.cost.of([&] { return thread.tick({holds, owners, capsules, nullptr}); });
        if (2 * i < ticks || report.fraction < 1) continue;
        if (const auto ratio = ratio_read(thread, c)) ratios.push_back(*ratio);
    }
    if (ratios.empty()) return result;
    result.ratio = percentile(ratios, 0.5);
    result.followed = 2.0 * static_cast<double>(ratios.size()) / ticks;
    return result;
}

}  // namespace bench::lab
