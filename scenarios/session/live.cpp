#include "scenarios/session/live.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace scenarios::session {

using scenarios::drill::Result;

constexpr double least_pace = 0.125, view_period_s = 1.0 / 120;

Live::Live(scenarios::drill::Drill drill, std::span<const instruments::ToolInput> start, Hand hand, Time time,
           LiveOptions options, std::optional<recording::Recorder> recorder)
    : session_(std::move(drill), start, time.stopwatch),
      hand_(std::move(hand)),
      time_(std::move(time)),
      options_(options),
      recorder_(std::move(recorder)),
      last_tick_(static_cast<std::uint64_t>(std::ceil(session_.drill().time_limit_s / session_.drill().world.tick_s))),
      pacer_(session_.drill().world.tick_s),
      meter_(session_.drill().world.tick_s),
      inputs_(start.begin(), start.end()),
      is_paused_(options.starts_paused),
      pace_(declared_pace()) {
    publish(0);
    thread_ = std::thread([this] { run(); });
}

Live::~Live() {
    end_ticks();
}

double Live::declared_pace() const {
    return session_.drill().pace;
}

void Live::pause() {
    if (!options_.exam && !is_paused_) set_paused(true), mark("pause", "");
}

void Live::resume() {
    if (is_paused_) mark("resume", ""), set_paused(false);
}

void Live::set_paused(bool paused) {
    {
        const std::lock_guard lock(mutex_);
        is_paused_ = paused;
    }
    changed_.notify_all();
}

void Live::set_pace(double pace) {
    if (options_.exam) return;
    pace_ = std::clamp(pace, std::min(least_pace, declared_pace()), declared_pace());
    char text[32];
    std::snprintf(text, sizeof text, "%g", pace_.load());
    mark("pace", text);
}

void Live::mark(const std::string& kind, const std::string& text) {
    if (recorder_) recorder_->add_mark({ticks_, kind, text});
}

void Live::note_shown(double delay_s) {
    const std::lock_guard lock(mutex_);
    shown_s_.push_back(delay_s);
}

std::optional<std::string> Live::trouble() const {
    return recorder_ ? recorder_->trouble() : std::nullopt;
}

// A view may hold events that the one before it held as well: that was taken while this one was made.
const View& Live::view() {
    const bool is_new = views_.take();
    View& view = views_.front();
    if (!is_new) view.events.clear();
    if (!is_new) return view;
    const std::size_t first = view.first_event, seen = events_seen_;
    view.events.erase(view.events.begin(), view.events.begin() + static_cast<std::ptrdiff_t>(seen - first));
    view.first_event = seen;
    events_seen_ = seen + view.events.size();
    return view;
}

void Live::publish(double now_s) {
    View& view = views_.back();
    look_at(session_, events_seen_, view);
    view.pace = meter_.rate(now_s);
    view.dropped_s = pacer_.dropped_s();
    view.device_s = device_s_;
    view.used_s = used_s_;
    views_.publish();
    published_s_ = now_s;
}

void Live::run() {
    try {
        start_clocks();
        while (goes_on()) {
            pacer_.set_pace(pace_);
            const double wait_s = pacer_.wait_s(time_.now());
            if (wait_s > 0)
                time_.sleep(wait_s);
            else
                tick();
        }
        const double now_s = time_.now();
        add_row(meter_.last_row(now_s, pacer_.dropped_s()));
        publish(now_s);
    } catch (...) {
        fault_ = std::current_exception();
    }
    has_ended_ = true;
}

bool Live::goes_on() {
    if (is_paused_ && !stops_) wait_for_resume();
    return !stops_ && session_.world().ticks() < last_tick_;
}

void Live::start_clocks() {
    const double now_s = time_.now();
    pacer_.start(now_s);
    meter_.start(now_s);
}

void Live::wait_for_resume() {
    const double now_s = time_.now();
    meter_.halt(now_s);
    publish(now_s);
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return stops_ || !is_paused_; });
    }
    start_clocks();
}

// The hand is asked now, whatever is owed: what it says is never older than a tick.
void Live::tick() {
    const std::optional<double> device_s = hand_(session_.world(), inputs_);
    const double begin_s = time_.now();
    if (recorder_) recorder_->add_tick(inputs_);
    session_.tick(inputs_);
    pacer_.add_tick();
    ticks_ = session_.world().ticks();
    record_what_happened();
    measure(begin_s, device_s);
}

void Live::measure(double begin_s, std::optional<double> device_s) {
    if (device_s && device_s != device_s_) {
        meter_.add_used(begin_s - *device_s);
        used_s_ = begin_s;
    }
    device_s_ = device_s;
    const double now_s = time_.now();
    {
        const std::lock_guard lock(mutex_);
        for (const double delay_s : shown_s_) meter_.add_shown(delay_s);
        shown_s_.clear();
    }
    add_row(meter_.add_tick(now_s, pacer_.dropped_s()));
    if (now_s - published_s_ >= view_period_s) publish(now_s);
}

void Live::record_what_happened() {
    if (!recorder_) return;
    const scenarios::world::World& world = session_.world();
    if (world.ticks() % recording::hash_period == 0) recorder_->add_hash(world.ticks(), world.hash());
    for (const auto all = world.events(); events_recorded_ < all.size(); ++events_recorded_)
        recorder_->add_event(all[events_recorded_]);
}

void Live::add_row(const std::optional<recording::PaceRow>& row) {
    if (!row) return;
    rows_.push_back(*row);
    if (recorder_) recorder_->add_pace(*row);
}

void Live::end_ticks() {
    {
        const std::lock_guard lock(mutex_);
        stops_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

Result Live::finish() {
    end_ticks();
    if (fault_) std::rethrow_exception(fault_);
    const std::uint64_t hash = session_.world().hash();
    Result result = session_.finish();
    result.is_comparable = is_comparable();
    if (recorder_) save(hash, result);
    return result;
}

// What could not be written is told by trouble().
void Live::save(std::uint64_t hash, const Result& result) try {
    if (result.ticks % recording::hash_period != 0) recorder_->add_hash(result.ticks, hash);
    recorder_->set_scores(result.items);
    recorder_->finish();
} catch (const std::runtime_error&) {
}

}  // namespace scenarios::session
