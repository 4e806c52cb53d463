#include "app/window/player.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/commands/tool_starts.hpp"
#include "app/fault.hpp"
#include "app/machine.hpp"
#include "app/play/recorded.hpp"

namespace app::window {

using instruments::ToolInput;
using scenarios::drill::Drill;

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

namespace {

scenarios::drill::Motion motion_of(const Drill& drill, const std::filesystem::path& file) {
    if (drill.motion.empty())
        throw InputFault(file.string() +
                         ": error: /motion: the drill names no motion, so where its tools start is not known");
    return scenarios::drill::load_motion(drill.motion, scenarios::drill::instrument_names(drill));
}

// Hands do not wait for the disk.
scenarios::recording::Recorder recorder_of(const Drill& drill, const std::filesystem::path& file,
                                           const PlayerOptions& options) {
    // No assist helps in an exam, whatever is switched on for practice.
    std::string assists = options.is_exam ? "" : options.hands.assists.names();
    std::replace(assists.begin(), assists.end(), ',', ' ');
    const scenarios::recording::Circumstances session{.who = options.who,
                                                      .device = "mouse and keys",
                                                      .assists = assists,
                                                      .exam = options.is_exam,
                                                      .pace = drill.pace};
    return {options.recording, head_of(drill, file.string(), session), {scenarios::recording::wall_clock, false}};
}

void sleep_for(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

Player::Player(const std::filesystem::path& file, PlayerOptions options)
    : file_(file),
      options_(std::move(options)),
      drill_(scenarios::drill::load_drill(file)),
      motion_(motion_of(drill_, file)),
      guide_(drill_) {
    std::vector<ToolInput> start(drill_.world.instruments.size());
    motion_.at(0, start);
    check_tool_starts(drill_, scenarios::session::vessel_meshes(drill_.world), start, drill_.motion.string());
    hands_ = std::make_unique<hands::Hands>(
        options_.hands, drill_.world.instruments, start,
        [this](const std::string& kind, const std::string& text) { live_->mark(kind, text); });
    live_ = std::make_unique<scenarios::session::Live>(
        drill_, start, [this](const auto& world, auto tools) { return lead(world, tools); },
        scenarios::session::Time{now_s, sleep_for, processor_us},
        scenarios::session::LiveOptions{options_.is_exam, true}, recorder_of(drill_, file, options_));
    if (options_.pace) live_->set_pace(*options_.pace);
}

Player::~Player() = default;

// On the tick thread.
std::optional<double> Player::lead(const scenarios::world::World& world, std::span<ToolInput> tools) {
    devices_.take(taken_);
    hands_->tick(world, taken_, tools);
    watch_guide(world);
    return hands_->stamp_s();
}

void Player::watch_guide(const scenarios::world::World& world) {
    if (world.ticks() == 0) return;
    const std::size_t before = guide_.step();
    guide_.after_tick(world);
    if (guide_.step() == before) return;
    const std::scoped_lock lock(mutex_);
    guide_view_ = {guide_.step(), {guide_.marks().begin(), guide_.marks().end()}};
}

GuideView Player::guide() const {
    const std::scoped_lock lock(mutex_);
    return guide_view_;
}

scenarios::drill::Result Player::finish() {
    is_finished_ = true;
    auto result = live_->finish();
    result.machine = machine_name();
    return result;
}

}  // namespace app::window
