#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <span>

#include "sim/knot/hitch.hpp"
#include "sim/knot/homfly.hpp"
#include "sim/knot/identify.hpp"
#include "sim/knot/surgical.hpp"
#include "sim/knot/table.hpp"

namespace sim::knot {

namespace {

// Two polynomials, one per relative direction of the two strands; their order does not count.
struct Pair {
    Polynomial one, other;
    bool operator==(const Pair& o) const {
        return (one == o.one && other == o.other) || (one == o.other && other == o.one);
    }
};

struct Part {
    std::string name;
    bool certain = true;
    int crossings = 0;
};

std::string with_factors(const std::string& link, const std::vector<Factor>& factors) {
    return factors.empty() ? link : link + "#" + name_of(factors);
}

// A two-strand piece without visible summands. Summands that are hidden in it are tried as `hidden`.
Part two_strands(const Diagram& piece, const std::vector<Factor>& visible, const std::vector<Factor>& hidden,
                 const Polynomial& of_hidden, Work& work) {
    // Prime links to 9 crossings are told apart by the pair, with their mirror images.
    constexpr int certain_crossings = 9;
    Part part{"unknown", piece.crossings() <= certain_crossings, piece.crossings()};
    const auto one = homfly(piece, work), other = homfly(reversed(piece, 1), work);
    if (!one || !other) return {"unknown", false, piece.crossings()};
    const Pair pair{*one, *other};
    for (const KnownLink& link : known_links()) {
        if (pair == Pair{link.homfly, link.homfly_second_reversed}) {
            return {with_factors(link.name, visible), part.certain, link.crossings};
        }
        if (hidden.empty()) continue;
        if (pair == Pair{product(link.homfly, of_hidden), product(link.homfly_second_reversed, of_hidden)}) {
            std::vector<Factor> all = visible;
            all.insert(all.end(), hidden.begin(), hidden.end());
            return {with_factors(link.name, all), part.certain, piece.crossings()};
        }
    }
    if (pair == Pair{unlink(2), unlink(2)}) return {"unlink", part.certain, 0};
    part.certain = false;
    return part;
}

Polynomial polynomial_of(const std::vector<Factor>& factors) {
    Polynomial p{{0, 0, 1}};
    for (const Factor& f : factors) p = product(p, listed_homfly(f));
    return p;
}

std::string joined_parts(std::vector<Part> parts) {
    const bool all_circles =
        std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.name == "0_1" || p.name == "unlink"; });
    if (parts.size() > 1 && all_circles) return "unlink";
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.name < b.name; });
    std::string name;
    for (const Part& p : parts) name += (name.empty() ? "" : "|") + p.name;
    return name.find("unknown") == std::string::npos ? name : "unknown";
}

Name named_link(Diagram diagram, const std::vector<Identity>& of_component, Work& work) {
    Name name;
    if (diagram.crossings() > 100) {  // as for knots: more than can be taken further
        name.knot = "unknown", name.certain = false, name.crossings_reduced = diagram.crossings();
        return name;
    }
    std::vector<std::vector<Factor>> visible(diagram.strands.size());
    bool certain = true, known = true;
    int crossings = 0;
    for (const Summand& summand : cut_summands(diagram)) {
        const Identity identity = identify(summand.diagram, work);
        auto& factors = visible[static_cast<std::size_t>(summand.strand)];
        factors.insert(factors.end(), identity.factors.begin(), identity.factors.end());
        certain = certain && identity.certain;
        crossings += identity.crossings;
        known = known && identity.known;
    }
    std::vector<Part> parts;
    for (const Piece& piece : split_pieces(diagram)) {
        std::vector<Factor> seen, all;
        for (const int s : piece.strands) {
            const auto i = static_cast<std::size_t>(s);
            seen.insert(seen.end(), visible[i].begin(), visible[i].end());
            all.insert(all.end(), of_component[i].factors.begin(), of_component[i].factors.end());
        }
        const std::vector<Factor> hidden = taken_from(all, seen);
        if (piece.strands.size() == 1) {
            const Identity rest = identify(piece.diagram, work);
            seen.insert(seen.end(), rest.factors.begin(), rest.factors.end());
            parts.push_back({rest.known ? name_of(seen) : "unknown", rest.certain, rest.crossings});
        } else if (piece.strands.size() == 2) {
            parts.push_back(two_strands(piece.diagram, seen, hidden, polynomial_of(hidden), work));
        } else {
            parts.push_back({"unknown", false, piece.diagram.crossings()});
        }
        name.factors.insert(name.factors.end(), seen.begin(), seen.end());
    }
    for (const Part& part : parts) certain = certain && part.certain, crossings += part.crossings;
    sort_factors(name.factors);
    name.knot = known ? joined_parts(parts) : "unknown";
    name.certain = certain && name.knot != "unknown";
    name.crossings_reduced = crossings;
    if (!name.certain && name.knot != "unknown") name.candidates = {name.knot};
    return name;
}

Identity identity_of(const std::vector<Vec3>& polygon, Work& work) {
    const Seen alone = best_view({polygon}, work);
    if (alone.found) return identify(alone.diagram, work);
    Identity unknown;
    unknown.known = unknown.certain = false;
    return unknown;
}

struct Closing {
    LinkName link;
    Identity first;
};

Closing named_closing(const Polygons& polygons, Work& work) {
    Closing closing;
    std::vector<Identity> of_component;
    for (const auto& polygon : polygons) {
        of_component.push_back(identity_of(polygon, work));
        closing.link.component_knots.push_back(of_component.back().name());
    }
    closing.first = of_component.front();
    const Seen seen = best_view(polygons, work);
    Name& name = closing.link.name;
    if (!seen.found) {
        name.knot = "unknown", name.certain = false, name.crossings_reduced = -1;
        return closing;
    }
    name = named_link(seen.diagram, of_component, work);
    name.crossings_projected = seen.projected;
    const int n = static_cast<int>(polygons.size());
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j)
            closing.link.linking_numbers.push_back(std::abs(linking_number(seen.diagram, i, j)));
    for (const Identity& identity : of_component) name.certain = name.certain && identity.certain;
    return closing;
}

// Round any of several objects.
struct Hitched {
    std::string hitch;
    int round = -1;
};
Hitched first_hitch(const Component& rope, std::span<const Component> objects) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const std::string hitch = name_link({rope, objects[i]}).name.surgical;
        if (holds_by_itself(hitch)) return {hitch, static_cast<int>(i)};
    }
    return {};
}

}  // namespace

LinkName name_link(const std::vector<Component>& components) {
    assert(!components.empty());
    for ([[maybe_unused]] const Component& c : components) assert(c.vertices.size() >= 2 && "a curve of two vertices");
    if (components.size() == 1) {
        const Name name = name_knot(components.front().vertices, components.front().closed);
        return {name, {name.knot}, {}};
    }
    const auto strands = in_general_position(components);
    std::vector<bool> closed;
    for (const Component& c : components) closed.push_back(c.closed);
    constexpr int unanimous = 8;
    const std::vector<Ways> ways = ways_out(strands, closed);
    const bool free = all_free(ways, closed);
    const Polygons few = reduced(strands, closed, ways, free ? 1 : unanimous);
    Work work;
    Closing closing = named_closing(close_outside(few, closed, ways, 0), work);
    Name& name = closing.link.name;
    // Buried ends: certain only when eight ways of leading them out give the same.
    std::vector<std::string> candidates{name.knot};
    for (int vote = 1; vote < unanimous && !free; ++vote) {
        const LinkName other = named_closing(close_outside(few, closed, ways, vote), work).link;
        if (std::find(candidates.begin(), candidates.end(), other.name.knot) == candidates.end())
            candidates.push_back(other.name.knot);
    }
    if (free && either_way(strands, closed, ways))
        candidates.push_back(named_closing(close_outside(few, closed, ways, 0, true), work).link.name.knot);
    if (std::count(candidates.begin(), candidates.end(), name.knot) < static_cast<std::ptrdiff_t>(candidates.size()))
        name.certain = false, name.candidates = candidates;
    if (components.front().closed || !closing.first.known) return closing.link;
    if (closing.first.factors.empty())
        name.surgical = components.size() == 2 ? hitch(name, strands, closed, ways)
                                               : first_hitch(components[0], std::span(components).subspan(1)).hitch;
    if (name.surgical.empty()) read_surgical(strands.front(), few.front(), closing.first, work, name);
    return closing.link;
}

Tied name_among(const std::vector<Vec3>& thread, const std::vector<std::vector<Vec3>>& objects) {
    Tied tied{name_knot(thread), -1};
    if (tied.name.knot != "0_1" || !tied.name.certain) return tied;
    std::vector<Component> cores;
    for (const auto& object : objects) cores.push_back({object, false});
    const Hitched hitched = first_hitch({thread, false}, cores);
    if (hitched.round >= 0) tied.name.surgical = hitched.hitch, tied.round = hitched.round;
    return tied;
}

}  // namespace sim::knot
