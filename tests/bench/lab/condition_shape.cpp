#include <algorithm>
#include <cmath>

#include "sim/geometry/closest_points.hpp"
#include "sim/knot/namer.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/start_shapes.hpp"
#include "tests/bench/lab/trace.hpp"

// Conditions on where the thread lies, measured from its nodes alone: they share no code with the solver's contacts.
namespace bench::lab {

namespace {

using sim::geometry::closest_points;

constexpr int every = 10;  // [ticks] Testing all pairs after each tick would take longer than the tick.

/// The least of what a frame says, every tenth tick and after the last.
template <typename Figure>
double least(const Trace& trace, const Condition& condition, double none, Figure figure) {
    double value = none;
    for (std::size_t i = 0; i < trace.frames.size(); ++i) {
        const double t = static_cast<double>(i + 1) * trace.tick;
        const bool due = (i + 1) % every == 0 || i + 1 == trace.frames.size();
        if (due && t >= condition.from && t <= condition.to) value = std::min(value, figure(trace.frames[i]));
    }
    return value;
}

constexpr double far = 3;  // [D] what nothing comes near to is told as this

double reported_separation(const Trace& trace, const Condition& condition) {
    double value = far;
    for (std::size_t i = 0; i < trace.frames.size(); ++i) {
        const double t = static_cast<double>(i + 1) * trace.tick;
        if (t >= condition.from && t <= condition.to) value = std::min(value, trace.frames[i].report.separation_min);
    }
    return value;
}

bool is_cut(const Frame& frame, std::size_t link) {
    return std::find(frame.cuts.begin(), frame.cuts.end(), static_cast<int>(link)) != frame.cuts.end();
}

// Of a thread that was cut, in any of its pieces.
bool has_knot(const Trace& trace, const std::string& knot) {
    return std::any_of(trace.pieces.begin(), trace.pieces.end(),
                       [&](const auto& piece) { return sim::knot::name_knot(piece).knot == knot; });
}

double gap_to_tools(const Trace& trace, const Frame& frame) {
    double gap = far * trace.diameter;
    for (const Capsule& tool : frame.tools)
        for (std::size_t i = 0; i + 1 < frame.nodes.size(); ++i) {
            if (is_cut(frame, i)) continue;
            const double d2 = closest_points(frame.nodes[i], frame.nodes[i + 1], tool.a, tool.b).distance_squared;
            gap = std::min(gap, std::sqrt(d2) - tool.radius - trace.diameter / 2);
        }
    return gap / trace.diameter;
}

double gap_to_surface(const Scene& scene, const Trace& trace, const Frame& frame) {
    double gap = far * trace.diameter;
    for (const auto& triangle : scene.surface) {
        sim::geometry::Box box;
        for (const Vec3* corner : {&triangle.a, &triangle.b, &triangle.c}) box.include(*corner);
        for (std::size_t i = 0; i + 1 < frame.nodes.size(); ++i) {
            if (is_cut(frame, i)) continue;
            sim::geometry::Box link;
            link.include(frame.nodes[i]);
            link.include(frame.nodes[i + 1]);
            if (!link.grown(gap + trace.diameter / 2).overlaps(box)) continue;  // no nearer than what is known
            const double d2 = closest_points(frame.nodes[i], frame.nodes[i + 1], triangle).distance_squared;
            gap = std::min(gap, std::sqrt(d2) - trace.diameter / 2);
        }
    }
    return gap / trace.diameter;
}

Gauge gauge(const Trace& trace) {
    return {trace.rest, trace.diameter};
}

double consumed(const Trace& trace, const Frame& frame) {
    return gauge(trace).kappa(frame.nodes);
}

double length_error(const Trace& trace) {
    return std::abs(length_of(trace.nodes()) / gauge(trace).length() - 1);
}

// Every 100 ticks, and a name that is not certain says nothing.
double name_changes(const Trace& trace) {
    constexpr std::size_t period = 100;
    std::string name = sim::knot::name_knot(trace.start).knot;
    double changes = 0;
    for (std::size_t i = period - 1; i < trace.frames.size(); i += period) {
        const auto now = sim::knot::name_knot(trace.frames[i].nodes);
        changes += now.certain && now.knot != name;
        if (now.certain) name = now.knot;
    }
    return changes;
}

using S = const Scene&;
using T = const Trace&;
using C = const Condition&;

}  // namespace

const std::vector<ConditionKind>& shape_kinds() {
    static const std::vector<ConditionKind> kinds{
        {"knot_differs", "count", "1 where the knot in the end is not the one named",
         [](S, T t, C c) { return has_knot(t, c.knot) ? 0.0 : 1.0; }},
        {"knot_changes", "count", "times the knot took another name", [](S, T t, C) { return name_changes(t); }},
        {"separation_min", "D", "smallest distance of strands, by the solver",
         [](S, T t, C c) { return reported_separation(t, c); }},
        {"separation_measured", "D", "the same measured over all pairs of links, every tenth tick",
         [](S, T t, C c) { return least(t, c, far, [gap = gauge(t)](const Frame& f) { return gap.gap(f.nodes); }); }},
        {"tool_gap_min", "D", "smallest gap between thread and tools; negative: into the steel",
         [](S, T t, C c) { return least(t, c, far, [&](const Frame& f) { return gap_to_tools(t, f); }); }},
        {"surface_gap_min", "D", "smallest gap between thread and wall; negative: into the wall",
         [](S s, T t, C c) { return least(t, c, far, [&](const Frame& f) { return gap_to_surface(s, t, f); }); }},
        {"length_error", "share", "whole length in the end, from what it was",
         [](S, T t, C) { return length_error(t); }},
        {"consumed_final", "D", "thread length less distance of its ends, in the end",
         [](S, T t, C) { return consumed(t, t.frames.back()); }},
        {"consumed_min", "D", "the same at its least",
         [](S, T t, C c) { return least(t, c, 1e300, [&](const Frame& f) { return consumed(t, f); }); }},
        {"slipped", "D", "how much farther apart the ends are than they were at from_s",
         [](S, T t, C c) {
             const auto tick = static_cast<std::size_t>(c.from / t.tick);
             return consumed(t, t.frames[std::min(tick, t.frames.size() - 1)]) - consumed(t, t.frames.back());
         }},
    };
    return kinds;
}

}  // namespace bench::lab
