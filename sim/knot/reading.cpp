#include "sim/knot/reading.hpp"

#include <algorithm>

#include "sim/knot/reroute.hpp"

namespace sim::knot {

std::optional<Identity> type_of_stretch(const Diagram& open, int first, int count, bool only_if_knotted, Work& work) {
    const Identity above = identify(joined_ends(open, first, count, true), work);
    if (!above.known) return std::nullopt;
    if (only_if_knotted && above.factors.empty()) return above;
    const Identity below = identify(joined_ends(open, first, count, false), work);
    return above == below ? std::optional(above) : std::nullopt;
}

std::vector<Reading> views_of(const std::vector<Vec3>& strand, Work& work) {
    constexpr int views = 6, most_crossings = 60;
    std::vector<Reading> all;
    for (int i = 0; i < views; ++i)
        if (auto open = project_open(strand, direction(i), most_crossings)) all.emplace_back(std::move(*open), work);
    std::stable_sort(all.begin(), all.end(),
                     [](const Reading& a, const Reading& b) { return a.passages() < b.passages(); });
    return all;
}

std::vector<Reading> good_ones(std::vector<Reading> views, const Identity& whole, std::size_t wanted) {
    std::vector<Reading> good;
    for (Reading& reading : views) {
        if (good.size() == wanted) break;
        const auto type = reading.type(0, reading.passages());
        if (type && *type == whole) good.push_back(std::move(reading));
    }
    return good;
}

}  // namespace sim::knot
