#include "tests/bench/lab/drill_play.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scenarios/drill/motion.hpp"
#include "scenarios/session/session.hpp"
#include "sim/geometry/resample.hpp"
#include "tests/bench/lab/wall_watch.hpp"

namespace bench::lab {

using instruments::ToolInput;
using scenarios::drill::Motion;

namespace {

/// What the hands' device says of one tool at a time, without faults and with.
struct Device {
    const Motion& motion;
    std::vector<ToolInput> all;

    ToolInput at(double t, std::size_t tool) {
        motion.at(t, all);
        return all[tool];
    }
    // As a device of `hz` reports it and a player draws straight lines between its reports.
    ToolInput sampled(double t, std::size_t tool, double hz) {
        const double before = std::floor(t * hz) / hz, share = (t - before) * hz;
        const ToolInput a = at(before, tool), b = at(before + 1 / hz, tool);
        return {instruments::between(a.pose, b.pose, share), a.jaw + share * (b.jaw - a.jaw)};
    }
    ToolInput spoilt(const Fault& fault, double t, std::size_t tool, ToolInput input) {
        auto& rotation = input.pose.rotation.coeffs();
        switch (fault.kind) {
            case Fault::Kind::nan:
                input.pose.position.y() = std::numeric_limits<double>::quiet_NaN();
                break;
            case Fault::Kind::infinite:
                input.pose.position.x() = std::numeric_limits<double>::infinity();
                break;
            case Fault::Kind::zero_rotation:
                rotation.setZero();
                break;
            case Fault::Kind::long_rotation:
                rotation *= 2;
                break;  // a power of two: normalising it rounds nothing
            case Fault::Kind::flipped_rotation:
                rotation = -rotation;
                break;
            case Fault::Kind::frozen:
                input = at(fault.from, tool);
                break;
            case Fault::Kind::leap:
                input.pose.position += fault.by;
                break;
            case Fault::Kind::sampled:
                input = sampled(t, tool, fault.hz);
                break;
        }
        return input;
    }
};

// With the thread asked for: what the drill does not say is as that has it.
scenarios::drill::Drill drill_of(const Scene& scene) {
    scenarios::drill::Drill drill = scenarios::drill::load_drill(scene.drill);
    if (scene.model.empty()) return drill;
    auto value = nlohmann::json::parse(drill.text);
    value["thread"]["model"] = scene.model;
    return scenarios::drill::parse_drill(value.dump(), scene.drill.string(), scene.drill.parent_path());
}

// What of the session's worst is of this tick cannot be told apart; each frame carries the worst so far.
Frame frame_of(const scenarios::world::World& world, std::uint64_t passed_before) {
    Frame frame;
    // As many as at first, in the same places along the thread, though its links change: so that two ways can be
    // compared.
    frame.nodes = sim::geometry::resample(world.thread(), world.def().thread.links);
    for (const auto& tool : world.tools()) {
        for (const auto& part : instruments::parts_at(tool.shape, tool.now.pose, tool.now.jaw))
            frame.tools.push_back(part);
        if (!tool.grasps.empty()) frame.lag = std::max(frame.lag, tool.lag());
    }
    frame.report.stretch_max = world.stretch_now();
    frame.report.separation_min = world.worst().separation;
    frame.report.step_over_bound = world.worst().step_over_bound;
    frame.report.contacts = world.worst().contacts;
    frame.report.pass_throughs = static_cast<int>(world.measures().pass_throughs - passed_before);
    frame.tension = world.tension_now();
    return frame;
}

}  // namespace

Trace play_drill(const Scene& scene) {
    const auto drill = drill_of(scene);
    const auto names = scenarios::drill::instrument_names(drill);
    const Motion motion = scenarios::drill::load_motion(drill.motion, names);
    std::vector<ToolInput> inputs(names.size());
    motion.at(0, inputs);
    Device device{motion, inputs};
    scenarios::session::Session session(drill, inputs);
    const auto& world = session.world();
    Trace trace{
        drill.world.tick_s, drill.world.thread.diameter, {world.thread().begin(), world.thread().end()}, {}, {}, 0, 0};
    trace.rest.assign(world.thread_state().rest_lengths().begin(), world.thread_state().rest_lengths().end());
    WallWatch watch(world);
    for (int tick = 0; tick < scene.duration / trace.tick; ++tick) {
        const double t = tick * trace.tick;
        const std::uint64_t passed_before = world.measures().pass_throughs;
        for (std::size_t i = 0; i < names.size(); ++i) {
            inputs[i] = device.at(t, i);
            for (const Fault& fault : scene.faults)
                if (fault.input == names[i] && fault.from <= t && t <= fault.to)
                    inputs[i] = device.spoilt(fault, t, i, inputs[i]);
        }
        session.tick(inputs);
        trace.frames.push_back(frame_of(world, passed_before));
        watch.look(world, trace.frames.back());
    }
    trace.hash = world.hash();
    trace.pieces = world.curves();
    watch.conclude(world, trace);
    for (const auto& event : world.events())
        trace.inputs_dropped += event.kind == scenarios::world::EventKind::input_dropped;
    return trace;
}

}  // namespace bench::lab
