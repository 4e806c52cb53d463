#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/geometry/resample.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/start_shapes.hpp"

namespace scene {

using bench::lab::taken_up;
using sim::geometry::Vec3;
using sim::thread::Hold;
using sim::thread::Thread;
using sim::thread::ThreadDef;
using sim::thread::TickInput;
using sim::thread::TickReport;

constexpr double radius = ThreadDef{}.radius;  // [m]
constexpr double tick = 1e-3;                  // [s]

/// An open overhand knot, loose, of `links` links of one thread thickness.
inline std::vector<Vec3> overhand(int links = 200, double thread_radius = radius) {
    std::vector<Vec3> path = bench::lab::overhand_path();
    const double scale = 2 * thread_radius * links / bench::lab::length_of(path);
    for (Vec3& p : path) p *= scale;
    return sim::geometry::resample(path, links);
}

/// A straight thread along x from the origin, links of one thread thickness.
inline std::vector<Vec3> straight(int links, double thread_radius = radius) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.emplace_back(2 * thread_radius * i, 0, 0);
    return nodes;
}

/// The worst of all ticks so far.
struct Worst {
    int ticks = 0, pass_throughs = 0;
    double stretch = 0, step_over_bound = 0, fraction = 1;

    void add(const TickReport& report) {
        ++ticks;
        pass_throughs += report.pass_throughs;
        stretch = std::max(stretch, report.stretch_max);
        step_over_bound = std::max(step_over_bound, report.step_over_bound);
        fraction = std::min(fraction, report.fraction);
    }
};

/// Both ends held, moved apart along the line between them.
struct Pull {
    int first = 0, last;
    Vec3 left, right, away;

    explicit Pull(const Thread& thread) : last(static_cast<int>(thread.nodes().size()) - 1) {
        left = thread.nodes().front();
        right = thread.nodes().back();
        away = (right - left).normalized();
    }

    /// One tick with each end `step` [m] farther out than it is.
    TickReport by(Thread& thread, double step) {
        left = thread.nodes().front() - step * away;
        right = thread.nodes().back() + step * away;
        return hold(thread);
    }

    /// One tick with the tools where they are.
    TickReport hold(Thread& thread) const {
        const Hold holds[] = {{first, left}, {last, right}};
        const int owners[] = {-1, -1};
        return thread.tick({holds, owners, {}, nullptr});
    }
};

inline Worst tighten(Thread& thread, Pull& pull, double speed, int most_ticks) {
    Worst worst;
    for (int i = 0; i < most_ticks; ++i) {
        worst.add(pull.by(thread, speed * tick));
        if (worst.fraction < 1e-3) break;  // jammed: the knot is tight
    }
    return worst;
}

inline double end_distance(const Thread& thread) {
    return (thread.nodes().back() - thread.nodes().front()).norm();
}

}  // namespace scene
