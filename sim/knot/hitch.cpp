#include "sim/knot/hitch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/knot/arc.hpp"
#include "sim/knot/identify.hpp"

namespace sim::knot {

namespace {

using Strand = std::vector<Vec3>;

// Type with the rope's ends joined to each other, and one of those with them joined to the pole's; either may be all mirrored.
struct Hitch {
    const char *name, *link, *link_mirrored, *crosswise, *crosswise_mirrored;

    bool is_of(const std::string& type) const { return type == link || type == link_mirrored; }
};
constexpr std::array<Hitch, 9> hitches{{{"single turn", "L2a1", "mL2a1", "", ""},
                                        {"round turn", "L4a1", "mL4a1", "", ""},
                                        {"round turn", "L6a3", "mL6a3", "", ""},
                                        {"clove hitch", "L6a1", "mL6a1", "3_1#3_1", "m3_1#m3_1"},
                                        {"constrictor", "L9n11", "mL9n11", "8_21", "m8_21"},
                                        {"cow hitch", "unlink", "unlink", "3_1#m3_1", "3_1#m3_1"},
                                        {"prusik", "unlink", "unlink", "5_1#m5_1", "5_1#m5_1"},
                                        {"prusik", "unlink", "unlink", "7_1#m7_1", "7_1#m7_1"},
                                        {"prusik", "unlink", "unlink", "9_1#m9_1", "9_1#m9_1"}}};

Vec3 nearest_on_pole(const Strand& rope, const Strand& pole, bool closed) {
    Vec3 nearest = pole.front();
    double least = -1;
    for (std::size_t i = 0; i + 1 < pole.size() + (closed ? 1 : 0); ++i) {
        const Vec3 &a = pole[i], along = pole[(i + 1) % pole.size()] - a;
        for (const Vec3& p : rope) {
            const Vec3 on = a + std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
            if (const double d = (p - on).squaredNorm(); least < 0 || d < least) least = d, nearest = on;
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
            if (const double t = (-half_b + sign * std::sqrt(discriminant)) / square; t >= 0 && t < 1) found.push_back({i, t});
    }
    return found;
}

// The one piece of the strand within the sphere, from surface to surface; nothing when it has none or several.
std::optional<Strand> piece_within(const Strand& strand, bool closed, double radius) {
    const auto cuts = crossings(strand, closed, radius);
    if (cuts.size() != 2) return std::nullopt;
    const std::size_t n = strand.size();
    const auto point = [&](const Crossing& c) -> Vec3 { return strand[c.edge] + c.share * (strand[(c.edge + 1) % n] - strand[c.edge]); };
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

// The rope's ends joined to the pole's, last to first, on spheres around the ball; the arc of larger radius lies over the other.
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

// The first hitch of this link that one of the knots shows. What takes many views to become small is looked at last: the other
// way round may be too large for any, of 14 crossings for a prusik of three wraps.
std::string shown_by(const std::string& link, const std::vector<Polygons>& knots) {
    for (const int views : {1, most_views})
        for (const Polygons& knot : knots) {
            Work work;
            const Seen seen = best_view(knot, work, views);
            if (!seen.found || !small_enough(seen.diagram)) continue;
            const std::string type = identify(seen.diagram, work).name();
            for (const Hitch& h : hitches)
                if (h.is_of(link) && (type == h.crosswise || type == h.crosswise_mirrored)) return h.name;
        }
    return "";
}

}  // namespace

std::string hitch(const std::string& link, const Polygons& rope_and_pole, const std::vector<bool>& closed,
                  const std::vector<Ways>& ways) {
    const auto known = std::find_if(hitches.begin(), hitches.end(), [&](const Hitch& h) { return h.is_of(link); });
    if (known == hitches.end()) return "";
    if (!*known->crosswise) return known->name;
    Strand rope = led_out(rope_and_pole[0], closed[0], ways[0]), pole = led_out(rope_and_pole[1], closed[1], ways[1]);
    const Vec3 centre = nearest_on_pole(rope, pole, closed[1]);
    for (Strand* strand : {&rope, &pole})
        for (Vec3& p : *strand) p -= centre;
    const auto ball = ball_about(rope, pole, closed[1]);
    return ball ? shown_by(link, crosswise(*ball)) : "";
}

bool holds_by_itself(const std::string& name) {
    return std::any_of(hitches.begin(), hitches.end(), [&](const Hitch& h) { return *h.crosswise && name == h.name; });
}

}  // namespace sim::knot
