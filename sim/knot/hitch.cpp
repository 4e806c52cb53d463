#include "sim/knot/hitch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/geometry/closest_points.hpp"
#include "sim/knot/arc.hpp"
#include "sim/knot/identify.hpp"

namespace sim::knot {

namespace {

using Strand = std::vector<Vec3>;

// A knot that comes of joining the rope's ends to the pole's, or that mirrored, and the type with the rope's ends
// joined to each other. A turn gives the unknot as well, joined the other way; what holds by itself does not.
struct Hitch {
    const char *name, *crosswise, *crosswise_mirrored, *link, *link_mirrored;
    bool turns = false;
};
constexpr std::array<Hitch, 9> hitches{{{"clove hitch", "3_1#3_1", "m3_1#m3_1", "L6a1", "mL6a1"},
                                        {"constrictor", "8_21", "m8_21", "L9n11", "mL9n11"},
                                        {"cow hitch", "3_1#m3_1", "3_1#m3_1", "unlink", "unlink"},
                                        {"prusik", "5_1#m5_1", "5_1#m5_1", "unlink", "unlink"},
                                        {"prusik", "7_1#m7_1", "7_1#m7_1", "unlink", "unlink"},
                                        {"prusik", "9_1#m9_1", "9_1#m9_1", "unlink", "unlink"},
                                        {"single turn", "3_1", "m3_1", "L2a1", "mL2a1", true},
                                        {"round turn", "5_1", "m5_1", "L4a1", "mL4a1", true},
                                        {"round turn", "7_1", "m7_1", "L6a3", "mL6a3", true}}};

Vec3 nearest_on_pole(const Strand& rope, const Strand& pole, bool closed) {
    Vec3 nearest = pole.front();
    double least = -1;
    for (std::size_t i = 0; i + 1 < pole.size() + (closed ? 1 : 0); ++i) {
        for (const Vec3& p : rope) {
            const auto pair = geometry::closest_points(p, p, pole[i], pole[(i + 1) % pole.size()]);
            if (least < 0 || pair.distance_squared < least) least = pair.distance_squared, nearest = pair.on_b;
        }
    }
    return nearest;
}

// Ends that are free go straight on, far beyond everything.
constexpr double far = 8;  // everything lies in the unit box

Strand led_out(Strand strand, bool closed, const Ways& ways) {
    if (closed) return strand;
    if (ways.from_first) strand.insert(strand.begin(), strand.front() + far * *ways.from_first);
    if (ways.from_last) strand.push_back(strand.back() + far * *ways.from_last);
    return strand;
}

// Where a strand comes through a sphere about the origin: in the edge from this vertex, at this share of it.
struct Crossing {
    std::size_t edge;
    double share;
};

std::vector<Crossing> crossings(const Strand& strand, bool closed, double radius) {
    std::vector<Crossing> found;
    for (std::size_t i = 0; i + 1 < strand.size() + (closed ? 1 : 0); ++i) {
        const Vec3 &a = strand[i], along = strand[(i + 1) % strand.size()] - a;
        const double half_b = a.dot(along), c = a.squaredNorm() - radius * radius, square = along.squaredNorm();
        const double discriminant = half_b * half_b - square * c;
        if (discriminant <= 0) continue;
        for (const double sign : {-1.0, 1.0})
            if (const double t = (-half_b + sign * std::sqrt(discriminant)) / square; t >= 0 && t < 1)
                found.push_back({i, t});
    }
    return found;
}

// The one piece of the strand within the sphere, from surface to surface; nothing when it has none or several.
std::optional<Strand> piece_within(const Strand& strand, bool closed, double radius) {
    const auto cuts = crossings(strand, closed, radius);
    if (cuts.size() != 2) return std::nullopt;
    const std::size_t n = strand.size();
    const auto point = [&](const Crossing& c) -> Vec3 {
        return strand[c.edge] + c.share * (strand[(c.edge + 1) % n] - strand[c.edge]);
    };
    const bool starts_outside = strand.front().norm() > radius;
    const Crossing &in = cuts[starts_outside ? 0 : 1], &out = cuts[starts_outside ? 1 : 0];
    if (!starts_outside && !closed) return std::nullopt;
    Strand piece{point(in)};
    for (std::size_t i = in.edge; i != out.edge;) piece.push_back(strand[i = (i + 1) % n]);
    piece.push_back(point(out));
    return piece;
}

struct Ball {
    Strand rope, pole;
    double radius;
};

// The largest ball about the hitch that either strand goes into once and comes out of, the pole on the other side.
std::optional<Ball> ball_about(const Strand& rope, const Strand& pole, bool pole_closed) {
    constexpr double shrink = 0.95, least = 1e-3;  // of the unit box: thinner than any drawing of a hitch in it
    for (double radius = 0.5 * far; radius > least; radius *= shrink) {
        auto rope_piece = piece_within(rope, false, radius), pole_piece = piece_within(pole, pole_closed, radius);
        if (!rope_piece || !pole_piece) continue;
        constexpr double opposite = -0.5;  // cosine: more than 120 degrees apart
        if (pole_piece->front().dot(pole_piece->back()) < opposite * radius * radius)
            return Ball{std::move(*rope_piece), std::move(*pole_piece), radius};
    }
    return std::nullopt;
}

// The rope's ends joined to the pole's, last to first, on spheres around the ball; the arc of larger radius lies over
// the other.
Strand crosswise(const Strand& rope, const Strand& pole, double inner, double outer) {
    Strand polygon = rope;
    const auto join = [&](const Vec3& from, const Vec3& to, double radius) {
        const Vec3 a = radius * from.normalized(), b = radius * to.normalized();
        polygon.push_back(a);
        append_arc(polygon, a, b, radius);
        polygon.push_back(b);
    };
    join(rope.back(), pole.front(), inner);
    polygon.insert(polygon.end(), pole.begin(), pole.end());
    join(pole.back(), rope.front(), outer);
    return polygon;
}

std::vector<Polygons> crosswise(const Ball& ball) {
    std::vector<Polygons> knots;
    const Strand reversed(ball.pole.rbegin(), ball.pole.rend());
    const double one = 2 * ball.radius, other = 4 * ball.radius;  // chords stay outside 0.86 of these
    for (const Strand* pole : {&ball.pole, &reversed})
        for (const auto& [inner, outer] : {std::pair(one, other), std::pair(other, one)})
            knots.push_back({crosswise(ball.rope, *pole, inner, outer)});
    return knots;
}

using Types = std::vector<std::string>;

bool has(const Types& types, const char* type) {
    return std::find(types.begin(), types.end(), type) != types.end();
}

// Round an open pole the type with the rope's ends joined hangs on the side on which they are, so it says nothing
// against a hitch; a turn is nothing else.
std::string shown_by(const Types& types, const std::string& link, bool pole_closed) {
    for (const Hitch& h : hitches) {
        const bool shown =
            (has(types, h.crosswise) || has(types, h.crosswise_mirrored)) && (!h.turns || has(types, "0_1"));
        const bool linked = link == h.link || link == h.link_mirrored || (!h.turns && !pole_closed);
        if (shown && linked) return h.name;
    }
    return "";
}

// What takes many views to become small is looked at last: the other way round may be too large for any, of 14
// crossings for a prusik of three wraps.
std::string shown_by(const std::vector<Polygons>& knots, const std::string& link, bool pole_closed) {
    Types types;
    for (const int views : {1, most_views}) {
        for (const Polygons& knot : knots) {
            Work work;
            const Seen seen = best_view(knot, work, views);
            if (seen.found && small_enough(seen.diagram)) types.push_back(identify(seen.diagram, work).name());
        }
        if (const std::string name = shown_by(types, link, pole_closed); !name.empty()) return name;
    }
    return "";
}

}  // namespace

std::string hitch(const Name& link, const Polygons& rope_and_pole, const std::vector<bool>& closed,
                  const std::vector<Ways>& ways) {
    Strand rope = led_out(rope_and_pole[0], closed[0], ways[0]), pole = led_out(rope_and_pole[1], closed[1], ways[1]);
    const Vec3 centre = nearest_on_pole(rope, pole, closed[1]);
    for (Strand* strand : {&rope, &pole})
        for (Vec3& p : *strand) p -= centre;
    const auto ball = ball_about(rope, pole, closed[1]);
    return ball ? shown_by(crosswise(*ball), link.knot, closed[1]) : "";
}

bool holds_by_itself(const std::string& name) {
    return std::any_of(hitches.begin(), hitches.end(), [&](const Hitch& h) { return !h.turns && name == h.name; });
}

}  // namespace sim::knot
