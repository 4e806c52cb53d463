#include "app/bench/rod_capstan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/bench/capstan.hpp"
#include "sim/thread/rod.hpp"

namespace app::bench {

namespace {

using sim::thread::Rod;
using sim::thread::Vec3;

constexpr double pi = std::numbers::pi;
constexpr double diameter = 1e-3, cylinder = 5 * diameter, out = cylinder + 0.5 * diameter;  // [m]; `out` is where nodes lie
constexpr double load = 0.1;                                                                 // [N]
constexpr double pitch = 0.6 * out;  // of a turn: turns beside each other never meet
constexpr int tail = 30;             // links that are off the cylinder at either end

struct Wound {
    Wound(double friction, double wrap, double turn) : along{tangent(-wrap / 2), tangent(wrap / 2)} {
        const int arc = static_cast<int>(std::lround(wrap / turn));
        for (int i = -tail; i <= arc + tail; ++i) {
            const int on = std::clamp(i, 0, arc), off = i - on;
            nodes.push_back(at((on - 0.5 * arc) * turn) + off * out * turn * along[off > 0]);
        }
        const double link = out * turn, bending = 1e-4 * load * out * out;  // a ten-thousandth of what would change the ratio by as much
        def = {.radius = 0.5 * diameter, .young = 64 * bending / (pi * std::pow(diameter, 4)), .friction = friction, .density = 1000,
               .axial_over_bending = 1e4 * load * link * link / bending};
    }

    static Vec3 at(double angle) { return {out * std::sin(angle), pitch * angle / (2 * pi), out * std::cos(angle)}; }
    static Vec3 tangent(double angle) { return Vec3(std::cos(angle), pitch / (2 * pi * out), -std::sin(angle)).normalized(); }
    int last() const { return static_cast<int>(nodes.size()) - 1; }

    std::array<Vec3, 2> along;
    std::vector<Vec3> nodes;
    sim::thread::RodDef def;
    const sim::geometry::Capsule body{{0, -1, 0}, {0, 1, 0}, cylinder};
    const sim::thread::MovingCapsule bodies[1] = {{body, body, 0}};
};

}  // namespace

double capstan_of_nodes(double friction, double wrap, double turn) {
    return std::pow(ratio_over_node(friction, turn), wrap / turn);
}

Compared rod_capstan(double friction, double wrap, double turn, double tick) {
    Wound wound(friction, wrap, turn);
    wound.def.density = 0;
    Rod rod(wound.def, wound.nodes);
    std::vector<Vec3> loads(wound.nodes.size(), Vec3::Zero());
    loads[0] = -load * wound.along[0];
    constexpr double speed = 0.01, way = 4 * diameter;  // slides over the second half of it
    const int ticks = static_cast<int>(way / (speed * tick));
    double sum = 0;
    int count = 0;
    for (int t = 0; t < ticks; ++t) {
        const sim::thread::Hold pull[] = {{wound.last(), rod.nodes().back() + speed * tick * wound.along[1]}};
        rod.step({.holds = pull, .loads = loads, .bodies = wound.bodies}, 0, 50);
        if (2 * t >= ticks) sum += rod.tension(wound.last() - 1) / rod.tension(0), ++count;
    }
    return {sum / count, std::exp(friction * wrap)};
}

double rod_slides(double friction, double wrap, double turn, double share) {
    const Wound wound(friction, wrap, turn);
    Rod rod(wound.def, wound.nodes);
    constexpr int ramp = 300, settle = 400, ticks = 1400;
    const double most = share * capstan_of_nodes(friction, wrap, turn);
    const std::size_t middle = wound.nodes.size() / 2;
    Vec3 start = Vec3::Zero();
    for (int t = 0; t < ticks; ++t) {
        std::vector<Vec3> loads(wound.nodes.size(), Vec3::Zero());
        loads.front() = -load * wound.along[0];
        loads.back() = load * (1 + std::min(1.0, static_cast<double>(t) / ramp) * (most - 1)) * wound.along[1];
        rod.step({.holds = {}, .loads = loads, .bodies = wound.bodies}, 1e-3);
        if (t == settle) start = rod.nodes()[middle];
        if (t > settle && (rod.nodes()[middle] - start).norm() > diameter) break;
    }
    return (rod.nodes()[middle] - start).norm() / diameter;
}

}  // namespace app::bench
