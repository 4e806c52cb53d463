#include "scenarios/world/world.hpp"

namespace scenarios::world {

// Each step is as long as it takes until the same vessel's turn comes again, 2 ms at least: one vessel a tick.
static std::uint64_t period(std::size_t vessels) { return std::max<std::uint64_t>(2, vessels); }

// What the thread does to a vessel between two of its steps counts for as long as it did it. A pull falls off as what pulls gives way: a
// taut strand's by its stiffness.
void World::load_vessels() {
    const double share = 1.0 / static_cast<double>(period(vessels_.size())), stiffness = thread_.def().axial_stiffness / def_.thread.length;
    for (const sim::thread::SurfaceForce& pressed : thread_.surface_forces())
        for (SoftVessel& vessel : vessels_) {
            const int triangle = pressed.triangle - vessel.first;
            if (triangle < 0 || triangle >= vessel.skin.size()) continue;
            const Vec3 weights = tissue::weights_in(wall_.tree()[pressed.triangle], pressed.at);
            vessel.forces.push_back({vessel.skin.point(triangle, weights), share * pressed.force, share * stiffness});
        }
}

void World::move_vessels() {
    if (vessels_.empty()) return;
    load_vessels();
    const std::uint64_t turns = period(vessels_.size()), turn = ticks_ % turns;
    if (turn < vessels_.size()) {
        SoftVessel& vessel = vessels_[turn];
        vessel.tissue.step({.holds = vessel.clamps, .forces = vessel.forces}, static_cast<double>(turns) * def_.tick_s);
        vessel.forces.clear();
        vessel.skin.update(vessel.tissue.nodes());
    }
    show_vessels();
}

// The thread meets them where they are now, or as near to there as it makes room.
void World::show_vessels() {
    for (const SoftVessel& vessel : vessels_)
        for (int t = 0; t < vessel.skin.size(); ++t) targets_[static_cast<std::size_t>(vessel.first + t)] = vessel.skin[t];
    rooms_.resize(targets_.size());
    thread_.surface_room(rooms_);
    wall_moved_ = wall_.follow(targets_, rooms_);
}

}  // namespace scenarios::world
