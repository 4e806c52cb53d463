#include <functional>
#include <memory>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/play/output.hpp"
#include "app/play/recorded.hpp"
#include "app/report/text.hpp"
#include "scenarios/drill/motion.hpp"

namespace app {

namespace {

using instruments::ToolInput;

// The scene of a drill, before or after part of its motion, or of a recording.
struct Source {
    scenarios::drill::Drill drill;
    std::function<void(std::uint64_t, std::span<ToolInput>)> inputs_at;
    double duration_s = 0;
    std::optional<std::string> damage;
};

Source from_drill(const std::string& file) {
    Source source{scenarios::drill::load_drill(file), {}, 0, {}};
    if (source.drill.motion.empty())
        throw InputFault(file + ": error: /motion: the drill names no motion, so where its tools are is not known");
    const auto motion =
        scenarios::drill::load_motion(source.drill.motion, scenarios::drill::instrument_names(source.drill));
    const double tick_s = source.drill.world.tick_s;
    source.duration_s = motion.duration();
    source.inputs_at = [motion, tick_s](std::uint64_t tick, std::span<ToolInput> inputs) {
        motion.at(static_cast<double>(tick) * tick_s, inputs);
    };
    return source;
}

Source from_recording(const std::string& file) {
    const auto recorded = std::make_shared<const Recorded>(load_recorded(file));
    const auto& recording = recorded->recording;
    return {recorded->drill,
            [recorded](std::uint64_t tick, std::span<ToolInput> inputs) {
                const auto stored = recorded->recording.tick(std::min(tick, recorded->recording.ticks() - 1));
                std::copy(stored.begin(), stored.end(), inputs.begin());
            },
            static_cast<double>(recording.ticks()) * recording.head.tick_s, recording.fault(file)};
}

}  // namespace

int render_command(const RenderOptions& options) {
    expect_writable("--out", options.out, {options.source});
    expect_ending("--out", options.out, ".png");
    const bool is_drill = std::filesystem::path(options.source).extension() == ".json";
    const Source source = is_drill ? from_drill(options.source) : from_recording(options.source);
    const double at_s = options.at_s.value_or(is_drill ? 0 : source.duration_s);
    if (!(at_s >= 0 && at_s <= source.duration_s))
        throw InputFault("--at " + report::number(at_s, 3) + ": error: expected 0 to " +
                         report::number(source.duration_s, 3) + " s");
    std::vector<ToolInput> inputs(source.drill.world.instruments.size());
    source.inputs_at(0, inputs);
    Session session(source.drill, inputs);
    const auto ticks = static_cast<std::uint64_t>(at_s / source.drill.world.tick_s);
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        source.inputs_at(tick, inputs);
        session.tick(inputs);
    }
    Snapshot snapshot = session.snapshot("");
    if (options.close) {
        auto near = session.close_snapshot();
        if (!near)
            throw InputFault(options.source + ": error: --close: there is no knot and no bite at " +
                             report::number(at_s, 3) + " s");
        snapshot = std::move(*near);
    }
    const auto png = picture_of(session, snapshot);
    write_file(options.out, {reinterpret_cast<const char*>(png.data()), png.size()});
    if (source.damage) throw InputFault(*source.damage);  // drawn is what could be read
    return 0;
}

}  // namespace app
