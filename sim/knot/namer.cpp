#include "sim/knot/namer.hpp"

#include <algorithm>
#include <cassert>
#include <map>

#include "sim/knot/identify.hpp"
#include "sim/knot/surgical.hpp"
#include "sim/knot/table.hpp"

namespace sim::knot {

namespace {

Name named(const Seen& seen, Work& work) {
    Name name;
    name.crossings_projected = seen.projected;
    Identity identity;
    if (seen.found) identity = identify(seen.diagram, work);
    name.certain = seen.found && identity.certain;
    name.knot = seen.found ? identity.name() : "unknown";
    if (identity.known) name.factors = identity.factors;
    name.candidates = identity.candidates;
    name.crossings_reduced = seen.found ? identity.crossings : -1;
    return name;
}

// Types found over several ways of leading out buried ends. Eight that agree are enough.
constexpr int unanimous = 8;

Name voted(const Polygons& strands, const std::vector<bool>& closed, const std::vector<Ways>& ways, Work& work) {
    std::map<std::string, int> share;
    std::map<std::string, Name> first;
    int votes = 0;
    for (; votes < most_votes && !(votes >= unanimous && share.size() == 1) && !work.is_spent(); ++votes) {
        const Name name = named(best_view(close_outside(strands, closed, ways, votes), work), work);
        ++share[name.knot];
        first.emplace(name.knot, name);
    }
    std::vector<std::pair<int, std::string>> ranking;
    for (const auto& [knot, count] : share) ranking.emplace_back(-count, knot);
    std::sort(ranking.begin(), ranking.end());
    Name best = first[ranking.front().second];
    best.certain = best.certain && votes >= unanimous;
    if (ranking.size() > 1) {
        best.certain = false;
        best.candidates.clear();
        for (const auto& [count, knot] : ranking) best.candidates.push_back(knot);
    }
    return best;
}

}  // namespace

Name name_knot(const std::vector<Vec3>& curve, bool closed) {
    assert(curve.size() >= 2 && "a curve of at least two vertices");
    assert(std::all_of(curve.begin(), curve.end(), [](const Vec3& v) { return v.allFinite(); }));
    const Polygons strands = in_general_position({{curve, closed}});
    const std::vector<Ways> ways = ways_out(strands, {closed});
    const bool free = all_free(ways, {closed});
    const Polygons few = reduced(strands, {closed}, ways, free ? 1 : most_votes);
    Work work;
    Name name =
        free ? named(best_view(close_outside(few, {closed}, ways, 0), work), work) : voted(few, {closed}, ways, work);
    if (closed || name.knot == "unknown") return name;
    Identity whole;
    whole.factors = name.factors, whole.certain = name.certain;
    read_surgical(strands.front(), few.front(), whole, work, name);
    return name;
}

}  // namespace sim::knot
