#include "scenarios/world/walls.hpp"

#include <algorithm>
#include <limits>

namespace scenarios::world {

// How many ticks a vessel's step takes: until its turn comes again, at least 2, for one vessel is stepped a tick.
static std::uint64_t period(std::size_t vessels) {
    return std::max<std::uint64_t>(2, vessels);
}

static bool is_elastic(const sim::thread::Thread& thread) {
    return thread.def().elastic.has_value();
}

static std::vector<SoftVessel> soft_vessels(const WorldDef& def) {
    std::vector<SoftVessel> vessels;
    for (const VesselDef& vessel : def.vessels)
        if (vessel.is_soft) vessels.emplace_back(vessel, def.needle.wire);
    return vessels;
}

static double thinnest_wall(const WorldDef& def) {
    double thinnest = 1e300;
    for (const VesselDef& vessel : def.vessels) thinnest = std::min(thinnest, vessel.wall);
    return thinnest;
}

Walls::Walls(const WorldDef& def, std::vector<Triangle> rigid)
    : vessels_(soft_vessels(def)),
      wall_contact_({}, thinnest_wall(def)),
      shown_(with_skins(std::move(rigid), vessels_), def.thread.diameter / 2),
      targets_(shown_.tree().triangles()) {
    gaps_.reserve(4096);
}

void Walls::clamp(std::span<const Tool> tools) {
    for (SoftVessel& vessel : vessels_)
        if (vessel.held_by >= 0) vessel.clamp(tools[static_cast<std::size_t>(vessel.held_by)]);
}

bool Walls::hold_needle() const {
    return std::any_of(vessels_.begin(), vessels_.end(), [](const SoftVessel& vessel) {
        return vessel.bites.touches() || vessel.bites.holes_on_needle() > 0;
    });
}

void Walls::tick(const WallLoads& loads, std::vector<Event>& events) {
    if (vessels_.empty()) return;
    take_pressure(loads);
    const std::uint64_t turns = period(vessels_.size()), turn = loads.tick % turns;
    if (turn == 0) press_together();
    if (turn < vessels_.size()) move(vessels_[turn], static_cast<double>(turns) * loads.tick_s, loads, events);
    show(loads.thread);
}

// What the thread does to a vessel between two of its steps counts for as long as it did it.
void Walls::take_pressure(const WallLoads& loads) {
    const double share = 1.0 / static_cast<double>(period(vessels_.size()));
    for (const sim::thread::SurfaceForce& pressed : loads.thread.surface_forces())
        for (SoftVessel& vessel : vessels_)
            if (vessel.first <= pressed.triangle && pressed.triangle < vessel.first + vessel.skin.size())
                vessel.press(pressed, pressed.asleep.value_or(tree()[pressed.triangle]), loads.trusted_share);
    for (SoftVessel& vessel : vessels_) vessel.load(share, is_elastic(loads.thread));
}

// Walls press on each other once in all vessels' turns, and each feels it in its own turn.
void Walls::press_together() {
    for (std::size_t a = 0; a < vessels_.size(); ++a) {
        wall_contact_.press(vessels_[a].tissue.rest(), vessels_[a].skin, vessels_[a].forces, vessels_[a].carried);
        for (std::size_t b = a + 1; b < vessels_.size(); ++b)
            wall_contact_.press(vessels_[a].tissue.rest(), vessels_[a].skin, vessels_[a].forces,
                                vessels_[b].tissue.rest(), vessels_[b].skin, vessels_[b].forces);
    }
}

void Walls::move(SoftVessel& vessel, double seconds, const WallLoads& loads, std::vector<Event>& events) {
    const int openings = vessel.skin.openings();
    for (const Tool& tool : loads.tools) vessel.pull_by(tool, index_of(vessel));
    push_out_of_tools(vessel, loads.tools);
    follow_needle(vessel, loads);
    if (vessel.held_by >= 0) vessel.lead_clamps(loads.tools[static_cast<std::size_t>(vessel.held_by)]);
    vessel.step(seconds);
    vessel.pull_at_bites(seconds, is_elastic(loads.thread));
    vessel.note_bites(static_cast<double>(loads.tick) * loads.tick_s, events);
    if (vessel.skin.openings() > openings) renew();
}

// Tools push walls out of themselves, but jaws do not push at the wall that is between them.
void Walls::push_out_of_tools(SoftVessel& vessel, std::span<const Tool> tools) {
    for (const Tool& tool : tools) {
        const bool holds = std::any_of(tool.walls.begin(), tool.walls.end(),
                                       [&](const WallGrip& grip) { return grip.vessel == index_of(vessel); });
        const auto from = instruments::parts_at(tool.shape, tool.before.pose, tool.before.jaw),
                   to = instruments::parts_at(tool.shape, tool.now.pose, tool.now.jaw);
        for (std::size_t part = 0; part < to.size(); ++part)
            if (!holds || part == instruments::shaft)
                tool_contact_.press(vessel.skin, to[part], from[part], vessel.forces);
    }
}

// The link that the needle leads follows it as stiffly as its own wire does, so it counts as wire.
void Walls::follow_needle(SoftVessel& vessel, const WallLoads& loads) {
    if (loads.needle) {
        const Arc with_swage =
            loads.needle->now.longer(loads.thread.rest_lengths()[static_cast<std::size_t>(loads.needle->node)]);
        vessel.bites.press(&with_swage, vessel.skin);
    } else {
        vessel.bites.press(nullptr, vessel.skin);
    }
    vessel.forces.insert(vessel.forces.end(), vessel.bites.forces().begin(), vessel.bites.forces().end());
}

// After a new hole or slit triangles have other numbers, and the thread looks for all of them anew.
void Walls::renew() {
    const std::size_t rigid = static_cast<std::size_t>(soft_from());
    std::vector<tissue::Part> parts;
    for (std::size_t t = 0; t < rigid; ++t) parts.push_back({static_cast<int>(t)});
    for (SoftVessel& vessel : vessels_) {
        for (const tissue::Part& part : vessel.skin.parts()) parts.push_back({vessel.first + part.of, part.weights});
        vessel.skin.forget_parts();
    }
    targets_ = with_skins({targets_.begin(), targets_.begin() + static_cast<std::ptrdiff_t>(rigid)}, vessels_);
    shown_.renew(targets_, parts, holes_in(rigid, vessels_));
    is_new_ = true;
}

// The thread meets walls where they are now, or as near to there as it makes room.
void Walls::show(const sim::thread::Thread& thread) {
    for (const SoftVessel& vessel : vessels_)
        for (int t = 0; t < vessel.skin.size(); ++t)
            targets_[static_cast<std::size_t>(vessel.first + t)] = vessel.skin[t];
    if (is_new_) {
        moved_ = std::numeric_limits<double>::infinity();
        is_new_ = false;
        return;
    }
    rooms_.resize(targets_.size());
    thread.surface_room(rooms_, gaps_);
    moved_ = shown_.follow(targets_, rooms_, gaps_);
}

}  // namespace scenarios::world
