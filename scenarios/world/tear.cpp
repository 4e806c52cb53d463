// Thread that is pulled too hard tears out of a wall.
#include <algorithm>

#include "scenarios/world/soft_vessel.hpp"

namespace scenarios::world {

// Thread and wall are stepped in turn and tremble about their balance; tissue does not tear in that time.
static constexpr double settling_s = 0.01;

// A stitch's retention is what its loop is pulled with: both its holes together, or, where they are pulled apart, the
// one that is pulled more. What the thread does to the skin about a hole it does to the hole: there the skin is drawn
// along with the rim.
static double pull_on(const tissue::Bite& bite, std::span<const Vec3> pulls) {
    const Vec3 &entry = pulls[static_cast<std::size_t>(bite.entry.hole)],
               &exit = pulls[static_cast<std::size_t>(bite.exit.hole)];
    return std::max({(entry + exit).norm(), entry.norm(), exit.norm()});
}

void SoftVessel::pull_at_bites(double seconds, bool elastic) {
    pulls.resize(static_cast<std::size_t>(skin.holes()), Vec3::Zero());
    mean_pulls.resize(pulls.size(), Vec3::Zero());
    for (std::size_t hole = 0; hole < pulls.size(); ++hole)
        mean_pulls[hole] += std::min(1.0, seconds / settling_s) * (pulls[hole] - mean_pulls[hole]);
    strengths.resize(bites.bites().size());
    for (std::size_t i = 0; i < strengths.size(); ++i) {
        const tissue::Bite& bite = bites.bites()[i];
        if (bite.torn || bite.state != tissue::BiteState::open) continue;
        const double pull = pull_on(bite, mean_pulls);
        strengths[i].force = bites.bears(bite);
        if (strengths[i].gives_way(pull, seconds, elastic)) bites.pull(static_cast<int>(i), pull, skin);
    }
    std::fill(pulls.begin(), pulls.end(), Vec3::Zero());
}

}  // namespace scenarios::world
