// What was tied and sewn, once a session is over.
#include "scenarios/world/judge.hpp"

#include <algorithm>
#include <limits>

#include "scenarios/world/locate.hpp"
#include "scenarios/world/world.hpp"
#include "tissue/join.hpp"
#include "tissue/lapse.hpp"
#include "tissue/leak.hpp"
#include "tissue/rim.hpp"

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

// How far a bite's end on the outer side is from the cut, the farther where both are; of an open mesh's rims the one
// next to each end counts [m].
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

// Appends every bite. True where both of two vessels are cut and have a bite that holds thread: only then is there a
// join to judge.
static bool measure_bites(const World& world, Threads threads, std::vector<BiteMeasure>& bites) {
    bool sewn = world.vessels().size() == 2;
    for (const SoftVessel& vessel : world.vessels()) {
        const auto outer = tissue::rims(vessel.tissue.rest(), tissue::Side::outer);
        bool holds = false;
        for (std::size_t i = 0; i < vessel.bites.bites().size(); ++i) {
            const bool sewn_here = has_thread(vessel.bites.bites()[i], vessel, threads, world.def().thread.diameter);
            bites.push_back(measured(i, vessel, outer, sewn_here));
            holds = holds || sewn_here;
        }
        sewn = sewn && !outer.empty() && holds;
    }
    return sewn;
}

static JoinMeasure measure_join(const World& world, Threads threads) {
    const double diameter = world.def().thread.diameter;
    const auto of = [&](const SoftVessel& vessel) {
        return tissue::SewnVessel{vessel.tissue.rest(), vessel.skin, vessel.bites.bites(), vessel.bites.def().axis};
    };
    const tissue::Join found = tissue::judge(of(world.vessels()[0]), of(world.vessels()[1]), threads, diameter);
    JoinMeasure join;
    if (!found.is_sewn()) return join;
    for (const tissue::LinePiece& piece : found.line) join.gap_mm = std::max(join.gap_mm, 1e3 * piece.gap);
    join.lumen_ratio = found.lumen_ratio;
    join.leak_ml_min = tissue::in_ml_per_min(found.leak());
    tissue::LapseLimits limits;
    limits.hole_diameters = 6 * world.def().needle.wire / diameter;  // twice as long as the needle made it
    for (const tissue::Lapse& lapse : tissue::lapses(found, limits))
        join.lapses.push_back({lapse.name, lapse.measure, lapse.value, lapse.limit, lapse.at_least, lapse.committed});
    return join;
}

Sewing judge_sewing(const World& world) {
    Sewing sewing;
    const auto events = world.events();
    const auto slip =
        std::find_if(events.begin(), events.end(), [](const Event& event) { return event.kind == EventKind::slipped; });
    if (slip != events.end()) sewing.slipped = slip->what, sewing.slipped_s = slip->t_s;
    const auto threads = world.curves();
    if (measure_bites(world, threads, sewing.bites)) sewing.join = measure_join(world, threads);
    return sewing;
}

std::vector<TieMeasure> judge_ties(const World& world) {
    std::vector<TieMeasure> ties;
    for (const sim::thread::Piece& piece : world.thread_state().pieces()) {
        const std::vector<Vec3> curve = world.curve_of(piece);
        sim::knot::Name knot = sim::knot::name_knot(curve);
        if (knot.factors.empty()) continue;
        std::vector<double> tails = tails_of(curve, world.rest_of(piece), knot.knot);
        ties.push_back({std::move(knot), std::move(tails)});
    }
    return ties;
}

Measures judge(const World& world) {
    Measures measures = world.measures();
    static_cast<KnotPlace&>(measures) = locate_knot(world);
    static_cast<Sewing&>(measures) = judge_sewing(world);
    measures.ties = judge_ties(world);
    return measures;
}

}  // namespace scenarios::world
