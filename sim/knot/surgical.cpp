#include "sim/knot/surgical.hpp"

#include <algorithm>

#include "sim/knot/form.hpp"
#include "sim/knot/throws.hpp"

namespace sim::knot {

namespace {

// Flat throws bend both strands alike; a capsized knot has one straight strand that the other is hitched round. Model
// and simulated knots (docs/knots.md): flat at most 0.19, capsized at least 0.34.
constexpr double least_uneven = 0.25;

bool has_knotted_stretch(const Reading& reading) {
    constexpr int least = 6, cuts = 16;  // a knot that slips is there until its bight is nearly out
    const int step = std::max(1, (reading.passages() - least) / cuts);
    for (int cut = least; cut < reading.passages(); cut += step)
        for (const int first : {0, reading.passages() - cut})
            if (knotted(reading.type(first, cut, true))) return true;
    return false;
}

// Whether cutting the unknotted strand somewhere leaves a knot. Seen from two sides, so that a stretch that only looks
// knotted from one does not count; and not at all where one side shows fewer crossings than a knot has.
bool slips(const std::vector<Vec3>& strand, const Identity& whole, Work& work) {
    std::vector<Reading> views = views_of(strand, work);
    if (views.empty() || views.front().passages() < 6) return false;
    const std::vector<Reading> good = good_ones(std::move(views), whole, 4);
    return std::count_if(good.begin(), good.end(), has_knotted_stretch) >= 2;
}

// A bowline is of one of three types, by where its end leaves the eye. Its eye takes 0.45 to 0.48 of knot and eye
// together in model curves; knots of these types without an eye have a loop of 0.21 at most (docs/knots.md).
bool is_bowline(const std::vector<Vec3>& strand, const Factor& factor) {
    constexpr double least_eye = 0.33;
    if (factor.name != "6_2" && factor.name != "6_3" && factor.name != "8_20") return false;
    const Extent e = extent(strand);
    return e.loop() > least_eye * (e.last - e.first);
}

std::string working_knot(const std::vector<Vec3>& strand, const std::vector<Factor>& factors) {
    if (factors.size() != 1) return "";
    if (factors.front().name == "4_1") return "figure-eight";
    return is_bowline(strand, factors.front()) ? "bowline" : "";
}

std::vector<Vec3> straightened_from_its_end(const std::vector<Vec3>& strand) {
    const Polygons back{{strand.rbegin(), strand.rend()}};
    return reduced(back, {false}, ways_out(back, {false}), most_votes).front();
}

}  // namespace

void read_surgical(const std::vector<Vec3>& strand, const std::vector<Vec3>& few, const Identity& whole, Work& work,
                   Name& name) {
    if (!whole.certain) return;
    if (whole.factors.empty()) {
        if (slips(strand, whole, work)) name.surgical = "slip";
        return;
    }
    std::vector<Throw> throws = throws_of(whole.factors);
    if (throws.size() < whole.factors.size()) {
        name.surgical = working_knot(strand, whole.factors);
        return;
    }
    if (throws.size() > 1) {
        auto ordered = in_order(throws, views_of(few, work), whole);
        // Strands that were straightened may lie so that the order cannot be told, in two of a hundred attitudes; from
        // the other end they come to lie otherwise.
        Work more;
        if (!ordered) ordered = in_order(throws, views_of(straightened_from_its_end(strand), more), whole);
        if (!ordered) return;
        throws = std::move(*ordered);
        name.flat = unevenness(strand) < least_uneven;
    }
    name.throw_list = throws;
    name.throws = notation(throws);
    name.surgical = surgeons_name(name.throws);
    if (!name.flat) name.half_hitches = half_hitches(throws);
}

}  // namespace sim::knot
