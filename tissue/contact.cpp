// Tools and needles against a wall, by penalty forces.
//
// Method: of each triangle near a capsule the place nearest to the capsule's axis is pushed out, as hard as it is deep;
// the force falls as the wall gives way (PointForce::stiffness), so that a stiff penalty stays stable under implicit
// Euler. Friction is a spring from where the capsule was, capped by Coulomb's law. Cost: one distance for each triangle
// that is near.
#include "tissue/contact.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/geometry/closest_points.hpp"

namespace tissue {

void CapsuleContact::find(const Skin& skin, const Capsule& capsule, const Capsule& before) {
    assert(capsule.radius > 0 && "a capsule that is not empty");
    near_.clear(), places_.clear();
    const Vec3 gone_a = capsule.a - before.a, gone_b = capsule.b - before.b;
    Box around;
    for (const Vec3* end : {&capsule.a, &capsule.b, &before.a, &before.b}) around.include(*end);
    skin.near(around.grown(capsule.radius), near_);
    for (const int i : near_) {
        const auto pair = sim::geometry::closest_points(capsule.a, capsule.b, skin[i]);
        const Vec3 up = skin.normal(i), off = pair.on_b - pair.on_a;
        const double far = std::sqrt(pair.distance_squared), height = -off.dot(up);
        const bool outside = far > 0 && height > 0;
        if (outside && far >= capsule.radius) continue;
        // Below: over its inside, no deeper than it came in this step and half of the radius; where the axis goes
        // through a triangle its deeper end counts.
        const double below = far > 0 ? height : std::min(up.dot(capsule.a - pair.on_b), up.dot(capsule.b - pair.on_b));
        const double came = std::min(
            4 * capsule.radius, std::max({0.0, -up.dot(gone_a), -up.dot(gone_b)}));  // what jumps further is not met
        if (!outside && (below < -0.5 * capsule.radius - came || -height < 0.9 * far)) continue;
        const double tiny = 1e-6 * capsule.radius;  // neighbours that share the place nearest to the axis
        if (std::any_of(places_.begin(), places_.end(),
                        [&](const Place& p) { return (p.at - pair.on_b).squaredNorm() < tiny * tiny; }))
            continue;
        places_.push_back(
            {i, pair.on_b, outside ? Vec3(off / far) : Vec3(-up), pair.s, capsule.radius - (outside ? far : below)});
    }
}

void CapsuleContact::press(const Skin& skin, const Capsule& now, const Capsule& before,
                           std::vector<PointForce>& forces) {
    find(skin, now, before);
    for (const auto& [triangle, at, direction, along, depth] : places_) {
        const MaterialPoint point = skin.point(triangle, weights_in(skin[triangle], at));
        forces.push_back({point, def_.stiffness * depth * direction, def_.stiffness, direction});
        const Vec3 gone = (1 - along) * (now.a - before.a) + along * (now.b - before.b),
                   across = gone - gone.dot(direction) * direction;
        const double far = across.norm(), most = def_.friction * def_.stiffness * depth;
        if (most == 0) continue;
        const double stiffness = far * def_.stiffness > most ? most / far : def_.stiffness;
        forces.push_back({point, stiffness * across, stiffness});
    }
}

Vec3 CapsuleContact::force(const Skin& skin, const Capsule& capsule) {
    find(skin, capsule, capsule);
    Vec3 sum = Vec3::Zero();
    for (const Place& place : places_) sum -= def_.stiffness * place.depth * place.direction;
    return sum;
}

}  // namespace tissue
