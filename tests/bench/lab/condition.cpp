#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/trace.hpp"

// What conditions measure along the way. Each is a number, so that each can miss its bound.
namespace bench::lab {

namespace {

template <typename Figure>
double sum(const Trace& trace, Figure figure) {
    double value = 0;
    for (const Frame& frame : trace.frames) value += static_cast<double>(figure(frame));
    return value;
}

double is_broken(const Vec3& p) {
    return p.allFinite() ? 0 : 1;
}

double broken_nodes(const Frame& frame) {
    double count = 0;
    for (const Vec3& p : frame.nodes) count += is_broken(p);
    return count;
}

/// The most of what one frame and the next say, within the condition's time.
template <typename Figure>
double most_between(const Trace& trace, const Condition& condition, Figure figure) {
    double value = 0;
    for (std::size_t i = 1; i < trace.frames.size(); ++i) {
        const double t = static_cast<double>(i + 1) * trace.tick;
        if (t > condition.from && t <= condition.to)
            value = std::max(value, figure(trace.frames[i - 1].nodes, trace.frames[i].nodes));
    }
    return value;
}

// In a tick that cut it the thread's nodes are not the same ones.
double rms_move(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    if (a.size() != b.size()) return 0;
    double sum_of_squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum_of_squares += (b[i] - a[i]).squaredNorm();
    return std::sqrt(sum_of_squares / static_cast<double>(a.size()));
}

double largest_move(const std::vector<Vec3>& a, const std::vector<Vec3>& b, int node) {
    if (node >= 0) return (b[static_cast<std::size_t>(node)] - a[static_cast<std::size_t>(node)]).norm();
    double largest = 0;
    for (std::size_t i = 0; i < a.size() && a.size() == b.size(); ++i)
        largest = std::max(largest, (b[i] - a[i]).norm());
    return largest;
}

const std::vector<Vec3>& nodes_at(const Trace& trace, double t) {
    const auto tick = static_cast<std::size_t>(std::lround(t / trace.tick));
    return tick == 0 ? trace.start : trace.frames[std::min(tick, trace.frames.size()) - 1].nodes;
}

double tool_way(const Trace& trace, const Condition& condition) {
    const auto tool = static_cast<std::size_t>(condition.tool);
    const auto tick = static_cast<std::size_t>(condition.from / trace.tick);
    const auto middle = [&](const Frame& frame) { return Vec3((frame.tools[tool].a + frame.tools[tool].b) / 2); };
    return (middle(trace.frames.back()) - middle(trace.frames[std::min(tick, trace.frames.size() - 1)])).norm();
}

double tension_ratio(const Trace& trace) {
    const Frame& end = trace.frames.back();
    const double low = std::min(end.tension_first, end.tension_last);
    return low > 0 ? std::max(end.tension_first, end.tension_last) / low : 0;
}

using S = const Scene&;
using T = const Trace&;
using C = const Condition&;

const std::vector<ConditionKind> along_the_way{
    {"pass_throughs", "count", "strands that went through something, by the audit",
     [](S, T t, C) { return sum(t, [](const Frame& f) { return f.report.pass_throughs; }); }},
    {"stretch_max", "share", "longest or shortest link at any tick, from its length",
     [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.report.stretch_max; }); }},
    {"stretch_settled", "share", "the same after the last tick",
     [](S, T t, C) { return t.frames.back().report.stretch_max; }},
    {"step_over_bound", "ratio", "largest move of a node in a substep over its bound",
     [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.report.step_over_bound; }); }},
    {"rest_rms_per_tick", "R", "motion per tick of a thread whose tools are still, rms over nodes, in radii",
     [](S, T t, C c) { return most_between(t, c, rms_move) / (t.diameter / 2); }},
    {"node_speed_max", "m/s", "fastest node from one tick to the next",
     [](S, T t, C c) {
         return most_between(t, c, [&](const auto& a, const auto& b) { return largest_move(a, b, c.node); }) / t.tick;
     }},
    {"moved", "D", "how far a node is from where it was, in thread diameters",
     [](S, T t, C c) { return largest_move(nodes_at(t, c.from), nodes_at(t, c.to), c.node) / t.diameter; }},
    {"tool_moved", "mm", "how far a tool part has come", [](S, T t, C c) { return tool_way(t, c) / mm; }},
    {"lag_final", "mm", "held node behind its tool in the end", [](S, T t, C) { return t.frames.back().lag / mm; }},
    {"lag_max", "mm", "held node behind its tool at any tick",
     [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.lag; }) / mm; }},
    {"tension_max", "N", "most tension of any link at any tick",
     [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.tension; }); }},
    {"tension_final", "N", "most tension of any link in the end", [](S, T t, C) { return t.frames.back().tension; }},
    {"tension_ratio", "ratio", "tension of the end pulled harder over that of the other; 0 if one is slack",
     [](S, T t, C) { return tension_ratio(t); }},
    {"not_finite_reported", "ticks", "ticks refused because their input was not finite",
     [](S, T t, C) { return sum(t, [](const Frame& f) { return f.report.not_finite; }); }},
    {"not_finite_nodes", "count", "nodes whose place is not a number, over all ticks",
     [](S, T t, C) { return sum(t, broken_nodes); }},
    {"inputs_dropped", "count", "inputs of a drill that were dropped, by its events",
     [](S, T t, C) { return static_cast<double>(t.inputs_dropped); }},
    {"breaks", "count", "times the thread broke", [](S, T t, C) { return static_cast<double>(t.breaks); }},
    {"broke_off_knot", "D", "how far along the thread from where strands touch it broke",
     [](S, T t, C) { return t.broke_off / t.diameter; }},
    {"pieces", "count", "pieces of thread in the end", [](S, T t, C) { return static_cast<double>(t.pieces.size()); }},
    {"lost", "D", "length that cuts and breaks took, in thread diameters",
     [](S, T t, C) { return t.lost / t.diameter; }},
    {"contacts_max", "count", "contacts of one substep at most",
     [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.report.contacts; }); }},
    {"substeps_max", "count", "substeps of one tick at most: what a tick may cost, on any machine",
     [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.report.substeps; }); }},
};

}  // namespace

const std::vector<ConditionKind>& condition_kinds() {
    static const auto all = [] {
        std::vector<ConditionKind> kinds = along_the_way;
        for (const auto* more : {&shape_kinds(), &wall_kinds(), &energy_kinds(), &twin_kinds()})
            kinds.insert(kinds.end(), more->begin(), more->end());
        return kinds;
    }();
    return all;
}

const ConditionKind& condition_kind(const std::string& name) {
    for (const ConditionKind& kind : condition_kinds())
        if (name == kind.name) return kind;
    throw std::logic_error("no condition " + name);
}

}  // namespace bench::lab
