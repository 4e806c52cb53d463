#include "scenarios/world/measure.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "scenarios/world/world.hpp"

namespace scenarios::world {

namespace {

// The largest of a quantity and when it was reached.
void raise(Moment& largest, double value, double at_s) {
    if (value > largest.value) largest = {value, at_s};
}

}  // namespace

double World::tension_at(int node) const {
    const auto tension = thread_.tension();
    const auto k = static_cast<std::size_t>(node);
    return std::max(k > 0 ? tension[k - 1] : 0.0, k < tension.size() ? tension[k] : 0.0);
}

// Of the first links that the jaws do not hold; nought where there is none, or it is pushed together.
double World::tension_before(const Grasp& grasp) const {
    return grasp.first > 0 ? std::max(0.0, thread_.tension()[static_cast<std::size_t>(grasp.first) - 1]) : 0;
}

double World::tension_after(const Grasp& grasp) const {
    const auto link = static_cast<std::size_t>(grasp.first + grasp.count) - 1;
    return link < thread_.tension().size() ? std::max(0.0, thread_.tension()[link]) : 0;
}

// No thread pulls harder than the jaws that hold it: beyond their grip it slides. One that only a needle leads pulls as
// hard as it likes, one that nobody holds not at all. The estimate from lag alone knows no such limit.
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
    moved_since_named_ |= report.substeps > 0;

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
        if (pulls && !tool.stopped)  // by steel or a wall: what it lacks then is no pull on the thread
            raise(measures_.lag_max_mm[i], 1e3 * tool.lag(), t);
        measures_.path_mm[i] += 1e3 * (tool.now.pose.position - tool.before.pose.position).norm();
    }
    name_beside();
}

std::vector<std::vector<Vec3>> World::curves() const {
    std::vector<std::vector<Vec3>> curves;
    for (const auto& piece : thread_.pieces()) curves.push_back(curve_of(piece));
    return curves;
}

// By crossings first, for a hitch is no knot; of pieces tied alike the first.
static bool ties_more(const sim::knot::Tied& a, const sim::knot::Tied& b) {
    const auto much = [](const sim::knot::Tied& tied) {
        int crossings = 0;
        for (const auto& factor : tied.name.factors) crossings += factor.crossings;
        return std::tuple(crossings, tied.name.throw_list.size(), tied.round >= 0);
    };
    return much(a) > much(b);
}

// A piece that lies where it lay has the name it had.
static std::vector<NamedPiece> name_all(std::vector<std::vector<Vec3>> curves,
                                        const std::vector<std::vector<Vec3>>& cores,
                                        const std::vector<NamedPiece>& known) {
    std::vector<NamedPiece> pieces;
    for (auto& curve : curves) {
        const auto same =
            std::find_if(known.begin(), known.end(), [&](const NamedPiece& piece) { return piece.curve == curve; });
        sim::knot::Tied tied = same != known.end() ? same->tied : sim::knot::name_among(curve, cores);
        pieces.push_back({std::move(curve), std::move(tied)});
    }
    return pieces;
}

// Ten names a second, faster than anyone reads them, each of a copy on another thread: no tick waits for the 2 ms that
// a name takes. It is taken at a tick known beforehand, so that a session is the same however busy the machine is.
void World::name_beside() {
    constexpr std::uint64_t period = 100, delay = 20;  // [ticks]
    if (naming_.valid() && ticks_ % period == delay) take_names(naming_.get());
    if (ticks_ % period != 0 || !moved_since_named_) return;
    moved_since_named_ = false;
    naming_ = std::async(std::launch::async, [curves = curves(), cores = cores_, known = named_]() mutable {
        return name_all(std::move(curves), cores, known);
    });
}

void World::name_knot_now() {
    if (naming_.valid()) naming_.get();  // out of date
    moved_since_named_ = false;
    take_names(name_all(curves(), cores_, named_));
}

void World::take_names(std::vector<NamedPiece> pieces) {
    named_ = std::move(pieces);
    std::size_t most = 0;
    for (std::size_t i = 1; i < named_.size(); ++i)
        if (ties_more(named_[i].tied, named_[most].tied)) most = i;
    const auto& [name, round] = named_[most].tied;
    if (name.knot != measures_.knot.knot || name.surgical != measures_.knot.surgical) {
        log(EventKind::knot, name.called(), 0);
        measures_.knot_since_s = time_s();
    }
    measures_.knot = name;
    measures_.hitched_to = round;
    measures_.piece = static_cast<int>(most);
}

}  // namespace scenarios::world
