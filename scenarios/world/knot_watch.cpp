#include "scenarios/world/knot_watch.hpp"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace scenarios::world {

// A vessel's core goes on beyond the thread at either end, wherever that lies.
static std::vector<Vec3> core_of(const VesselDef& vessel, double thread_length) {
    const Vec3 half = (0.5 * vessel.length + thread_length) * vessel.axis.normalized();
    return {vessel.centre - half, vessel.centre, vessel.centre + half};
}

KnotWatch::KnotWatch(const WorldDef& def) {
    for (const VesselDef& vessel : def.vessels) cores_.push_back(core_of(vessel, def.thread.length));
}

// A piece that lies where it lay has the name that it had.
static std::vector<NamedPiece> name_all(std::vector<std::vector<Vec3>> curves,
                                        const std::vector<std::vector<Vec3>>& cores,
                                        const std::vector<NamedPiece>& known) {
    std::vector<NamedPiece> pieces;
    for (auto& curve : curves) {
        const auto same =
            std::find_if(known.begin(), known.end(), [&](const NamedPiece& piece) { return piece.curve == curve; });
        sim::knot::Tied tied = same != known.end() ? same->tied : sim::knot::name_among(curve, cores);
        pieces.push_back({std::move(curve), std::move(tied)});
    }
    return pieces;
}

void KnotWatch::start(std::vector<std::vector<Vec3>> curves) {
    moved_ = false;
    naming_ = std::async(std::launch::async, [curves = std::move(curves), cores = cores_, known = named_]() mutable {
        return name_all(std::move(curves), cores, known);
    });
}

bool KnotWatch::fetch(std::uint64_t tick) {
    if (!naming_.valid() || tick % period != delay) return false;
    named_ = naming_.get();
    naming_ = {};
    return true;
}

void KnotWatch::name_now(std::vector<std::vector<Vec3>> curves) {
    naming_ = {};
    moved_ = false;
    named_ = name_all(std::move(curves), cores_, named_);
}

// Whether a piece is tied more than another: by crossings first, for a hitch is no knot.
static bool ties_more(const sim::knot::Tied& a, const sim::knot::Tied& b) {
    const auto much = [](const sim::knot::Tied& tied) {
        int crossings = 0;
        for (const auto& factor : tied.name.factors) crossings += factor.crossings;
        return std::tuple(crossings, tied.name.throw_list.size(), tied.round >= 0);
    };
    return much(a) > much(b);
}

std::size_t KnotWatch::most_tied() const {
    assert(!named_.empty() && "names were fetched");
    std::size_t most = 0;
    for (std::size_t i = 1; i < named_.size(); ++i)
        if (ties_more(named_[i].tied, named_[most].tied)) most = i;
    return most;
}

}  // namespace scenarios::world
