#include "sim/knot/namer.hpp"

#include <algorithm>
#include <map>

#include "sim/knot/diagram.hpp"
#include "sim/knot/homfly.hpp"
#include "sim/knot/reduce.hpp"
#include "sim/knot/table.hpp"

namespace sim::knot {

namespace {

// A diagram of at most this many crossings can only show a type of the table; with more, others share the polynomials.
constexpr int table_crossings = 10;
// Skein steps for one factor: a hundred times what a factor of ten crossings takes.
constexpr int skein_budget = 20000;
constexpr int quick_views = 6, stubborn_views = 60;

int worst_factor(const std::vector<Diagram>& factors) {
    int worst = 0;
    for (const Diagram& f : factors) worst = std::max(worst, f.crossings());
    return worst;
}

int total(const std::vector<Diagram>& factors) {
    int sum = 0;
    for (const Diagram& f : factors) sum += f.crossings();
    return sum;
}

// Looks from several sides and keeps the simplest picture; looks longer when none fits the table.
std::vector<Diagram> simplest_factors(const std::vector<Vec3>& polygon) {
    std::vector<Diagram> best = split(project(polygon, 0));
    for (int view = 1; view < (worst_factor(best) > table_crossings ? stubborn_views : quick_views); ++view) {
        if (total(best) <= 3) break;  // No smaller picture of a knot; fewer than three is none.
        std::vector<Diagram> factors = split(project(polygon, view));
        if (total(factors) < total(best)) best = std::move(factors);
    }
    return best;
}

// Adds what one visible factor is. Without a proof the name stays open and its candidates are kept.
void add_factor(const Diagram& diagram, Name& name, std::vector<std::string>& open) {
    const std::optional<Polynomial> polynomial = homfly(diagram, skein_budget);
    if (!polynomial) {
        name.certain = false;
        return;
    }
    std::vector<Entry> types = types_with(*polynomial);
    std::erase_if(types, [&](const Entry& type) { return type.crossings > diagram.crossings(); });
    const bool fits = diagram.crossings() <= table_crossings;
    if (types.size() == 1 && (fits || (types.front().factors.empty() && diagram.crossings() <= 12))) {
        for (const Factor& f : types.front().factors) name.factors.push_back(f);
        return;
    }
    name.certain = false;
    for (const Entry& type : types) open.push_back(type.name());
}

Name name_closed(const std::vector<Vec3>& polygon) {
    Name name;
    name.crossings_projected = project(polygon, 0).crossings();
    const std::vector<Diagram> factors = simplest_factors(drop_free_vertices(polygon));
    name.crossings_reduced = total(factors);
    std::vector<std::string> open;
    for (const Diagram& factor : factors) add_factor(factor, name, open);
    sort_factors(name.factors);
    name.knot = name.certain ? joined_name(name.factors) : "unknown";
    if (!name.certain && factors.size() == 1) name.candidates = open;
    return name;
}

}  // namespace

Name name_knot(const std::vector<Vec3>& curve, bool closed) {
    std::vector<Vec3> points = general_position(curve);
    if (closed) return name_closed(points);
    const std::optional<Vec3> first = outward(points, 0), last = outward(points, points.size() - 1);
    return name_closed(join_ends(points, first.value_or(Vec3::UnitX()), last.value_or(Vec3::UnitX())));
}

}  // namespace sim::knot
