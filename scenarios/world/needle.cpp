#include <algorithm>
#include <cstdio>
#include <optional>

#include "scenarios/world/jaws.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::world {

// Angle between the jaws' middle plane and the wire [degrees]; a needle should be held at 90.
static double degrees_to_jaws(const Arc& seen, double along) {
    const Vec3 wire = seen.tangent(along);
    return 180 / 3.14159265358979324 *
           sim::geometry::portable_atan2(std::abs(wire.y()), std::sqrt(wire.x() * wire.x() + wire.z() * wire.z()));
}

// Where the wire passes through the jaws' middle plane between them, along the wire from its tail [m].
static std::optional<double> place_between(const JawRoom& room, const Arc& seen) {
    constexpr int looks = 64;  // of a millimetre of the longest needle each: none holds two crossings
    for (int k = 0; k < looks; ++k) {
        const double from = seen.length() * k / looks, to = seen.length() * (k + 1) / looks;
        const Vec3 a = seen.at(from), b = seen.at(to);
        if ((a.y() < 0) == (b.y() < 0)) continue;
        const double share = a.y() / (a.y() - b.y());
        Vec3 crossing = a + share * (b - a);
        crossing.y() = 0;
        if (room.holds(crossing, 0)) return from + share * (to - from);
    }
    return {};
}

// Closing jaws hold the needle where it is between them, at whatever angle.
bool World::take(Needle& needle, int number, const JawRoom& room) {
    const Tool& tool = tools_[static_cast<std::size_t>(number)];
    const Arc seen = instruments::into_tool(needle.now, tool.before.pose);
    const auto along = place_between(room, seen);
    if (!along) return false;
    const Holder holder{number, seen, *along};
    (needle.holder.tool < 0 ? needle.holder : needle.next) = holder;
    const double degrees = degrees_to_jaws(seen, *along);
    if (!measures_.needle_deg || degrees < measures_.needle_deg->value)
        measures_.needle_deg = Moment{degrees, time_s()};
    char what[64];
    std::snprintf(what, sizeof what, "%s at %.0f degrees", tool.def.name.c_str(), degrees);
    log(EventKind::needle_grasp, what, 1e3 * *along);
    return true;
}

bool World::take_needle(int number, const JawRoom& room) {
    for (std::size_t i = 0; i < needles_.size(); ++i) {
        if (!take(needles_[i], number, room)) continue;
        taken_ = i;
        return true;
    }
    return false;
}

// When a holder lets go, the next has the needle from where it is now.
void World::let_needle_go(int number) {
    for (Needle& needle : needles_) {
        if (needle.next.tool == number) needle.next = {};
        if (needle.holder.tool != number) continue;
        log(EventKind::needle_release, tools_[static_cast<std::size_t>(number)].def.name, 0);
        needle.holder = needle.next;
        needle.next = {};
        if (const int tool = needle.holder.tool; tool >= 0)
            needle.holder.seen = instruments::into_tool(needle.now, tools_[static_cast<std::size_t>(tool)].before.pose);
    }
}

Arc Needle::led_by(const instruments::Pose& tool) const {
    return holder.tool < 0 ? now : instruments::out_of_tool(holder.seen, tool);
}

// A needle bends where its holder's jaws have it. What walls push and pull with is taken to act at the tip, where it
// bends most. Told once.
void World::watch_needle() {
    if (needles_.empty()) return;
    Needle& needle = needles_[in_use_];
    if (needle.bent || needle.holder.tool < 0) return;
    Vec3 force = Vec3::Zero();
    for (const SoftVessel& vessel : vessels()) force += vessel.bites.force();
    const double arm = (needle.now.tip() - needle.now.at(needle.holder.along)).norm();
    if (force.norm() * arm <= instruments::yield_moment(needle.now.wire)) return;
    needle.bent = true;
    log(EventKind::needle_bent, tools_[static_cast<std::size_t>(needle.holder.tool)].def.name, force.norm());
}

// The second holder loses a needle that is no longer between its jaws, were they open: the needle follows the first,
// not the second.
void World::drop_second_grip(Needle& needle) {
    if (needle.next.tool < 0) return;
    const Tool& tool = tools_[static_cast<std::size_t>(needle.next.tool)];
    if (place_between(JawRoom(tool.shape, 1), instruments::into_tool(needle.now, tool.now.pose))) return;
    needle.next = {};
    log(EventKind::needle_release, tool.def.name, 0);
}

// The needle goes with its holder or stays where it is. Thread leaves its tail along the wire: two nodes are fixed to
// it.
void World::hold_thread_on(Needle& needle) {
    const int owner = needle.holder.tool;
    const bool is_led = owner >= 0;
    const Tool* tool = is_led ? &tools_[static_cast<std::size_t>(owner)] : nullptr;
    needle.before = needle.now;
    if (is_led) needle.now = needle.led_by(tool->now.pose);
    drop_second_grip(needle);
    const Arc wanted = is_led && !tool->stopped ? needle.led_by(tool->asked.pose) : needle.now;
    const double first = thread_.rest_lengths()[static_cast<std::size_t>(needle.node)];
    for (const int behind : {0, 1}) {
        const auto place = [&](const Arc& arc) -> Vec3 { return arc.tail() - (behind * first) * arc.tangent(0); };
        holds_.push_back({needle.node + behind, place(needle.now), place(wanted), true, place(needle.before)});
        hold_owners_.push_back(owner);
    }
    const auto from = instruments::parts_of(needle.before), to = instruments::parts_of(needle.now);
    for (std::size_t part = 0; part < from.size(); ++part) capsules_.push_back({from[part], to[part], owner});
}

}  // namespace scenarios::world
