#include <algorithm>
#include <limits>

#include "scenarios/world/world.hpp"

namespace scenarios::world {

// Each step is as long as it takes until the same vessel's turn comes again, 2 ms at least: one vessel a tick.
static std::uint64_t period(std::size_t vessels) {
    return std::max<std::uint64_t>(2, vessels);
}

static EventKind kind_of(tissue::BiteEvent::Kind kind) {
    switch (kind) {
        case tissue::BiteEvent::pierced:
            return EventKind::pierced;
        case tissue::BiteEvent::through:
            return EventKind::through;
        case tissue::BiteEvent::back_in:
            return EventKind::back_in;
        case tissue::BiteEvent::withdrawn:
            return EventKind::withdrawn;
        case tissue::BiteEvent::drawn:
            return EventKind::drawn;
        case tissue::BiteEvent::torn:
            return EventKind::torn;
        case tissue::BiteEvent::slipped:
            return EventKind::slipped;
    }
    return EventKind::slipped;
}

// By `ftl` a tension is an estimate: no more than the thread, and the jaws that hold it, bear.
double World::believed_share() const {
    if (is_elastic()) return 1;
    const double tension = *std::max_element(thread_.tension().begin(), thread_.tension().end()),
                 most = std::min(most_pull(), def_.thread.break_force);
    return tension <= most ? 1 : most / tension;
}

// What the thread does to a vessel between two of its steps counts for as long as it did it.
void World::load_vessels() {
    const double share = 1.0 / static_cast<double>(period(vessels_.size())), believed = believed_share();
    for (const sim::thread::SurfaceForce& pressed : thread_.surface_forces())
        for (SoftVessel& vessel : vessels_)
            if (vessel.first <= pressed.triangle && pressed.triangle < vessel.first + vessel.skin.size())
                vessel.press(pressed, pressed.asleep.value_or(wall_.tree()[pressed.triangle]), believed);
    for (SoftVessel& vessel : vessels_) vessel.load(share, is_elastic());
}

// Tools push walls out of themselves, but jaws not what is between them.
void World::push_walls(int vessel) {
    SoftVessel& of = vessels_[static_cast<std::size_t>(vessel)];
    for (const Tool& tool : tools_) {
        const bool holds = std::any_of(tool.walls.begin(), tool.walls.end(),
                                       [&](const WallGrip& grip) { return grip.vessel == vessel; });
        const auto from = instruments::parts_at(tool.shape, tool.before.pose, tool.before.jaw),
                   to = instruments::parts_at(tool.shape, tool.now.pose, tool.now.jaw);
        for (std::size_t part = 0; part < to.size(); ++part)
            if (!holds || part == instruments::shaft) tool_contact_.press(of.skin, to[part], from[part], of.forces);
    }
}

// Once in all vessels' turns: each feels it in its own.
void World::press_walls_together() {
    for (std::size_t a = 0; a < vessels_.size(); ++a) {
        wall_contact_.press(vessels_[a].tissue.rest(), vessels_[a].skin, vessels_[a].forces, vessels_[a].carried);
        for (std::size_t b = a + 1; b < vessels_.size(); ++b)
            wall_contact_.press(vessels_[a].tissue.rest(), vessels_[a].skin, vessels_[a].forces,
                                vessels_[b].tissue.rest(), vessels_[b].skin, vessels_[b].forces);
    }
}

void World::move_vessels() {
    if (in_use_ != taken_ && !is_needle_in_wall()) in_use_ = taken_;
    if (vessels_.empty()) return;
    load_vessels();
    if (ticks_ % period(vessels_.size()) == 0) press_walls_together();
    const std::uint64_t turns = period(vessels_.size()), turn = ticks_ % turns;
    if (turn < vessels_.size()) move(vessels_[turn], static_cast<double>(turns) * def_.tick_s);
    show_vessels();
}

void World::move(SoftVessel& vessel, double seconds) {
    const int openings = vessel.skin.openings();
    pull_walls(static_cast<int>(&vessel - vessels_.data()));
    push_walls(static_cast<int>(&vessel - vessels_.data()));
    if (needles_.empty()) {
        vessel.bites.press(nullptr, vessel.skin);
    } else {
        const Arc with_swage = needle().longer(thread_.rest_lengths()[static_cast<std::size_t>(
            needle_in_use().node)]);  // the link that it leads as stiffly as itself
        vessel.bites.press(&with_swage, vessel.skin);
    }
    vessel.forces.insert(vessel.forces.end(), vessel.bites.forces().begin(), vessel.bites.forces().end());
    lead_clamps(vessel);
    vessel.tissue.step({.holds = vessel.clamps, .forces = vessel.forces}, seconds);
    vessel.forces.clear();
    vessel.skin.update(vessel.tissue.nodes());
    vessel.bites.settle(vessel.skin);
    pull_at_bites(vessel, seconds);
    for (const tissue::BiteEvent& event : vessel.bites.events()) {
        log(kind_of(event.kind), vessel.name, event.force);
        const bool bites = event.kind == tissue::BiteEvent::pierced || event.kind == tissue::BiteEvent::through ||
                           event.kind == tissue::BiteEvent::withdrawn;
        if (!bites) continue;
        vessel.bitten_s.resize(vessel.bites.bites().size());
        vessel.bitten_s[static_cast<std::size_t>(event.bite)] = time_s();
    }
    if (vessel.skin.openings() > openings) renew_wall();
}

// A hole or a slit is new: triangles have other numbers, and the thread looks for all of them anew.
void World::renew_wall() {
    const std::size_t rigid = vessels_.empty() ? targets_.size() : static_cast<std::size_t>(vessels_.front().first);
    std::vector<tissue::Part> parts;
    for (std::size_t t = 0; t < rigid; ++t) parts.push_back({static_cast<int>(t)});
    for (SoftVessel& vessel : vessels_) {
        for (const tissue::Part& part : vessel.skin.parts()) parts.push_back({vessel.first + part.of, part.weights});
        vessel.skin.forget_parts();
    }
    targets_ = with_skins({targets_.begin(), targets_.begin() + static_cast<std::ptrdiff_t>(rigid)}, vessels_);
    wall_.renew(targets_, parts, holes_in(rigid, vessels_));
    wall_is_new_ = true;
}

// The thread meets them where they are now, or as near to there as it makes room.
void World::show_vessels() {
    for (const SoftVessel& vessel : vessels_)
        for (int t = 0; t < vessel.skin.size(); ++t)
            targets_[static_cast<std::size_t>(vessel.first + t)] = vessel.skin[t];
    if (wall_is_new_) {
        wall_moved_ = std::numeric_limits<double>::infinity();
        wall_is_new_ = false;
        return;
    }
    rooms_.resize(targets_.size());
    thread_.surface_room(rooms_, gaps_);
    wall_moved_ = wall_.follow(targets_, rooms_, gaps_);
}

}  // namespace scenarios::world
