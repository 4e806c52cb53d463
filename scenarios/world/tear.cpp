#include <algorithm>

#include "scenarios/world/world.hpp"

// Thread that is pulled too hard tears out of a wall.
namespace scenarios::world {

// A stitch's retention is what its loop is pulled with: both its holes together. Where they are pulled apart, the one
// that is pulled more. What the thread does to the skin about a hole it does to the hole: there that is drawn along
// with the rim.
void World::pull_at_bites(SoftVessel& vessel, double seconds) {
    constexpr double settling = 0.01;  // [s]: thread and wall are stepped in turn and tremble about their balance;
                                       // tissue does not tear in that time
    const auto bites = vessel.bites.bites();
    vessel.pulls.resize(static_cast<std::size_t>(vessel.skin.holes()), Vec3::Zero());
    vessel.mean_pulls.resize(vessel.pulls.size(), Vec3::Zero());
    for (std::size_t hole = 0; hole < vessel.pulls.size(); ++hole)
        vessel.mean_pulls[hole] += std::min(1.0, seconds / settling) * (vessel.pulls[hole] - vessel.mean_pulls[hole]);
    vessel.strengths.resize(bites.size());
    for (std::size_t i = 0; i < bites.size(); ++i) {
        const tissue::Bite& bite = bites[i];
        if (bite.torn || bite.state != tissue::BiteState::open) continue;
        const auto of = [&](const tissue::BiteEnd& end) -> const Vec3& {
            return vessel.mean_pulls[static_cast<std::size_t>(end.hole)];
        };
        const Vec3 &entry = of(bite.entry), &exit = of(bite.exit);
        const double pull = std::max({(entry + exit).norm(), entry.norm(), exit.norm()});
        vessel.strengths[i].force = vessel.bites.bears(bite);
        if (vessel.strengths[i].gives_way(pull, seconds, is_elastic()))
            vessel.bites.pull(static_cast<int>(i), pull, vessel.skin);
    }
    std::fill(vessel.pulls.begin(), vessel.pulls.end(), Vec3::Zero());
}

}  // namespace scenarios::world
