#include "tests/bench/lab/rod_capstan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/rod/rod.hpp"
#include "tests/bench/lab/capstan.hpp"

namespace bench::lab {

namespace {

using sim::rod::Rod;
using sim::thread::Vec3;

using std::numbers::pi;

constexpr double rod_diameter = 1e-3, rod_cylinder = 5 * rod_diameter,
                 rod_out = rod_cylinder + 0.5 * rod_diameter;  // [m]; `out` is where nodes lie
constexpr double rod_load = 0.1;                               // [N]
constexpr double rod_pitch = 0.6 * rod_out;                    // of a turn: turns beside each other never meet
constexpr double inextensible = 1e-4, as_suture = 1e-3;        // stretched by the load by so much
constexpr int rod_tail = 30;                                   // links that are off the cylinder at either end

// `strain`: what the load stretches it by.
struct Wound {
    Wound(double friction, double wrap, double turn, double strain) : along{tangent(-wrap / 2), tangent(wrap / 2)} {
        const int arc = static_cast<int>(std::lround(wrap / turn));
        for (int i = -rod_tail; i <= arc + rod_tail; ++i) {
            const int on = std::clamp(i, 0, arc), off = i - on;
            nodes.push_back(at((on - 0.5 * arc) * turn) + off * rod_out * turn * along[off > 0]);
        }
        // Its stiffness against bending changes the ratio by a ten-thousandth.
        const double young = rod_load / strain / (pi * rod_diameter * rod_diameter / 4),
                     bending = 1e-4 * rod_load * rod_out * rod_out;
        def = {.radius = 0.5 * rod_diameter,
               .young = young,
               .bending_share = 64 * bending / (pi * std::pow(rod_diameter, 4)) / young,
               .friction = friction,
               .density = 1000,
               .axial_over_bending = 0};
    }

    static Vec3 at(double angle) {
        return {rod_out * std::sin(angle), rod_pitch * angle / (2 * pi), rod_out * std::cos(angle)};
    }
    static Vec3 tangent(double angle) {
        return Vec3(std::cos(angle), rod_pitch / (2 * pi * rod_out), -std::sin(angle)).normalized();
    }
    int last() const { return static_cast<int>(nodes.size()) - 1; }

    std::array<Vec3, 2> along;
    std::vector<Vec3> nodes;
    sim::thread::RodDef def;
    const sim::geometry::Capsule body{{0, -1, 0}, {0, 1, 0}, rod_cylinder};
    const sim::thread::MovingCapsule bodies[1] = {{body, body, 0}};
};

sim::thread::Thread elastic(const Wound& wound, double friction) {
    return {{.radius = wound.def.radius, .friction = friction, .friction_tool = friction, .elastic = wound.def},
            wound.nodes};
}

double pulled_with(const Rod& rod, int link) {
    return rod.tension(link);
}
double pulled_with(const sim::thread::Thread& thread, int link) {
    return thread.tension()[static_cast<std::size_t>(link)];
}

}  // namespace

double capstan_of_nodes(double friction, double wrap, double turn) {
    return std::pow(ratio_over_node(friction, turn), wrap / turn);
}

// `pull` makes one tick with nodes held there, and these forces on all.
template <class Moving, class Pull>
static Compared slide(const Wound& wound, double friction, double wrap, double tick, const Moving& thread,
                      const Pull& pull) {
    std::vector<Vec3> loads(wound.nodes.size(), Vec3::Zero());
    loads[0] = -rod_load * wound.along[0];
    constexpr double speed = 0.01, way = 10 * rod_diameter;  // slides over the second half of it
    const int ticks = static_cast<int>(way / (speed * tick));
    double sum = 0;
    int count = 0;
    for (int t = 0; t < ticks; ++t) {
        const sim::thread::Hold hold[] = {{wound.last(), thread.nodes().back() + speed * tick * wound.along[1]}};
        pull(hold, loads);
        if (2 * t >= ticks) sum += pulled_with(thread, wound.last() - 1) / pulled_with(thread, 0), ++count;
    }
    return {sum / count, std::exp(friction * wrap)};
}

Compared rod_capstan(double friction, double wrap, double turn, double tick) {
    Wound wound(friction, wrap, turn, inextensible);
    wound.def.density = 0;
    Rod rod(wound.def, wound.nodes);
    return slide(wound, friction, wrap, tick, rod,
                 [&](std::span<const sim::thread::Hold> holds, std::span<const Vec3> loads) {
                     rod.step({.holds = holds, .loads = loads, .bodies = wound.bodies}, 0, 50);
                 });
}

Compared elastic_capstan(double friction, double wrap, double turn, double tick, Cost& cost) {
    const Wound wound(friction, wrap, turn, as_suture);
    auto thread = elastic(wound, friction);
    const int owners[] = {-1};
    cost.links = wound.last();
    return slide(wound, friction, wrap, tick, thread,
                 [&](std::span<const sim::thread::Hold> holds, std::span<const Vec3> loads) {
                     cost.of([&] { return thread.tick({holds, owners, wound.bodies, nullptr, tick, loads}); });
                 });
}

// What `Pull` makes of it: it must carry `share` of what slides for a polyline; how far its middle goes in a second
// after that [D].
template <class Moving, class Pull>
static double slides(const Wound& wound, double most, const Moving& thread, const Pull& pull) {
    constexpr int ramp = 300, settle = 400, ticks = 1400;
    const std::size_t middle = wound.nodes.size() / 2;
    Vec3 start = Vec3::Zero();
    for (int t = 0; t < ticks; ++t) {
        std::vector<Vec3> loads(wound.nodes.size(), Vec3::Zero());
        loads.front() = -rod_load * wound.along[0];
        loads.back() = rod_load * (1 + std::min(1.0, static_cast<double>(t) / ramp) * (most - 1)) * wound.along[1];
        pull({}, loads);
        if (t == settle) start = thread.nodes()[middle];
        if (t > settle && (thread.nodes()[middle] - start).norm() > rod_diameter) break;
    }
    return (thread.nodes()[middle] - start).norm() / rod_diameter;
}

double rod_slides(double friction, double wrap, double turn, double share) {
    const Wound wound(friction, wrap, turn, inextensible);
    Rod rod(wound.def, wound.nodes);
    return slides(wound, share * capstan_of_nodes(friction, wrap, turn), rod,
                  [&](std::span<const sim::thread::Hold> holds, std::span<const Vec3> loads) {
                      rod.step({.holds = holds, .loads = loads, .bodies = wound.bodies}, 1e-3);
                  });
}

double elastic_slides(double friction, double wrap, double turn, double share) {
    const Wound wound(friction, wrap, turn, as_suture);
    auto thread = elastic(wound, friction);
    return slides(wound, share * capstan_of_nodes(friction, wrap, turn), thread,
                  [&](std::span<const sim::thread::Hold> holds, std::span<const Vec3> loads) {
                      thread.tick({holds, {}, wound.bodies, nullptr, 1e-3, loads});
                  });
}

}  // namespace bench::lab
