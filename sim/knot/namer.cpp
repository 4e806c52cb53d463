#include "sim/knot/namer.hpp"

#include <algorithm>
#include <map>

#include "sim/knot/colour.hpp"
#include "sim/knot/diagram.hpp"
#include "sim/knot/homfly.hpp"
#include "sim/knot/reduce.hpp"
#include "sim/knot/surgical.hpp"
#include "sim/knot/table.hpp"

namespace sim::knot {

namespace {

// A diagram of at most this many crossings can only show a type of the table; with more, others share the polynomials.
constexpr int table_crossings = 10;
// Skein steps for one factor: a hundred times what a factor of ten crossings takes.
constexpr int skein_budget = 20000;
// Beyond these a picture is not simplified, and a factor gets no polynomial: the answer would come too late.
constexpr int hopeless_crossings = 200, worth_a_try = 20;
constexpr int ballots = 12;  // Ways out for a buried end.
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
    Diagram first = project(polygon, 0);
    if (first.crossings() > hopeless_crossings) return {std::move(first)};
    std::vector<Diagram> best = split(std::move(first));
    for (int view = 1; view < (worst_factor(best) > table_crossings ? stubborn_views : quick_views); ++view) {
        if (total(best) <= 3) break;  // No smaller picture of a knot; fewer than three is none.
        std::vector<Diagram> factors = split(project(polygon, view));
        if (total(factors) < total(best)) best = std::move(factors);
    }
    return best;
}

// Adds what one visible factor is. Without a proof the name stays open and its candidates are kept.
void add_factor(const Diagram& diagram, Name& name, std::vector<std::string>& open) {
    if (diagram.crossings() > worth_a_try) {
        name.certain = false;
        return;
    }
    const std::optional<Polynomial> polynomial = homfly(diagram, skein_budget);
    if (!polynomial) {
        name.certain = false;
        return;
    }
    std::vector<Entry> types = types_with(*polynomial);
    std::erase_if(types, [&](const Entry& type) { return type.crossings > diagram.crossings(); });
    if (types.size() > 1 && diagram.crossings() <= table_crossings) {
        const Colours seen = colours(diagram);  // A rope has no preferred direction: either vector will do.
        std::erase_if(types, [&](const Entry& type) { return seen != type.colours && seen != type.reverse_colours; });
    }
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
    if (!name.certain && factors.size() == 1) std::sort(open.begin(), open.end()), name.candidates = open;
    return name;
}

// Straight parallel ways out, by vote: an end inside the coils may belong to one knot or another, and only a clear
// majority is a name.
Name vote(const std::vector<Vec3>& points) {
    std::map<std::string, std::pair<int, Name>> votes;
    for (int view = 0; view < ballots; ++view) {
        const Vec3 out = view_direction(view);
        const Name name = name_closed(join_ends(points, out, out));
        auto& [count, first] = votes[name.knot];
        if (count++ == 0) first = name;
    }
    const auto fewer = [](const auto& a, const auto& b) { return a.second.first < b.second.first; };
    Name winner = std::max_element(votes.begin(), votes.end(), fewer)->second.second;
    const int share = votes[winner.knot].first;
    if (share == ballots) return winner;
    winner.certain = false;
    winner.candidates.clear();
    for (const auto& [knot, count_and_name] : votes) winner.candidates.push_back(knot);
    if (10 * share < 7 * ballots) winner.knot = "unknown", winner.factors.clear();
    return winner;
}

Name name_open(const std::vector<Vec3>& points) {
    const std::optional<Vec3> first = outward(points, 0), last = outward(points, points.size() - 1);
    return first && last ? name_closed(join_ends(points, *first, *last)) : vote(points);
}

// A piece of a rope, for reading only: one way out must do for a buried end.
Name name_piece(const std::vector<Vec3>& piece) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& v : piece) middle += v / static_cast<double>(piece.size());
    const auto way_out = [&](size_t end) {
        const std::optional<Vec3> free = outward(piece, end);
        return free ? *free : (piece[end] - middle).normalized();
    };
    return name_closed(join_ends(piece, way_out(0), way_out(piece.size() - 1)));
}

}  // namespace

Name name_knot(const std::vector<Vec3>& curve, bool closed) {
    const std::vector<Vec3> points = general_position(curve);
    if (closed) return name_closed(points);
    Name name = name_open(points);
    read_throws(points, name_piece, name);
    return name;
}

}  // namespace sim::knot
