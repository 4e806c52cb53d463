#include <algorithm>
#include <limits>

#include "scenarios/world/world.hpp"
#include "tissue/join.hpp"
#include "tissue/lapse.hpp"
#include "tissue/leak.hpp"
#include "tissue/rim.hpp"

// What was sewn, once a session is over.
namespace scenarios::world {

static const char* name_of(tissue::Side side) {
    switch (side) {
        case tissue::Side::outer:
            return "outer";
        case tissue::Side::inner:
            return "inner";
        case tissue::Side::cut:
            return "cut";
        case tissue::Side::far_end:
            return "far end";
    }
    return "";
}

// Of the ends on the outer side the farther from the cut: of an open mesh's rims the one that is next to each.
static double size_of(const tissue::Bite& bite, const tissue::Mesh& rest, const std::vector<tissue::Rim>& outer_rims) {
    double size = 0;
    for (const tissue::BiteEnd* end : {&bite.entry, &bite.exit}) {
        if (end->hole < 0 || end->side != tissue::Side::outer) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const tissue::Rim& rim : outer_rims)
            nearest =
                std::min(nearest, tissue::nearest(rim, rest, tissue::position(end->at, rest, rest.nodes)).distance);
        if (!outer_rims.empty()) size = std::max(size, nearest);
    }
    return size;
}

using Threads = std::span<const std::vector<Vec3>>;

static bool has_thread(const tissue::Bite& bite, const SoftVessel& vessel, Threads threads, double diameter) {
    return bite.state == tissue::BiteState::open && !bite.on_needle && !bite.torn &&
           tissue::thread_in(bite, vessel.skin, threads, diameter) >= 0;
}

static BiteMeasure measured(std::size_t number, const SoftVessel& vessel, const std::vector<tissue::Rim>& outer_rims,
                            bool has_thread) {
    const tissue::Bite& bite = vessel.bites.bites()[number];
    constexpr double degrees = 180 / 3.14159265358979324;
    const bool through = bite.state == tissue::BiteState::open;
    return {vessel.name,
            name_of(bite.entry.side),
            through ? name_of(bite.exit.side) : "",
            1e3 * size_of(bite, vessel.tissue.rest(), outer_rims),
            1e3 * bite.depth,
            degrees * bite.angle_to_wall,
            bite.partial(),
            bite.both_walls,
            bite.torn,
            bite.state == tissue::BiteState::empty,
            bite.on_needle,
            through && !bite.on_needle && !bite.torn && !has_thread,
            bite.entry.caved_in || bite.exit.caved_in,
            number < vessel.bitten_s.size() ? vessel.bitten_s[number] : 0};
}

void World::judge_sewing() {
    measures_.bites.clear();
    measures_.join = {};
    const auto slip = std::find_if(events_.begin(), events_.end(),
                                   [](const Event& event) { return event.kind == EventKind::slipped; });
    if (slip != events_.end()) measures_.slipped = slip->what, measures_.slipped_s = slip->t_s;
    const auto threads = curves();
    bool sewn = vessels_.size() == 2;
    for (const SoftVessel& vessel : vessels_) {
        const auto outer = tissue::rims(vessel.tissue.rest(), tissue::Side::outer);
        const auto bites = vessel.bites.bites();
        bool holds = false;
        for (std::size_t i = 0; i < bites.size(); ++i) {
            const bool sewn_here = has_thread(bites[i], vessel, threads, def_.thread.diameter);
            measures_.bites.push_back(measured(i, vessel, outer, sewn_here));
            holds = holds || sewn_here;
        }
        sewn = sewn && !outer.empty() && holds;
    }
    if (!sewn) return;
    const auto of = [&](const SoftVessel& vessel) {
        return tissue::SewnVessel{vessel.tissue.rest(), vessel.skin, vessel.bites.bites(), vessel.bites.def().axis};
    };
    const tissue::Join join = tissue::judge(of(vessels_[0]), of(vessels_[1]), threads, def_.thread.diameter);
    if (!join.is_sewn()) return;
    for (const tissue::LinePiece& piece : join.line)
        measures_.join.gap_mm = std::max(measures_.join.gap_mm, 1e3 * piece.gap);
    measures_.join.lumen_ratio = join.lumen_ratio;
    measures_.join.leak_ml_min = tissue::in_ml_per_min(join.leak());
    tissue::LapseLimits limits;
    limits.hole_diameters = 6 * def_.needle.wire / def_.thread.diameter;  // twice as long as it was made
    for (const tissue::Lapse& lapse : tissue::lapses(join, limits))
        measures_.join.lapses.push_back(
            {lapse.name, lapse.measure, lapse.value, lapse.limit, lapse.at_least, lapse.committed});
}

}  // namespace scenarios::world
