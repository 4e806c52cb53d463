#include "scenarios/session/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "scenarios/drill/score.hpp"
#include "scenarios/session/view.hpp"
#include "scenarios/world/judge.hpp"
#include "scenarios/world/locate.hpp"
#include "sim/geometry/portable_math.hpp"

namespace scenarios::session {

using scenarios::drill::Result;
using scenarios::world::EventKind;
using sim::geometry::Vec3;

Session::Session(scenarios::drill::Drill drill, std::span<const instruments::ToolInput> start, Stopwatch stopwatch)
    : drill_(std::move(drill)),
      stopwatch_(std::move(stopwatch)),
      rigid_(vessel_meshes(drill_.world)),
      world_(make_world(drill_.world, rigid_, start)),
      last_inputs_(start.begin(), start.end()) {}

void Session::tick(std::span<const instruments::ToolInput> inputs) {
    const double begin = stopwatch_ ? stopwatch_() : 0;
    world_.tick(inputs);
    if (stopwatch_) tick_us_.push_back(stopwatch_() - begin);
    constexpr std::uint64_t sample_period = 10;
    if (world_.ticks() % sample_period == 0) sample();
    watch_events();
}

static CloseUp about(std::span<const Vec3> points) {
    CloseUp place{
        std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) / static_cast<double>(points.size()), 0};
    for (const Vec3& point : points) place.radius = std::max(place.radius, (point - place.centre).norm());
    return place;
}

// From the jaw that leads it to a vessel's end, and round that.
static std::vector<Vec3> clamp_about(const scenarios::world::SoftVessel& vessel, const scenarios::world::Tool& tool) {
    std::vector<Vec3> held;
    for (const tissue::Hold& hold : vessel.clamps) held.push_back(hold.target);
    const CloseUp end = about(held);
    const auto jaw =
        instruments::parts_at(tool.shape, tool.now.pose,
                              tool.now.jaw)[vessel.side > 0 ? instruments::jaw_plus : instruments::jaw_minus]
            .b;
    const Vec3 along = tool.now.pose.rotation * Vec3::UnitX(), to_jaw = jaw - end.centre;
    const Vec3 nearest = (to_jaw - along.dot(to_jaw) * along).normalized(), across = along.cross(nearest);
    std::vector<Vec3> wire{jaw};
    constexpr int pieces = 36;
    for (int k = 0; k <= pieces; ++k) {
        const auto [sin, cos] = sim::geometry::portable_sin_cos(2 * std::numbers::pi * k / pieces);
        wire.push_back(end.centre + end.radius * (cos * nearest + sin * across));
    }
    return wire;
}

Snapshot Session::snapshot(std::string caption) const {
    Snapshot snapshot{world_.time_s(), std::move(caption), world_.curves(), {}, rigid_, {}, {}, {}};
    for (const auto& tool : world_.tools()) {
        const bool cuts =
            tool.def.kind == instruments::Kind::scissors && tool.closed;  // what is between its blades then is no more
        snapshot.tools.push_back({tool.now.pose, cuts ? tool.asked.jaw : tool.now.jaw});
    }
    for (const auto& vessel : world_.vessels()) {
        assets::Mesh& mesh = snapshot.vessels.emplace_back();
        mesh.vertices.assign(vessel.tissue.nodes().begin(), vessel.tissue.nodes().end());
        for (const tissue::Face& face : vessel.tissue.rest().faces) mesh.triangles.push_back(face.nodes);
        if (vessel.held_by >= 0)
            snapshot.clamps.push_back(clamp_about(vessel, world_.tools()[static_cast<std::size_t>(vessel.held_by)]));
    }
    constexpr int pieces = 48;
    for (const auto& needle : world_.needles()) {
        auto& wire = snapshot.needles.emplace_back();
        for (int k = 0; k <= pieces; ++k) wire.push_back(needle.now.at(needle.now.length() * k / pieces));
    }
    return snapshot;
}

// Both strands leave a knot at the ends of the piece of thread that it takes up.
std::optional<Snapshot> Session::knot_snapshot(std::string caption) {
    world_.name_knot_now();
    const auto tails_mm = locate_knot(world_).tail_mm;
    const auto rest = world_.thread_state().rest_lengths();
    if (tails_mm.size() < 2 || tails_mm[0] + tails_mm[1] == 0) return {};
    const auto nodes = world_.thread();
    const auto piece = world_.tied_piece();
    auto first = static_cast<std::size_t>(piece.first), last = static_cast<std::size_t>(piece.last);
    for (double left = 1e-3 * tails_mm[0]; first < last && left > rest[first] / 2; ++first) left -= rest[first];
    for (double left = 1e-3 * tails_mm[1]; last > first && left > rest[last - 1] / 2; --last) left -= rest[last - 1];
    // A tight knot is four diameters across; its neighbourhood shows how it lies. Of a loose one show every loop.
    const double tight = 20 * drill_.world.thread.diameter;
    CloseUp place{(nodes[first] + nodes[last]) / 2, tight};
    if ((nodes[first] - nodes[last]).norm() > tight) {
        place = about({&nodes[first], &nodes[last] + 1});
        place.radius = std::max(place.radius, tight);
    }
    Snapshot near = snapshot(std::move(caption));
    near.close_up = place;
    return near;
}

std::optional<Snapshot> Session::bites_snapshot(std::string caption) const {
    std::vector<Vec3> holes;
    for (const auto& vessel : world_.vessels())
        for (int hole = 0; hole < vessel.skin.holes(); ++hole) holes.push_back(vessel.skin.centre(hole));
    if (holes.empty()) return {};
    Snapshot near = snapshot(std::move(caption));
    near.close_up = about(holes);
    near.close_up->radius += 20 * drill_.world.thread.diameter;  // as about a tight knot
    return near;
}

// About the hole that the needle made last in that vessel.
Snapshot Session::bite_snapshot(const std::string& vessel_name, std::string caption) const {
    Snapshot near = snapshot(std::move(caption));
    for (const auto& vessel : world_.vessels())
        if (vessel.name == vessel_name && vessel.skin.holes() > 0)
            near.close_up = CloseUp{vessel.skin.centre(vessel.skin.holes() - 1), drill_.world.needle.radius};
    return near;
}

std::optional<Snapshot> Session::close_snapshot() {
    if (auto knot = knot_snapshot("the knot at the end")) return knot;
    return bites_snapshot("the bites at the end");
}

void Session::sample() {
    scenarios::drill::Sample sample{world_.time_s(), world_.tension_now(), {}, {}, {}, world_.measures().knot.called()};
    const double since_last = samples_.empty() ? sample.t_s : sample.t_s - samples_.back().t_s;
    for (std::size_t i = 0; i < world_.tools().size(); ++i) {
        const auto& tool = world_.tools()[i];
        const auto& asked = tool.asked.pose.position;
        sample.tool_speed_mm_s.push_back(1e3 * (asked - last_inputs_[i].pose.position).norm() / since_last);
        sample.tool_lag_mm.push_back(1e3 * tool.lag());
        sample.held.push_back(held_by(world_, i));
        last_inputs_[i] = tool.asked;
    }
    samples_.push_back(std::move(sample));
}

// A picture whenever something was grasped or let go, the needle went through a wall or the knot took another name that
// surgeons use; the report shows the moment.
void Session::watch_events() {
    constexpr std::size_t most_pictures = 24;
    for (; events_seen_ < world_.events().size(); ++events_seen_) {
        const auto event = world_.events()[events_seen_];
        if (key_moments_.size() >= most_pictures) continue;
        if (event.kind == EventKind::grasp) key_moments_.push_back(snapshot(event.what + " tool grasps the thread"));
        if (event.kind == EventKind::cut) key_moments_.push_back(snapshot(event.what + " tool cuts the thread"));
        if (event.kind == EventKind::broken) key_moments_.push_back(snapshot("the " + event.what + " breaks"));
        if (event.kind == EventKind::through)
            key_moments_.push_back(bite_snapshot(event.what, "the needle is through the wall of " + event.what));
        if (event.kind == EventKind::slipped)
            key_moments_.push_back(snapshot("the needle slips off the edge of " + event.what));
        if (event.kind == EventKind::torn)
            key_moments_.push_back(bite_snapshot(event.what, "a bite tears out of " + event.what));
        if (event.kind == EventKind::release) key_moments_.push_back(snapshot(event.what + " tool lets go"));
        const bool surgeons_know = event.what == "0_1" || !world_.measures().knot.surgical.empty();
        if (event.kind == EventKind::knot && surgeons_know) {
            const std::string caption = "the thread holds: " + (event.what == "0_1" ? "no knot" : event.what);
            key_moments_.push_back(knot_snapshot(caption).value_or(snapshot(caption)));
        }
        if (event.kind == EventKind::pass_through)
            key_moments_.push_back(snapshot("the thread passed through something"));
    }
}

static scenarios::drill::Percentiles percentiles(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values[values.size() * 99 / 100], values.back()};
}

Result Session::finish() {
    key_moments_.push_back(snapshot("the end"));
    // Looking for the knot names it, as it is scored below.
    if (auto near = close_snapshot()) key_moments_.push_back(std::move(*near));
    const auto measures = judge(world_);
    const auto& worst = world_.worst();

    Result result;
    result.drill_title = drill_.title;
    for (const auto& instrument : drill_.world.instruments) result.instruments.push_back(instrument.name);
    result.items = scenarios::drill::score(drill_, measures);
    result.passed = std::all_of(result.items.begin(), result.items.end(), [](const auto& item) { return item.passed; });
    result.samples = samples_;
    result.events.assign(world_.events().begin(), world_.events().end());
    result.duration_s = world_.time_s();
    result.links = static_cast<int>(world_.thread().size()) - 1;
    result.ticks = world_.ticks();
    result.substeps = world_.substeps();
    result.stretch_max = worst.stretch;
    result.stretch_settled = world_.stretch_now();
    result.separation_min = worst.separation;
    result.node_step_max_over_bound = worst.step_over_bound;
    result.pass_throughs = measures.pass_throughs;
    result.contacts_max = worst.contacts;
    result.knot = measures.knot.knot;
    result.surgical = measures.knot.surgical;
    result.throws = measures.knot.throws;
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(world_.hash()));
    result.state_hash = hash;
    result.tick_us = percentiles(tick_us_);
    return result;
}

}  // namespace scenarios::session
