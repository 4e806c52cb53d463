#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/tool_starts.hpp"
#include "app/commands/warnings.hpp"
#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/machine.hpp"
#include "app/play/output.hpp"
#include "app/play/recorded.hpp"
#include "app/progress.hpp"
#include "app/report/result_json.hpp"
#include "scenarios/drill/motion.hpp"

namespace app {

namespace {

using instruments::ToolInput;
using scenarios::drill::Drill;

std::optional<scenarios::recording::Recorder> open_recorder(const RunOptions& options, const Drill& drill) {
    if (options.record.empty()) return {};
    const std::filesystem::path file = options.record;
    if (file.has_parent_path()) make_folder("--record", file.parent_path());
    expect_writable("--record", file);
    return scenarios::recording::Recorder(file, head_of(drill, options.drill, {.device = "motion file"}));
}

// One tick after another; what was recorded is safe up to the last flush whatever happens after it.
std::vector<Snapshot> play(Session& session, const scenarios::drill::Motion& motion, std::uint64_t ticks,
                           int most_frames, std::optional<scenarios::recording::Recorder>& recorder) {
    const double tick_s = session.drill().world.tick_s;
    std::vector<ToolInput> inputs(session.drill().world.instruments.size());
    std::vector<Snapshot> frames;
    std::size_t events = 0;
    Progress progress(static_cast<double>(ticks) * tick_s);
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        motion.at(static_cast<double>(tick) * tick_s, inputs);
        if (recorder) recorder->add_tick(inputs);
        session.tick(inputs);
        if (most_frames > 0 && tick * static_cast<std::uint64_t>(most_frames) / ticks >= frames.size())
            frames.push_back(session.snapshot(""));
        if (recorder) {
            if (const auto trouble = recorder->trouble()) throw std::runtime_error(*trouble);
            using scenarios::recording::hash_period;
            if ((tick + 1) % hash_period == 0 || tick + 1 == ticks)
                recorder->add_hash(tick + 1, session.world().hash());
            for (const auto all = session.world().events(); events < all.size(); ++events)
                recorder->add_event(all[events]);
        }
        progress.at(session.world().time_s());
    }
    return frames;
}

}  // namespace

int run_command(const RunOptions& options) {
    Drill drill = scenarios::drill::load_drill(options.drill);
    if (!options.thread.empty()) {
        if (options.thread != "ftl" && options.thread != "elastic")
            throw InputFault("--thread: error: expected ftl or elastic, found " + options.thread);
        if (!options.record.empty() && options.thread != drill.world.thread.model)
            throw InputFault("--thread " + options.thread +
                             ": error: a recording is of the drill as it is, expected \"model\": \"" + options.thread +
                             "\" in " + options.drill);
        const auto feels = [](const scenarios::world::InstrumentDef& of) { return std::isfinite(of.pull); };
        if (const auto& all = drill.world.instruments;
            options.thread == "ftl" && std::any_of(all.begin(), all.end(), feels))
            throw InputFault(
                "--thread ftl: error: a thread moved by ftl has no forces to feel, expected no \"pull_N\" in " +
                options.drill);
        if (options.thread == "ftl" && (drill.world.thread.weighs || drill.world.thread.yield_strain > 0))
            throw InputFault(
                "--thread ftl: error: a thread moved by ftl has neither weight nor plastic set, expected both off in " +
                options.drill);
        drill.world.thread.model = options.thread;
    }
    const std::filesystem::path motion_file =
        options.input.empty() ? drill.motion : std::filesystem::path(options.input);
    if (motion_file.empty())
        throw InputFault(options.drill + ": error: /motion: the drill names no motion, give one with --input MOTION");
    const auto motion = scenarios::drill::load_motion(motion_file, scenarios::drill::instrument_names(drill));

    for (const std::string& warning : warnings_of(drill, &motion))
        std::cerr << options.drill << ": warning: " << warning << '\n';

    std::vector<ToolInput> start(drill.world.instruments.size());
    motion.at(0, start);
    check_tool_starts(drill, scenarios::session::vessel_meshes(drill.world), start, motion_file.string());
    Session session(drill, start, processor_us);
    if (!options.out.empty()) expect_output(options.out, {options.drill, motion_file, options.record});
    auto recorder = open_recorder(options, drill);

    const double length_s = std::min(motion.duration() + scenarios::drill::settling_s, drill.time_limit_s);
    const auto frames = play(session, motion, static_cast<std::uint64_t>(std::ceil(length_s / drill.world.tick_s)),
                             options.frames, recorder);
    auto result = session.finish();
    result.machine = machine_name();
    if (recorder) {
        recorder->set_scores(result.items);
        recorder->finish();
    }
    if (!options.out.empty()) write_output(options.out, session, result, frames);
    std::cout << (options.json ? report::result_json(result) : score_table(result));
    return 0;
}

}  // namespace app
