#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenarios/world/jaws.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::world {

namespace {

// The closing jaws lay the strand flat between their inner faces; each link keeps its length and, in the plane of the
// jaws, its direction.
void flatten(Grasp& grasp, const JawRoom& room) {
    const auto lay = [&](int from, int to) {
        const Vec3& leader = grasp.anchor[static_cast<std::size_t>(from)];
        Vec3& follower = grasp.anchor[static_cast<std::size_t>(to)];
        Vec3 d = follower - leader;
        const double length2 = d.squaredNorm(), half = room.half_gap(follower.z());
        d.x() = std::clamp(follower.x(), -half, half) - leader.x();
        const double flat2 = d.y() * d.y() + d.z() * d.z(), wanted2 = std::max(0.0, length2 - d.x() * d.x());
        if (flat2 > 0) {
            d.y() *= std::sqrt(wanted2 / flat2);
            d.z() *= std::sqrt(wanted2 / flat2);
        } else {
            d.y() = std::sqrt(wanted2);  // it stood across the jaws: they lay it to one side
        }
        follower = leader + d;
    };
    const int middle = grasp.count / 2;
    Vec3& centre = grasp.anchor[static_cast<std::size_t>(middle)];
    const double half = room.half_gap(centre.z()), shift = std::clamp(centre.x(), -half, half) - centre.x();
    for (int k = 0; k < grasp.count; ++k) grasp.anchor[static_cast<std::size_t>(k)].x() += shift;
    for (int k = middle; k + 1 < grasp.count; ++k) lay(k, k + 1);
    for (int k = middle; k > 0; --k) lay(k, k - 1);
}

template <class T>
const T& at(std::span<const T> values, int i) { return values[static_cast<std::size_t>(i)]; }

}  // namespace

bool World::is_held(int node) const {
    for (const Tool& tool : tools_)
        for (const Grasp& grasp : tool.grasps)
            if (node >= grasp.first && node < grasp.first + grasp.count) return true;
    return false;
}

// Closing jaws hold every strand that passes through their middle plane y = 0 between them, or ends there: by the nodes of
// the link that passes and those beside it within the jaws' width. A loop that only lies round open jaws is not held.
// Two tools on one strand hold different nodes. The thread lies where the last tick left it, so it is held by where the tool
// was then, and goes along with it in this tick already.
void World::take_hold(Tool& tool) {
    const JawRoom room(tool.shape, tool.now.jaw);
    const int last = static_cast<int>(thread_.nodes().size()) - 1;
    const auto place = [&](int k) { return in_tool(tool.before, thread_.nodes()[static_cast<std::size_t>(k)]); };
    const auto is_first = [&](int k) { return k == 0 || thread_.is_cut(k - 1); };
    const auto is_last = [&](int k) { return k == last || thread_.is_cut(k); };
    const auto within = [&](int k) { return !is_held(k) && room.holds(place(k), tool.shape.jaw_radius); };
    for (int i = 0; i < last; ++i) {
        const Vec3 a = place(i), b = place(i + 1);
        const bool passes = room.is_passed_by(a, b), ends = (is_first(i) && within(i)) || (is_last(i + 1) && within(i + 1));
        if (thread_.is_cut(i) || (!passes && !ends) || is_held(i) || is_held(i + 1)) continue;
        int from = i, to = i + 1;
        // One node beyond the jaws' width on either side, so that the first free link starts outside the metal.
        const auto take = [&](int k) { return !is_held(k) && to - from + 2 < Grasp::most; };
        while (!is_first(from) && take(from - 1) && within(from)) --from;
        while (!is_last(to) && take(to + 1) && within(to)) ++to;
        Grasp grasp{from, to - from + 1, {}};
        for (int k = from; k <= to; ++k) grasp.anchor[static_cast<std::size_t>(k - from)] = place(k);
        tool.grasps.push_back(grasp);
        log("grasp", tool.def.name, 1e3 * std::accumulate(thread_.rest_lengths().begin(), thread_.rest_lengths().begin() + grasp.middle(), 0.0));
        ++measures_.grasps[static_cast<std::size_t>(&tool - tools_.data())];
        i = to;
    }
}

void World::update_grasps() {
    for (Tool& tool : tools_) {
        if (tool.def.kind == instruments::Kind::scissors) continue;  // they never hold
        if (!tool.closed && tool.now.jaw < shut_below) {
            tool.closed = true;
            take_hold(tool);
        } else if (tool.closed && tool.now.jaw > open_above) {
            tool.closed = false;
            for (const Grasp& grasp : tool.grasps) log("release", tool.def.name, grasp.middle());
            tool.grasps.clear();
        }
        const JawRoom room(tool.shape, tool.now.jaw);
        for (Grasp& grasp : tool.grasps) flatten(grasp, room);
    }
}

// What its free strands pull the one way more than the other [N]; of `ftl`, which has no forces, the estimate.
double World::pull_on(const Grasp& grasp) const {
    return is_elastic() ? std::abs(tension_after(grasp) - tension_before(grasp)) : tension_at(grasp.middle());
}

// An estimate from lag: all of it but the share that the grip bears.
Vec3 World::slide_by_lag(const Tool& tool, const Grasp& grasp) const {
    const Vec3 anchor = grasp.anchor[static_cast<std::size_t>(grasp.count / 2)];
    const Vec3 lag = tool.asked.pose.position + tool.asked.pose.rotation * anchor - thread_.nodes()[static_cast<std::size_t>(grasp.middle())];
    return -((1 - tool.shape.grip_force / pull_on(grasp)) * lag);
}

// What the strand outside, as far as it is that tight, is stretched by the pull beyond the grip; along itself where it leaves the jaws, by
// its radius a tick at most.
Vec3 World::slide_by_stretch(const Tool& tool, const Grasp& grasp) const {
    const bool ahead = tension_after(grasp) > tension_before(grasp);
    const int last = static_cast<int>(thread_.tension().size()) - 1, inner = ahead ? grasp.first + grasp.count - 1 : grasp.first;
    const int outwards = ahead ? 1 : -1, link = ahead ? inner : inner - 1;
    const double excess = pull_on(grasp) - tool.shape.grip_force, borne = at(thread_.tension(), link) - excess;
    double tight = 0;
    for (int k = link; k >= 0 && k <= last && at(thread_.tension(), k) > borne; k += outwards) tight += at(thread_.rest_lengths(), k);
    const double slide = excess / thread_.def().elastic->axial_stiffness(at(thread_.rest_lengths(), link)) * tight;
    const Vec3 along = grasp.count > 1 ? at(thread_.nodes(), inner) - at(thread_.nodes(), inner - outwards)
                                       : at(thread_.nodes(), inner + outwards) - at(thread_.nodes(), inner);
    return std::min(slide, thread_.def().radius) * along.normalized();
}

// Jaws hold up to their grip force. Beyond it the strand slides between them along itself by just so much that the
// tension falls back to the grip force. False when it has slid out.
bool World::slip(Tool& tool, Grasp& grasp) {
    if (pull_on(grasp) <= tool.shape.grip_force) return true;
    if (!tool.slipping) log("slip", tool.def.name, tool.shape.grip_force);
    tool.slipping = true;
    const auto nodes = thread_.nodes();
    const Vec3 slide = is_elastic() ? slide_by_stretch(tool, grasp) : slide_by_lag(tool, grasp);
    const Vec3 shift = tool.now.pose.rotation.conjugate() * slide;

    // What the jaws hold now: the nodes that are in their room after the shift, in the place they then have.
    const JawRoom room(tool.shape, tool.now.jaw);
    Grasp shifted{0, 0, {}};
    const int end = grasp.first + grasp.count, last = static_cast<int>(nodes.size()) - 1;
    const auto is_joined = [&](int link) { return link >= 0 && link < last && !thread_.is_cut(link); };
    for (int k = grasp.first - is_joined(grasp.first - 1); k < end + is_joined(end - 1); ++k) {
        const bool was_held = k >= grasp.first && k < grasp.first + grasp.count;
        if (!was_held && is_held(k)) continue;
        // From where a strand with tension is, for it may be behind; one without is told to be where it lags to.
        const bool from_anchor = was_held && !is_elastic();
        const Vec3 place = shift + (from_anchor ? grasp.anchor[static_cast<std::size_t>(k - grasp.first)] : in_tool(tool.now, at(nodes, k)));
        const double half_link = 0.5 * at(thread_.rest_lengths(), is_joined(k) ? k : k - 1);
        if (std::abs(place.y()) > tool.shape.jaw_radius + 2 * half_link || !room.holds({0, 0, place.z()}, 0)) continue;
        if (shifted.count == Grasp::most || (shifted.count > 0 && k != shifted.first + shifted.count)) break;
        if (shifted.count == 0) shifted.first = k;
        shifted.anchor[static_cast<std::size_t>(shifted.count++)] = place;
    }
    grasp = shifted;
    return grasp.count > 0;
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
                log("release", tool.def.name, 0);
                tool.grasps.erase(tool.grasps.begin() + static_cast<std::ptrdiff_t>(g));
            }
        }
    }
}

}  // namespace scenarios::world
