#include "sim/knot/identify.hpp"

#include <algorithm>
#include <utility>

#include "sim/knot/colouring.hpp"
#include "sim/knot/loosen.hpp"
#include "sim/knot/projection.hpp"
#include "sim/knot/table.hpp"

namespace sim::knot {

namespace {

// A diagram of at most 10 crossings is of a type in the table, and polynomial and colours tell those apart. The unknot
// is also certain up to 24 crossings: no other knot of that size has its Jones polynomial (Tuzun and Sikora 2021).
constexpr int certain_crossings = 10, certain_unknot_crossings = 24;

// Beyond this a diagram is not taken further. Of a tangle of so many at first sight no other view has ever brought it
// to a name.
constexpr int hopeless_crossings = 100, tangled_crossings = 300;

// Diagrams that are nearly small enough after a few views are loosened, which takes away few crossings.
constexpr int stubborn_crossings = 16, few_views = 1;

bool fits(const Diagram& knot, Group group, const std::vector<std::vector<int>>& vectors) {
    const auto found = colouring_vector(knot, group);
    return !found || std::find(vectors.begin(), vectors.end(), *found) != vectors.end();
}

// One summand that does not visibly split further.
Identity identify_summand(const Diagram& knot, Work& work) {
    Identity identity;
    identity.crossings = knot.crossings();
    if (knot.crossings() == 0) return identity;
    const auto polynomial = homfly(knot, work);
    std::vector<const KnownKnot*> fitting;
    if (polynomial) fitting = knots_with(*polynomial);
    if (fitting.size() > 1) std::erase_if(fitting, [&](auto* k) { return !fits(knot, Group::psl27, k->psl27); });
    if (fitting.size() > 1) std::erase_if(fitting, [&](auto* k) { return !fits(knot, Group::a5, k->a5); });
    identity.known = fitting.size() == 1;
    identity.certain = knot.crossings() <= certain_crossings ||
                       (identity.known && fitting[0]->crossings == 0 && knot.crossings() <= certain_unknot_crossings);
    if (identity.known) {
        identity.factors = fitting[0]->factors;
        identity.crossings = fitting[0]->crossings;
    }
    if (!identity.certain || !identity.known)
        for (const auto* k : fitting) identity.candidates.push_back(name_of(k->factors));
    identity.certain = identity.certain && identity.known;
    return identity;
}

void add(Identity& whole, const Identity& part) {
    whole.factors.insert(whole.factors.end(), part.factors.begin(), part.factors.end());
    whole.known = whole.known && part.known;
    whole.certain = whole.certain && part.certain;
    whole.crossings += part.crossings;
}

}  // namespace

std::string Identity::name() const {
    return known ? name_of(factors) : "unknown";
}

bool Identity::operator==(const Identity& o) const {
    return known == o.known && factors.size() == o.factors.size() && name() == o.name();
}

static int largest(const std::vector<Summand>& summands) {
    int most = 0;
    for (const Summand& summand : summands) most = std::max(most, summand.diagram.crossings());
    return most;
}

Identity identify(Diagram knot, Work& work) {
    simplify(knot);
    Identity whole;
    whole.crossings = knot.crossings();
    std::vector<Summand> summands;
    if (knot.crossings() <= tangled_crossings) summands = cut_summands(knot);
    if (whole.crossings > tangled_crossings || largest(summands) > hopeless_crossings) {
        whole.known = whole.certain = false;
        return whole;
    }
    whole.crossings = 0;
    std::vector<Identity> parts;
    for (const Summand& summand : summands) parts.push_back(identify_summand(summand.diagram, work));
    for (const Identity& part : parts) add(whole, part);
    sort_factors(whole.factors);
    if (!whole.certain && whole.known) whole.candidates = {whole.name()};
    if (!whole.known && parts.size() == 1) whole.candidates = parts.front().candidates;
    return whole;
}

bool small_enough(Diagram diagram) {
    const std::vector<Summand> summands = cut_summands(diagram);
    if (largest(summands) > certain_crossings) return false;
    const auto pieces = split_pieces(diagram);
    // The table of links ends at nine crossings.
    return std::all_of(pieces.begin(), pieces.end(),
                       [](const Piece& p) { return p.diagram.crossings() < certain_crossings; });
}

Seen best_view(Polygons polygons, Work& work, int views) {
    constexpr int most_vertices = 3000, most_crossings = 3000;
    Seen best;
    bool loosened = false;
    drop_empty_triangles(polygons);
    std::size_t vertices = 0;
    for (const auto& polygon : polygons) vertices += polygon.size();
    for (int i = 0; i < views && vertices <= most_vertices && (i == 0 || !work.is_spent()); ++i) {
        auto diagram = project(polygons, direction(i), most_crossings);
        if (!diagram) continue;
        if (diagram->crossings() > most_crossings) break;  // others would show as many
        if (!best.found) best.projected = diagram->crossings();
        work.spend_on_simplifying(*diagram);
        simplify(*diagram);
        if (!best.found || diagram->crossings() < best.diagram.crossings()) best.diagram = std::move(*diagram);
        best.found = true;
        const bool hopeless =
            best.diagram.crossings() > hopeless_crossings && (i >= few_views || best.projected > tangled_crossings);
        if (hopeless || small_enough(best.diagram)) break;
        if (i < few_views || std::exchange(loosened, true)) continue;
        while (best.diagram.crossings() <= stubborn_crossings && !small_enough(best.diagram) &&
               loosen(best.diagram, work)) {
        }
        if (small_enough(best.diagram)) break;
    }
    return best;
}

}  // namespace sim::knot
