#include "scenarios/session/pacer.hpp"

#include <algorithm>

namespace scenarios::session {

using recording::Delays;
using recording::PaceRow;

double Pacer::wait_s(double now_s) {
    const double lost_s = now_s - due_s_ - most_debt_s;
    if (lost_s > 0) {
        dropped_s_ += lost_s;
        due_s_ += lost_s;
    }
    return std::max(0.0, due_s_ - now_s);
}

void PaceMeter::start(double now_s) {
    begin_s_ = now_s;
}

void PaceMeter::halt(double now_s) {
    before_pauses_s_ = length_s(now_s);
    begin_s_ = now_s;
}

double PaceMeter::length_s(double now_s) const {
    return before_pauses_s_ + now_s - begin_s_;
}

std::optional<PaceRow> PaceMeter::add_tick(double now_s, double dropped_s) {
    ++ticks_;
    if (length_s(now_s) < 1) return {};
    return end_row(now_s, dropped_s);
}

std::optional<PaceRow> PaceMeter::last_row(double now_s, double dropped_s) {
    const double length = length_s(now_s);
    if (ticks_ == first_ || !(length > 0) || (has_rows_ && length < 0.5)) return {};
    return end_row(now_s, dropped_s);
}

static std::optional<Delays> delays_of(std::vector<double>& delays_s) {
    if (delays_s.empty()) return {};
    std::sort(delays_s.begin(), delays_s.end());
    const Delays delays{1e3 * delays_s[delays_s.size() / 2], 1e3 * delays_s[delays_s.size() * 99 / 100]};
    delays_s.clear();
    return delays;
}

PaceRow PaceMeter::end_row(double now_s, double dropped_s) {
    const double length = length_s(now_s);
    wall_s_ += length;
    last_rate_ = static_cast<double>(ticks_ - first_) * tick_s_ / length;
    const PaceRow row{
        ticks_, wall_s_, last_rate_, 1e3 * (dropped_s - dropped_s_), delays_of(used_s_), delays_of(shown_s_)};
    first_ = ticks_;
    dropped_s_ = dropped_s;
    before_pauses_s_ = 0;
    begin_s_ = now_s;
    has_rows_ = true;
    return row;
}

double PaceMeter::rate(double now_s) const {
    if (has_rows_) return last_rate_;
    const double length = length_s(now_s);
    return length > 0 ? static_cast<double>(ticks_) * tick_s_ / length : 0;
}

}  // namespace scenarios::session
