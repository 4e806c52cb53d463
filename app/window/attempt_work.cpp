#include "app/window/attempt_work.hpp"

#include <algorithm>
#include <cmath>

#include "app/draw/canvas.hpp"
#include "app/play/picture.hpp"
#include "app/play/recorded.hpp"
#include "scenarios/drill/history_key.hpp"
#include "scenarios/session/history.hpp"
#include "scenarios/session/session.hpp"

namespace app::window {

using scenarios::drill::Drill;
using scenarios::drill::ScoreItem;
using scenarios::session::Session;

namespace {

// What stood out at that moment, from near; else the whole field then.
Snapshot moment_of(const Session& session, double at_s) {
    constexpr double near_s = 0.15;
    for (const Snapshot& moment : session.key_moments())
        if (moment.close_up && std::abs(moment.t_s - at_s) < near_s) return moment;
    return session.snapshot("");
}

// Whether a knot at its end says more than the whole field.
bool is_of_knot(const ScoreItem& item) {
    return item.name.starts_with("knot") || item.name.starts_with("throws") || item.name.starts_with("tail");
}

draw::Image drawn(const Drill& drill, const Snapshot& moment) {
    static thread_local draw::Canvas canvas;
    constexpr int width = 480, height = 320;
    const draw::Camera camera = camera_of(drill.world, moment, static_cast<double>(width) / height);
    return draw::render(canvas, app::picture_of(drill.world, moment, camera, width, height));
}

}  // namespace

AttemptWork::AttemptWork(const std::filesystem::path& recording, const Drill& drill,
                         const std::vector<ScoreItem>& missed)
    : missed_(missed), thread_([this, recording, drill](const std::stop_token& stop) {
          try {
              read_history(recording.parent_path(), drill);
              draw_moments(recording, stop);
          } catch (const std::exception&) {
              // What cannot be read again has no pictures; its scores stand.
          }
      }) {}

void AttemptWork::read_history(const std::filesystem::path& folder, const Drill& drill) {
    const auto all = scenarios::session::attempts_in(folder);
    const auto attempts = scenarios::session::attempts_at(all, scenarios::drill::history_key(drill));
    if (attempts.empty()) return;
    const std::scoped_lock lock(mutex_);
    for (const ScoreItem& item : attempts.back().items)
        values_[item.name] = scenarios::session::last_values(attempts, item.name);
}

void AttemptWork::draw_moments(const std::filesystem::path& recording, const std::stop_token& stop) {
    if (missed_.empty()) return;
    std::vector<ScoreItem> wanted = missed_;
    std::stable_sort(wanted.begin(), wanted.end(), [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
    const Recorded recorded = load_recorded(recording.string());
    Session session(recorded.drill, recorded.recording.tick(0));
    auto next = wanted.begin();
    for (std::uint64_t tick = 0; tick < recorded.recording.ticks() && !stop.stop_requested(); ++tick) {
        session.tick(recorded.recording.tick(tick));
        for (; next != wanted.end() && next->at_s <= session.world().time_s(); ++next)
            if (!is_of_knot(*next)) keep(next->name, drawn(recorded.drill, moment_of(session, next->at_s)));
    }
    if (stop.stop_requested()) return;
    const Snapshot end = session.close_snapshot().value_or(session.snapshot(""));
    for (const ScoreItem& item : wanted)
        if (is_of_knot(item) || item.at_s > session.world().time_s()) keep(item.name, drawn(recorded.drill, end));
}

void AttemptWork::keep(const std::string& item, draw::Image image) {
    const std::scoped_lock lock(mutex_);
    pictures_.insert_or_assign(item, std::move(image));
}

std::optional<draw::Image> AttemptWork::take_picture(const std::string& item) {
    const std::scoped_lock lock(mutex_);
    auto found = pictures_.extract(item);
    if (!found) return {};
    return std::move(found.mapped());
}

std::vector<double> AttemptWork::values_of(const std::string& item) const {
    const std::scoped_lock lock(mutex_);
    const auto found = values_.find(item);
    return found == values_.end() ? std::vector<double>() : found->second;
}

}  // namespace app::window
