#include "scenarios/world/measure.hpp"

#include <algorithm>
#include <limits>

#include "scenarios/world/world.hpp"

namespace scenarios::world {

namespace {

// Keeps the largest value and when it was reached.
void raise(Moment& largest, double value, double at_s) {
    if (value > largest.value) largest = {value, at_s};
}

}  // namespace

double World::tension_at(int node) const {
    const auto tension = thread_.tension();
    const auto k = static_cast<std::size_t>(node);
    return std::max(k > 0 ? tension[k - 1] : 0.0, k < tension.size() ? tension[k] : 0.0);
}

// Tension of the first link that the jaws do not hold, on either side; 0 where there is none, or it is pushed together
// [N].
double World::tension_before(const Grasp& grasp) const {
    return grasp.first > 0 ? std::max(0.0, thread_.tension()[static_cast<std::size_t>(grasp.first) - 1]) : 0;
}

double World::tension_after(const Grasp& grasp) const {
    const auto link = static_cast<std::size_t>(grasp.first + grasp.count()) - 1;
    return link < thread_.tension().size() ? std::max(0.0, thread_.tension()[link]) : 0;
}

// The most that any thread can pull with [N]. It is the weakest grip, beyond which thread slides; without limit where
// only a needle leads it, and 0 where nobody holds it. The estimate from lag alone knows no such limit.
double World::most_pull() const {
    const auto is_led = [](const Needle& needle) { return needle.holder.tool >= 0; };
    double most = std::any_of(needles_.begin(), needles_.end(), is_led) ? std::numeric_limits<double>::infinity() : 0;
    for (const Tool& tool : tools_)
        if (!tool.grasps.empty()) most = most == 0 ? tool.shape.grip_force : std::min(most, tool.shape.grip_force);
    return most;
}

void World::measure(const sim::thread::TickReport& report) {
    const double t = time_s();
    substeps_ += static_cast<std::uint64_t>(report.substeps);
    stretch_now_ = report.stretch_max;
    worst_.stretch = std::max(worst_.stretch, report.stretch_max);
    worst_.separation = std::min(worst_.separation, report.separation_min);
    worst_.step_over_bound = std::max(worst_.step_over_bound, report.step_over_bound);
    worst_.contacts = std::max(worst_.contacts, report.contacts);
    if (report.substeps > 0) knot_watch_.note_motion();

    if (report.pass_throughs > 0) {
        if (measures_.pass_throughs == 0) measures_.first_pass_through_s = t;
        measures_.pass_throughs += static_cast<std::uint64_t>(report.pass_throughs);
        log(EventKind::pass_through, "thread", report.pass_throughs);
    }
    measures_.duration_s = t;
    const auto tension = thread_.tension();
    tension_now_ = *std::max_element(tension.begin(), tension.end());
    if (!is_elastic()) tension_now_ = std::min(tension_now_, most_pull());
    raise(measures_.tension_max_N, tension_now_, t);
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        const Tool& tool = tools_[i];
        const auto leads = [&](const Needle& needle) { return needle.holder.tool == static_cast<int>(i); };
        const bool pulls = !tool.grasps.empty() || std::any_of(needles_.begin(), needles_.end(), leads);
        // What a tool lacks that steel or a wall stops is no pull on the thread.
        if (pulls && !tool.stopped) raise(measures_.lag_max_mm[i], 1e3 * tool.lag(), t);
        measures_.path_mm[i] += 1e3 * (tool.now.pose.position - tool.before.pose.position).norm();
    }
    watch_knot();
}

std::vector<std::vector<Vec3>> World::curves() const {
    std::vector<std::vector<Vec3>> curves;
    for (const auto& piece : thread_.pieces()) curves.push_back(curve_of(piece));
    return curves;
}

std::vector<Vec3> World::curve_of(const sim::thread::Piece& piece) const {
    return {thread_.nodes().begin() + piece.first, thread_.nodes().begin() + piece.last + 1};
}

std::span<const double> World::rest_of(const sim::thread::Piece& piece) const {
    return thread_.rest_lengths().subspan(static_cast<std::size_t>(piece.first),
                                          static_cast<std::size_t>(piece.last - piece.first));
}

// The knot's name may be of a moment ago, when there were fewer pieces.
sim::thread::Piece World::tied_piece() const {
    const auto pieces = thread_.pieces();
    return pieces[std::min(static_cast<std::size_t>(measures_.piece), pieces.size() - 1)];
}

void World::watch_knot() {
    if (knot_watch_.fetch(ticks_)) note_knot();
    if (knot_watch_.is_due(ticks_)) knot_watch_.start(curves());
}

void World::name_knot_now() {
    knot_watch_.name_now(curves());
    note_knot();
}

void World::note_knot() {
    const std::size_t most = knot_watch_.most_tied();
    const auto& [name, round] = knot_watch_.named()[most].tied;
    if (name.knot != measures_.knot.knot || name.surgical != measures_.knot.surgical) {
        log(EventKind::knot, name.called(), 0);
        measures_.knot_since_s = time_s();
    }
    measures_.knot = name;
    measures_.hitched_to = round;
    measures_.piece = static_cast<int>(most);
}

}  // namespace scenarios::world
