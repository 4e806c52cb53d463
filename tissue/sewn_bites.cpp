#include <algorithm>
#include <cmath>

#include "sim/geometry/closest_points.hpp"
#include "tissue/join_parts.hpp"

namespace tissue {

namespace {

struct OnThread {
    double along, distance;
};

OnThread place_on(std::span<const Vec3> thread, const Vec3& point) {
    double before = 0, along = 0, least = -1;
    for (std::size_t i = 0; i + 1 < thread.size(); ++i) {
        const double length = (thread[i + 1] - thread[i]).norm();
        const auto pair = sim::geometry::closest_points(thread[i], thread[i + 1], point, point);
        if (least < 0 || pair.distance_squared < least) least = pair.distance_squared, along = before + pair.s * length;
        before += length;
    }
    return {along, std::sqrt(std::max(0.0, least))};
}

// The larger of both principal stretches of a face: the root of the larger eigenvalue of C = F^T F.
double stretch(const Mesh& rest, std::span<const Vec3> nodes, int face) {
    const auto& corners = rest.faces[static_cast<std::size_t>(face)].nodes;
    const auto at = [&](std::span<const Vec3> of, std::size_t k) -> const Vec3& {
        return of[static_cast<std::size_t>(corners[k])];
    };
    const auto edge = [&](std::span<const Vec3> of, std::size_t k) { return Vec3(at(of, k) - at(of, 0)); };
    const Vec3 a = edge(rest.nodes, 1), b = edge(rest.nodes, 2), x = a.normalized(),
               y = a.cross(b).cross(a).normalized();
    const Vec3 fx = edge(nodes, 1) / a.norm(), fy = (edge(nodes, 2) - b.dot(x) * fx) / b.dot(y);
    const double xx = fx.squaredNorm(), yy = fy.squaredNorm(), xy = fx.dot(fy), half = 0.5 * (xx - yy);
    return std::sqrt(0.5 * (xx + yy) + std::sqrt(half * half + xy * xy));
}

// Measures one bite. `far` is its end on the outer side, or where it has none the needle's entry, `near` the other one.
class Measuring {
  public:
    Measuring(const SewnEnd& end, const Bite& bite) : end_(end), bite_(bite), rest_(end.vessel.rest) {
        const bool entry = bite.entry.side == Side::outer, exit = bite.exit.side == Side::outer;
        const bool turned = entry && exit ? to_outer_rim(bite.exit).distance > to_outer_rim(bite.entry).distance : exit;
        far_ = turned ? &bite.exit : &bite.entry, near_ = turned ? &bite.entry : &bite.exit;
    }

    void place(SewnBite& sewn, const Around& around) const {
        const RimPoint rim = to_outer_rim(*far_);
        sewn.place = rim.place;
        sewn.angle = around.angle(end_, rim.place);
        sewn.through = (at_rest(*far_) - at_rest(*near_)).norm();
        if (near_->side == Side::outer) sewn.inside = to_outer_rim(*near_).distance;
        if (near_->side == Side::inner) sewn.inside = nearest(end_.inner, rest_, at_rest(*near_)).distance;
        if (far_->side != Side::outer || !(rim.distance > 0)) return;
        sewn.size = rim.distance;
        sewn.strain = 1 - (now(*far_) - position(end_.outer, rim.place, end_.nodes())).norm() / rim.distance;
    }

    void holes(SewnBite& sewn) const {
        const Skin& skin = end_.vessel.skin;
        sewn.hole_radius = std::min(skin.radius(bite_.entry.hole), skin.radius(bite_.exit.hole));
        for (const int hole : {bite_.entry.hole, bite_.exit.hole})
            sewn.hole =
                std::max(sewn.hole, 2 * skin.radius(hole) * stretch(rest_, end_.nodes(), skin.face_of_hole(hole)));
    }

    void thread(SewnBite& sewn, std::span<const std::vector<Vec3>> threads, double diameter) const {
        sewn.thread = thread_in(bite_, end_.vessel.skin, threads, diameter);
        if (sewn.thread < 0) return;
        const auto& through = threads[static_cast<std::size_t>(sewn.thread)];
        sewn.outer_along = place_on(through, now(*far_)).along;
        sewn.along = 0.5 * (sewn.outer_along + place_on(through, now(*near_)).along);
    }

  private:
    Vec3 at_rest(const BiteEnd& of) const { return position(of.at, rest_, rest_.nodes); }
    Vec3 now(const BiteEnd& of) const { return position(of.at, rest_, end_.nodes()); }
    RimPoint to_outer_rim(const BiteEnd& of) const { return nearest(end_.outer, rest_, at_rest(of)); }

    const SewnEnd& end_;
    const Bite& bite_;
    const Mesh& rest_;
    const BiteEnd *far_, *near_;
};

}  // namespace

int thread_in(const Bite& bite, const Skin& skin, std::span<const std::vector<Vec3>> threads, double diameter) {
    const auto off = [&](std::span<const Vec3> thread, const BiteEnd& end) {
        return place_on(thread, skin.centre(end.hole)).distance / (2 * skin.radius(end.hole) + diameter);
    };
    double best = 1;
    int found = -1;
    for (std::size_t i = 0; i < threads.size(); ++i) {
        if (threads[i].size() < 2) continue;
        const double farther = std::max(off(threads[i], bite.entry), off(threads[i], bite.exit));
        if (farther <= best) best = farther, found = static_cast<int>(i);
    }
    return found;
}

double Around::angle(const SewnEnd& end, double place) const {
    const Mesh& rest = end.vessel.rest;
    const Vec3 out = position(end.outer, place, rest.nodes) - middle(end.outer, rest.nodes);
    return sim::geometry::portable_atan2(out.dot(y), out.dot(x));
}

std::vector<SewnBite> sewn_bites(const SewnEnd& end, int number, const Around& around,
                                 std::span<const std::vector<Vec3>> threads, double diameter) {
    std::vector<SewnBite> found;
    for (std::size_t i = 0; i < end.vessel.bites.size(); ++i) {
        const Bite& bite = end.vessel.bites[i];
        if (bite.state != BiteState::open) continue;
        SewnBite sewn{.vessel = number,
                      .bite = static_cast<int>(i),
                      .pass = bite.pass,
                      .partial = bite.partial(),
                      .both_walls = bite.both_walls,
                      .depth = bite.depth,
                      .torn = bite.torn};
        const Measuring measuring(end, bite);
        measuring.place(sewn, around);
        measuring.holes(sewn);
        measuring.thread(sewn, threads, diameter);
        found.push_back(sewn);
    }
    return found;
}

}  // namespace tissue
