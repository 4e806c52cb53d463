#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "scenarios/world/jaws.hpp"
#include "scenarios/world/world.hpp"
#include "sim/geometry/closest_points.hpp"

namespace scenarios::world {

namespace {

// The closing jaws lay the strand flat between their inner faces; each link keeps its length and, in the plane of the
// jaws, its direction.
void flatten(Grasp& grasp, const JawRoom& room) {
    const int middle = grasp.count() / 2;
    const auto half_gap = [&](const Vec3& at) { return room.half_gap(at.z()); };
    const Vec3& centre = grasp.anchor[static_cast<std::size_t>(middle)];
    const double half = half_gap(centre), shift = std::clamp(centre.x(), -half, half) - centre.x();
    for (int k = 0; k < grasp.count(); ++k) grasp.anchor[static_cast<std::size_t>(k)].x() += shift;
    Vec3 leader_was = Vec3::Zero();
    const auto lay = [&](int from, int to) {
        const Vec3 &leader = grasp.anchor[static_cast<std::size_t>(from)],
                   follower = grasp.anchor[static_cast<std::size_t>(to)];
        Vec3 d = follower - leader_was;
        leader_was = follower;
        const double length2 = d.squaredNorm(), gap = half_gap(follower);
        d.x() = std::clamp(follower.x(), -gap, gap) - leader.x();
        const double flat2 = d.y() * d.y() + d.z() * d.z(), wanted2 = std::max(0.0, length2 - d.x() * d.x());
        if (flat2 > 0) {
            d.y() *= std::sqrt(wanted2 / flat2);
            d.z() *= std::sqrt(wanted2 / flat2);
        } else {
            d.y() = std::sqrt(wanted2);  // it stood across the jaws: they lay it to one side
        }
        grasp.anchor[static_cast<std::size_t>(to)] = leader + d;
    };
    const Vec3 middle_was = leader_was = centre;
    for (int k = middle; k + 1 < grasp.count(); ++k) lay(k, k + 1);
    leader_was = middle_was;
    for (int k = middle; k > 0; --k) lay(k, k - 1);
}

// The least distance between strands in one pair of jaws, `most` at most [m].
double apart(std::span<const Grasp> grasps, double most) {
    double least2 = most * most;
    const auto meet = [&](const Grasp& one, const Grasp& other) {
        for (int i = 0; i + 1 < one.count(); ++i)
            for (int k = 0; k + 1 < other.count(); ++k) {
                const Vec3 *a = &one.anchor[static_cast<std::size_t>(i)],
                           *b = &other.anchor[static_cast<std::size_t>(k)];
                least2 = std::min(least2, sim::geometry::closest_points(a[0], a[1], b[0], b[1]).distance_squared);
            }
    };
    for (std::size_t i = 0; i < grasps.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) meet(grasps[i], grasps[k]);
    return std::sqrt(least2);
}

template <class T>
const T& at(std::span<const T> values, int i) {
    return values[static_cast<std::size_t>(i)];
}

// Whether the thread has such a link: it ends there, or was cut, where it has none.
bool joins(const sim::thread::Thread& thread, int link) {
    return link >= 0 && link < static_cast<int>(thread.rest_lengths().size()) && !thread.is_cut(link);
}

// Into a grasp that holds nothing: the strand that jaws of this width hold by a link which passes through their middle
// plane y = 0, or ends in it: the nodes within the jaws and one beyond on either side. So the first free link starts
// outside the metal: one between the jaws with a free end would be wedged in them. No nodes where the link does not
// pass.
template <class Place, class IsFree, class IsJoined>
void hold_strand(Grasp& grasp, const JawRoom& room, double width, int link, const Place& place, const IsFree& is_free,
                 const IsJoined& is_joined) {
    const auto within = [&](int k) { return is_free(k) && room.holds(place(k), width); };
    int from = link, to = link + 1;
    if (!is_joined(link) || !is_free(from) || !is_free(to)) return;
    const bool ends = (!is_joined(from - 1) && within(from)) || (!is_joined(to) && within(to));
    if (!room.is_passed_by(place(from), place(to)) && !ends) return;
    while (is_joined(from - 1) && is_free(from - 1) && within(from)) --from;
    while (is_joined(to) && is_free(to + 1) && within(to)) ++to;
    grasp.first = from;
    for (int k = from; k <= to; ++k) grasp.anchor.push_back(place(k));
}

}  // namespace

bool World::is_held(int node) const {
    for (const Needle& needle : needles_)
        if (node == needle.node || node == needle.node + 1) return true;
    for (const Tool& tool : tools_)
        for (const Grasp& grasp : tool.grasps)
            if (node >= grasp.first && node < grasp.first + grasp.count()) return true;
    return false;
}

// Closing jaws hold every strand that passes between them. A loop that only lies round open jaws is not held. Two tools
// on one strand hold different nodes. The thread lies where the last tick left it, so it is held by where the tool was
// then, and goes along with it in this tick already.
void World::take_hold(Tool& tool) {
    const JawRoom room(tool.shape, tool.now.jaw);
    const auto place = [&](int k) { return in_tool(tool.before, at(thread_.nodes(), k)); };
    const auto is_free = [&](int k) { return !is_held(k); };
    const auto is_joined = [&](int link) { return joins(thread_, link); };
    for (int i = 0; i < static_cast<int>(thread_.rest_lengths().size()); ++i) {
        Grasp grasp;
        hold_strand(grasp, room, tool.shape.jaw_radius, i, place, is_free, is_joined);
        if (grasp.count() == 0) continue;
        tool.grasps.push_back(grasp);
        log(EventKind::grasp, tool.def.name,
            1e3 *
                std::accumulate(thread_.rest_lengths().begin(), thread_.rest_lengths().begin() + grasp.middle(), 0.0));
        ++measures_.grasps[static_cast<std::size_t>(&tool - tools_.data())];
        i = grasp.first + grasp.count() - 1;
    }
}

void World::update_grasps() {
    for (int number = 0; number < static_cast<int>(tools_.size()); ++number) {
        Tool& tool = tools_[static_cast<std::size_t>(number)];
        if (tool.shape.grip_force == 0) continue;
        if (!tool.closed && tool.now.jaw < shut_below) {
            tool.closed = true;
            const JawRoom shut(tool.shape, tool.now.jaw);
            const bool has_needle = take_needle(number, shut);
            take_hold(tool);  // beside a needle too: thread that is crushed and not held would jam
            if (!has_needle) take_wall(tool, shut);
        } else if (tool.closed && tool.now.jaw > open_above) {
            tool.closed = false;
            for (const Grasp& grasp : tool.grasps) log(EventKind::release, tool.def.name, grasp.middle());
            tool.grasps.clear();
            if (!tool.walls.empty()) log(EventKind::wall_release, tool.def.name, 0);
            tool.walls.clear();
            let_needle_go(number);
        }
        close_onto_strands(number);
    }
}

// Strands that cross between the jaws keep these open by their thickness.
void World::close_onto_strands(int number) {
    Tool& tool = tools_[static_cast<std::size_t>(number)];
    const JawRoom room(tool.shape, tool.now.jaw);
    if (flat_.size() < tool.grasps.size()) flat_.resize(tool.grasps.size());
    const std::span flat = std::span(flat_).first(tool.grasps.size());
    std::copy(tool.grasps.begin(), tool.grasps.end(), flat.begin());
    for (Grasp& grasp : flat) flatten(grasp, room);
    const double thickness = 2 * thread_.def().radius;
    if (apart(flat, thickness) >= apart(tool.grasps, thickness)) {
        std::swap_ranges(flat.begin(), flat.end(), tool.grasps.begin());
    } else {
        tool.now.jaw = tool.before.jaw;
        tool_world_.set_pose(number, tool.now);
    }
}

// How much harder one free end of a grasped strand is pulled than the other [N]; the thread of `ftl` has no forces,
// only the estimate.
double World::pull_on(const Grasp& grasp) const {
    return is_elastic() ? std::abs(tension_after(grasp) - tension_before(grasp)) : tension_at(grasp.middle());
}

// How far a strand of `ftl` slides in this tick: the tool's lag, less the share of it that the grip bears [m].
Vec3 World::slide_by_lag(const Tool& tool, const Grasp& grasp) const {
    const Vec3 anchor = grasp.anchor[static_cast<std::size_t>(grasp.count() / 2)];
    const Vec3 lag = tool.asked.pose.position + tool.asked.pose.rotation * anchor -
                     thread_.nodes()[static_cast<std::size_t>(grasp.middle())];
    return -((1 - tool.shape.grip_force / pull_on(grasp)) * lag);
}

// How far an elastic strand slides in this tick [m]: by what the pull beyond the grip stretches the strand outside, as
// far as that is so tight, and by a radius of the thread at most. The direction is halfway between how the strand
// leaves the jaws and how it goes on: a strand that is bent back over them would be pulled tighter by leaving them
// straight.
Vec3 World::slide_by_stretch(const Tool& tool, const Grasp& grasp) const {
    const bool ahead = tension_after(grasp) > tension_before(grasp);
    const int inner = ahead ? grasp.first + grasp.count() - 1 : grasp.first, outwards = ahead ? 1 : -1,
              link = ahead ? inner : inner - 1;
    const double excess = pull_on(grasp) - tool.shape.grip_force;
    const double slide = stretch_by(excess, link, outwards, at(thread_.tension(), link) - excess);
    const Vec3 goes = (at(thread_.nodes(), inner + outwards) - at(thread_.nodes(), inner)).normalized();
    const Vec3 leaves = grasp.count() > 1
                            ? Vec3((at(thread_.nodes(), inner) - at(thread_.nodes(), inner - outwards)).normalized())
                            : goes;
    return slide * (goes + leaves).normalized();
}

// Jaws hold up to their grip force. Beyond it the strand slides between them along itself by just so much that the
// tension falls back to the grip force. False when it has slid out.
bool World::slip(Tool& tool, Grasp& grasp) {
    if (pull_on(grasp) <= tool.shape.grip_force) return true;
    if (!tool.slipping) log(EventKind::slip, tool.def.name, tool.shape.grip_force);
    tool.slipping = true;
    const auto nodes = thread_.nodes();
    const Vec3 slide = is_elastic() ? slide_by_stretch(tool, grasp) : slide_by_lag(tool, grasp);
    const Vec3 shift = tool.now.pose.rotation.conjugate() * slide;

    // The jaws hold what lies between them after the shift, in the place that it then has.
    std::swap(grasp, before_slip_);
    grasp.anchor.clear();
    const Grasp& before = before_slip_;
    // A strand of `ftl` may lag behind its anchors, so it is shifted from where they are; an elastic one from where it
    // is.
    const auto place = [&](int k) -> Vec3 {
        const int held = k - before.first;
        const bool from_anchor = !is_elastic() && held >= 0 && held < before.count();
        return shift + (from_anchor ? before.anchor[static_cast<std::size_t>(held)] : in_tool(tool.now, at(nodes, k)));
    };
    const auto is_free = [&](int k) { return !is_held(k); };
    const auto is_joined = [&](int link) { return joins(thread_, link); };
    const JawRoom room(tool.shape, tool.now.jaw);
    for (int i = before.first - 1; i < before.first + before.count() && grasp.count() == 0; ++i)
        hold_strand(grasp, room, tool.shape.jaw_radius, i, place, is_free, is_joined);
    return grasp.count() > 0;
}

void World::let_grasps_slip() {
    for (Tool& tool : tools_) {
        bool holds = true;
        for (const Grasp& grasp : tool.grasps) holds &= pull_on(grasp) <= tool.shape.grip_force;
        if (holds) tool.slipping = false;
        for (std::size_t g = 0; g < tool.grasps.size();) {
            if (slip(tool, tool.grasps[g])) {
                ++g;
            } else {
                log(EventKind::release, tool.def.name, 0);
                tool.grasps.erase(tool.grasps.begin() + static_cast<std::ptrdiff_t>(g));
            }
        }
    }
}

}  // namespace scenarios::world
