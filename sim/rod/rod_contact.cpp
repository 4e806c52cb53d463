#include <algorithm>

#include "sim/geometry/closest_points.hpp"
#include "sim/rod/rod.hpp"

namespace sim::rod {

using Block = ChainMatrix::Block;

Vec3 Rod::from_axis(const Touch& touch, const Vec3& x) const {
    const Capsule& c = bodies_[static_cast<std::size_t>(touch.body)].to;
    return x - geometry::closest_points(x, x, c.a, c.b).on_b;
}

// Augmented Lagrangian: nothing where it is open.
Rod::Pressed Rod::pressed(const Touch& touch, const Vec3& x) const {
    const Vec3 away = from_axis(touch, x), moved = x - touch.anchor;
    const double distance = away.norm(),
                 thickness = bodies_[static_cast<std::size_t>(touch.body)].to.radius + def_.radius;
    const Vec3 normal = away / distance;
    return {std::max(0.0, touch.push + stiff_ * (thickness - distance)), normal, moved - moved.dot(normal) * normal};
}

// Nodes within a diameter of a body. A contact that was there before keeps its push and its anchor, which goes with the
// body.
void Rod::find_touches(std::span<const MovingCapsule> bodies) {
    bodies_.assign(bodies.begin(), bodies.end());
    std::vector<Touch> before = std::move(now_.touches);
    now_.touches.clear();
    for (std::size_t i = 0; i < now_.nodes.size(); ++i)
        for (std::size_t b = 0; b < bodies_.size() && !held_[i]; ++b) {
            Touch touch{static_cast<int>(i), static_cast<int>(b), 0, now_.nodes[i]};
            const Vec3 away = from_axis(touch, now_.nodes[i]);
            if (away.norm() > bodies_[b].to.radius + 3 * def_.radius) continue;
            const auto known = std::find_if(before.begin(), before.end(), [&](const Touch& t) {
                return t.node == touch.node && t.body == touch.body;
            });
            if (known != before.end()) touch = *known, touch.anchor += bodies_[b].to.a - bodies_[b].from.a;
            now_.touches.push_back(touch);
        }
}

// Coulomb's cone about the push at the start of the step: sticks to its anchor as by a spring, slips at the limit.
void Rod::add_contact() {
    for (Touch& touch : now_.touches) {
        const auto i = static_cast<std::size_t>(touch.node);
        const auto [push, normal, slip] = pressed(touch, now_.nodes[i]);
        touch.limit = def_.friction * push;
        if (push == 0) continue;
        const Block across = Block::Identity() - normal * normal.transpose();
        force_[i] += push * normal;
        // Where the body curves away from under the node the push turns with it; that would make the matrix not
        // positive.
        matrix_.add(i, i, stiff_ * normal * normal.transpose());
        if (stiff_ * slip.norm() <= touch.limit) {
            force_[i] -= stiff_ * slip;
            matrix_.add(i, i, stiff_ * across);
        } else {
            const Vec3 along = slip.normalized();
            force_[i] -= touch.limit * along;
            matrix_.add(i, i, touch.limit / slip.norm() * (across - along * along.transpose()));
        }
    }
}

double Rod::contact_energy(const std::vector<Vec3>& x) const {
    double sum = 0;
    for (const Touch& touch : now_.touches) {
        const Pressed p = pressed(touch, x[static_cast<std::size_t>(touch.node)]);
        sum += p.push * p.push / (2 * stiff_);
        const double slip = p.slip.norm(), drag = stiff_ * slip;
        sum += drag <= touch.limit ? 0.5 * drag * slip : touch.limit * (slip - 0.5 * touch.limit / stiff_);
    }
    return sum;
}

// After a step: multipliers take over what the stiffness carries, anchors of what slipped are drawn along.
void Rod::settle_touches() {
    for (Touch& touch : now_.touches) {
        const Vec3 at = now_.nodes[static_cast<std::size_t>(touch.node)];
        const Pressed p = pressed(touch, at);
        const double most = def_.friction * p.push / stiff_, slip = p.slip.norm();
        touch.push = p.push;
        touch.anchor = at - (slip <= most ? p.slip : Vec3(most / slip * p.slip));
    }
}

}  // namespace sim::rod
