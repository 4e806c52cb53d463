#include "tests/bench/lab/thread_in_tube.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/resample.hpp"
#include "tests/bench/lab/core.hpp"

namespace bench::lab {

namespace {

using scenarios::world::VesselDef;

constexpr double tick = 1e-3, wire = 0.1e-3;
constexpr double pitch = 2 * mm;  // between passes
constexpr double young = 2.8e9, radius = 0.0425e-3, section = 3.14159265358979 * radius * radius;

double place_of(int pass, int passes) {
    return pitch * (pass - 0.5 * (passes - 1));
}

// Where passes begin and end, outside of the tube or, of the only wall of a single bite, in its lumen; down, up, down
// ...
std::vector<std::array<Vec3, 2>> ways(int bites) {
    if (bites == 1) return {{Vec3(0, 0, 2.5 * mm), Vec3(0, 0, 1 * mm)}};
    std::vector<std::array<Vec3, 2>> all;
    for (int pass = 0; pass < bites / 2; ++pass) {
        const double x = place_of(pass, bites / 2), z = pass % 2 == 0 ? 2.3 * mm : -2.3 * mm;
        all.push_back({Vec3(x, 0, z), Vec3(x, 0, -z)});
    }
    return all;
}

VesselDef tube(int bites) {
    VesselDef def;
    def.wall = 0.5 * mm;
    def.length = 12 * mm;
    def.is_soft = true;
    def.young_modulus = 2e6;
    def.bitten = ways(bites);
    return def;
}

Vec3 tail_way() {
    return Vec3(-1, 0, 1).normalized();
}

Vec3 lead_way(int bites) {
    if (bites == 1) return Vec3(1, 0, -0.2).normalized();
    return Vec3(1, 0, bites / 2 % 2 == 0 ? 1 : -1).normalized();
}

sim::thread::Thread lay(const ThreadInTube::Def& def) {
    std::vector<Vec3> path;
    const auto all = ways(def.bites);
    path.push_back(all.front()[0] + def.tail * tail_way());
    for (const auto& [from, to] : all) path.push_back(from), path.push_back(to);
    path.push_back(all.back()[1] + def.lead * lead_way(def.bites));
    double length = 0;
    for (std::size_t k = 1; k < path.size(); ++k) length += (path[k] - path[k - 1]).norm();
    constexpr double link = 0.3 * mm;
    sim::thread::ThreadDef thread{
        .radius = radius, .friction = def.friction, .axial_stiffness = young * section, .shortest_link = 2 * radius};
    if (def.is_elastic)
        thread.elastic = sim::thread::RodDef{
            .radius = radius, .young = young, .bending_share = def.bending_share, .axial_over_bending = 0};
    return {thread, sim::geometry::resample(path, static_cast<int>(std::lround(length / link)))};
}

}  // namespace

ThreadInTube::ThreadInTube(const Def& def)
    : def_(def),
      to_tail_(tail_way()),
      to_lead_(lead_way(def.bites)),
      vessel_(tube(def.bites), wire),
      targets_(scenarios::world::with_skins({}, {&vessel_, 1})),
      wall_(targets_, radius),
      thread_(lay(def)),
      at_first_(std::accumulate(thread_.rest_lengths().begin(), thread_.rest_lengths().end(), 0.0)),
      rooms_(targets_.size()) {
    for (const tissue::Bite& bite : vessel_.bites.bites())
        holes_.push_back(bite.entry.hole), holes_.push_back(bite.exit.hole);
}

double ThreadInTube::draw(bool by_lead, double way, double load) {
    int held[] = {by_lead ? static_cast<int>(thread_.nodes().size()) - 1 : 0};
    thread_.fit_links(held);
    const Vec3 onwards = by_lead ? to_lead_ : to_tail_, at = thread_.nodes()[static_cast<std::size_t>(held[0])];
    loads_.assign(thread_.nodes().size(), Vec3::Zero());
    (by_lead ? loads_.front() : loads_.back()) = load * (by_lead ? to_tail_ : to_lead_);
    const double lag = def_.is_elastic ? 0 : 10 * radius;  // what it estimates tension by
    const sim::thread::Hold hold{.node = held[0], .target = at + way * onwards, .wanted = at + (way + lag) * onwards};
    const int owners[] = {-1};
    const auto report =
        thread_.tick({.holds = {&hold, 1},
                      .hold_owners = owners,
                      .capsules = {},
                      .surface = &wall_.tree(),
                      .seconds = tick,
                      .loads = def_.is_elastic ? std::span<const Vec3>(loads_) : std::span<const Vec3>(),
                      .surface_moved = moved_,
                      .soft_from = 0,
                      .soft_compliance = scenarios::world::wall_compliance});
    passes_ += report.pass_throughs;
    const double gone = onwards.dot(thread_.nodes()[static_cast<std::size_t>(held[0])] - at);
    constexpr int turns = 2;  // ticks a step of the tissue
    for (const auto& pressed : thread_.surface_forces()) vessel_.press(pressed, wall_.tree()[pressed.triangle], 1);
    vessel_.load(1.0 / turns, def_.is_elastic);
    if (++ticks_ % turns == 0) {
        vessel_.tissue.step({.holds = vessel_.clamps, .forces = vessel_.forces}, turns * tick);
        vessel_.forces.clear();
        vessel_.skin.update(vessel_.tissue.nodes());
        for (int t = 0; t < vessel_.skin.size(); ++t) targets_[static_cast<std::size_t>(t)] = vessel_.skin[t];
    }
    thread_.surface_room(rooms_, gaps_);
    moved_ = wall_.follow(targets_, rooms_, gaps_);
    return gone;
}

std::vector<ThreadInTube::AtHole> ThreadInTube::at_holes() const {
    std::vector<AtHole> found;
    const auto nodes = thread_.nodes();
    for (const int hole : holes_) {
        const Vec3 centre = vessel_.skin.centre(hole);
        AtHole nearest{0, 1e300};
        double along = 0;
        for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
            const auto pair = sim::geometry::closest_points(nodes[k], nodes[k + 1], centre, centre);
            const double length = (nodes[k + 1] - nodes[k]).norm(),
                         off = std::sqrt(std::max(0.0, pair.distance_squared));
            if (off < nearest.off) nearest = {along + pair.s * length, off};
            along += length;
        }
        found.push_back(nearest);
    }
    return found;
}

Vec3 ThreadInTube::direction_at(double along) const {
    const auto nodes = thread_.nodes();
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        const Vec3 link = nodes[k + 1] - nodes[k];
        if (along <= link.norm() || k + 2 == nodes.size()) return link.normalized();
        along -= link.norm();
    }
    return Vec3::Zero();
}

double ThreadInTube::tension_at(double along) const {
    const auto nodes = thread_.nodes();
    std::size_t k = 0;
    for (; k + 2 < nodes.size() && along > (nodes[k + 1] - nodes[k]).norm(); ++k)
        along -= (nodes[k + 1] - nodes[k]).norm();
    return thread_.tension()[k];
}

constexpr double clear =
    1.5e-3;  // [m] from a hole, three times as far as a pull of 50 mN lets the thread's stiffness reach

double ThreadInTube::turned() const {
    const auto at = at_holes();
    double sum = 0;
    Vec3 before = direction_at(at.front().along - clear);
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Vec3 after =
            direction_at(i + 1 < at.size() ? 0.5 * (at[i].along + at[i + 1].along) : at[i].along + clear);
        sum += std::atan2(before.cross(after).norm(), before.dot(after));
        before = after;
    }
    return sum;
}

double ThreadInTube::tension_of_tail() const {
    return tension_at(at_holes().front().along - clear);
}
double ThreadInTube::tension_of_lead() const {
    return tension_at(at_holes().back().along + clear);
}

double ThreadInTube::length_off(bool by_lead, double load) const {
    const auto rest = thread_.rest_lengths();
    const auto nodes = thread_.nodes();
    const double at_rest = std::accumulate(rest.begin(), rest.end(), 0.0), kept = std::abs(at_rest / at_first_ - 1);
    const auto holes = at_holes();
    double along = 0, now = 0, before = 0;  // of what follows
    for (std::size_t k = 0; k < rest.size(); ++k) {
        const double link = (nodes[k + 1] - nodes[k]).norm();
        along += link;
        const bool follows = by_lead ? along < holes.front().along - clear : along - link > holes.back().along + clear;
        if (follows) now += link, before += rest[k];
    }
    if (!def_.is_elastic) return std::max(kept, std::abs(along / at_first_ - 1));
    return std::max(kept, std::abs(now / before - 1 - load / (young * section)));
}

}  // namespace bench::lab
