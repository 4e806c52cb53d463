#include "app/rope/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

namespace app::rope {

namespace {

using sim::thread::Hold;
using sim::thread::Thread;
using sim::thread::TickReport;

// Times in files are decimal and so is the tick: their quotient may miss a whole number by rounding alone.
constexpr double rounding = 1e-6;  // [ticks]

double last_time(const std::vector<HeldNode>& motion) {
    double t = 0;
    for (const HeldNode& held : motion) t = std::max(t, held.keys.back().t);
    return t;
}

struct Holds {
    std::vector<Hold> holds;
    std::vector<int> owners;

    void at(const std::vector<HeldNode>& motion, double t, double slack) {
        holds.clear();
        for (const HeldNode& held : motion)
            if (held.held_at(t - slack) || held.held_at(t + slack)) holds.push_back({held.node, held.place_at(t)});
        owners.assign(holds.size(), -1);
    }
};

double length_of(std::span<const Vec3> nodes) {
    double length = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) length += (nodes[i] - nodes[i - 1]).norm();
    return length;
}

double largest_lag(const Thread& thread, std::span<const Hold> holds) {
    double lag = 0;
    for (const Hold& hold : holds)
        lag = std::max(lag, (hold.target - thread.nodes()[static_cast<std::size_t>(hold.node)]).norm());
    return lag;
}

void add(Measured& measured, const TickReport& report) {
    measured.substeps += report.substeps;
    measured.stretch_max = std::max(measured.stretch_max, report.stretch_max);
    measured.stretch_settled = report.stretch_max;
    measured.separation_min = std::min(measured.separation_min, report.separation_min);
    measured.step_over_bound = std::max(measured.step_over_bound, report.step_over_bound);
    measured.pass_throughs += report.pass_throughs;
    measured.contacts_max = std::max(measured.contacts_max, report.contacts);
}

void write_positions(std::ostream& out, const Thread& thread, std::int64_t tick, double t) {
    nlohmann::ordered_json line = {{"t", t}, {"tick", tick}, {"x", nlohmann::ordered_json::array()}};
    for (const Vec3& p : thread.nodes()) line["x"].push_back({p.x() * 1000, p.y() * 1000, p.z() * 1000});
    line["tension_N"] = std::vector<double>(thread.tension().begin(), thread.tension().end());
    out << line.dump() << '\n';
}

}  // namespace

double ticks_of(const Experiment& experiment) {
    return std::ceil(last_time(experiment.motion) / experiment.tick - rounding);
}

Measured run(const Experiment& experiment) {
    Thread thread(experiment.thread, experiment.nodes);
    const double length = length_of(thread.nodes());
    const auto ticks = static_cast<std::int64_t>(ticks_of(experiment));
    Measured measured;
    measured.ticks = ticks;
    measured.tick_us.reserve(static_cast<std::size_t>(ticks));
    Holds now;
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
        const double t =
            std::min(static_cast<double>(tick) * experiment.tick,
                     last_time(experiment.motion));  // what is held at the end is held to the end of a tick
        now.at(experiment.motion, t, rounding * experiment.tick);
        const auto start = std::chrono::steady_clock::now();
        const TickReport report = thread.tick({now.holds, now.owners, {}, experiment.obstacle, experiment.tick});
        const std::chrono::duration<float, std::micro> taken = std::chrono::steady_clock::now() - start;
        measured.tick_us.push_back(taken.count());
        add(measured, report);
        measured.lag_final = largest_lag(thread, now.holds);
        measured.lag_max = std::max(measured.lag_max, measured.lag_final);
        for (const double tension : thread.tension()) measured.tension_max = std::max(measured.tension_max, tension);
        if (experiment.positions && tick % experiment.every == 0)
            write_positions(*experiment.positions, thread, tick, t);
    }
    std::sort(measured.tick_us.begin(), measured.tick_us.end());
    measured.stretch_total = std::abs(length_of(thread.nodes()) / length - 1);
    measured.hash = thread.hash();
    measured.nodes.assign(thread.nodes().begin(), thread.nodes().end());
    return measured;
}

}  // namespace app::rope
