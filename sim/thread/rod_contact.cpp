#include <algorithm>

#include "sim/geometry/closest_points.hpp"
#include "sim/thread/rod.hpp"

namespace sim::thread {

using Block = Band::Block;

Vec3 Rod::from_axis(const Touch& touch, const Vec3& x) const {
    const Capsule& c = bodies_[static_cast<std::size_t>(touch.body)].to;
    return x - geometry::closest_points(x, x, c.a, c.b).on_b;
}

// What a contact pushes with [N]: augmented Lagrangian, nothing where it is open.
double Rod::push(const Touch& touch, double distance) const {
    const double thickness = bodies_[static_cast<std::size_t>(touch.body)].to.radius + def_.radius;
    return std::max(0.0, touch.push + stiff_ * (thickness - distance));
}

// Nodes within a diameter of a body. A contact that was there before keeps its push and its anchor, which goes with the body.
void Rod::find_touches(std::span<const MovingCapsule> bodies) {
    bodies_.assign(bodies.begin(), bodies.end());
    std::vector<Touch> before = std::move(now_.touches);
    now_.touches.clear();
    for (std::size_t i = 0; i < now_.nodes.size(); ++i)
        for (std::size_t b = 0; b < bodies_.size() && !held_[i]; ++b) {
            Touch touch{static_cast<int>(i), static_cast<int>(b), 0, now_.nodes[i]};
            const Vec3 away = from_axis(touch, now_.nodes[i]);
            if (away.norm() > bodies_[b].to.radius + 3 * def_.radius) continue;
            const auto known = std::find_if(before.begin(), before.end(), [&](const Touch& t) { return t.node == touch.node && t.body == touch.body; });
            if (known != before.end()) touch = *known, touch.anchor += bodies_[b].to.a - bodies_[b].from.a;
            now_.touches.push_back(touch);
        }
}

// Coulomb's cone about the push at the start of the step: sticks to its anchor as by a spring, slips at the limit.
void Rod::add_contact() {
    for (Touch& touch : now_.touches) {
        const auto i = static_cast<std::size_t>(touch.node);
        const Vec3 away = from_axis(touch, now_.nodes[i]);
        const double distance = away.norm(), force = push(touch, distance);
        touch.limit = def_.friction * force;
        if (force == 0) continue;
        const Vec3 normal = away / distance;
        const Block across = Block::Identity() - normal * normal.transpose();
        force_[i] += force * normal;
        // Where the body curves away from under the node the push turns with it; that would make the matrix not positive.
        band_.at(i, i) += stiff_ * normal * normal.transpose();
        const Vec3 slip = across * (now_.nodes[i] - touch.anchor);
        const double drag = stiff_ * slip.norm();
        if (drag <= touch.limit) {
            force_[i] -= stiff_ * slip;
            band_.at(i, i) += stiff_ * across;
        } else {
            const Vec3 along = slip.normalized();
            force_[i] -= touch.limit * along;
            band_.at(i, i) += touch.limit / slip.norm() * (across - along * along.transpose());
        }
    }
}

double Rod::contact_energy(const std::vector<Vec3>& x) const {
    double sum = 0;
    for (const Touch& touch : now_.touches) {
        const Vec3 at = x[static_cast<std::size_t>(touch.node)], away = from_axis(touch, at);
        const double distance = away.norm(), force = push(touch, distance);
        sum += force * force / (2 * stiff_);
        if (touch.limit == 0) continue;
        const Vec3 normal = away / distance, moved = at - touch.anchor;
        const double slip = (moved - moved.dot(normal) * normal).norm(), drag = stiff_ * slip;
        sum += drag <= touch.limit ? 0.5 * drag * slip : touch.limit * (slip - 0.5 * touch.limit / stiff_);
    }
    return sum;
}

// After a step: multipliers take over what the stiffness carries, anchors of what slipped are drawn along.
void Rod::settle_touches() {
    for (Touch& touch : now_.touches) {
        const Vec3 at = now_.nodes[static_cast<std::size_t>(touch.node)], away = from_axis(touch, at);
        const double distance = away.norm();
        touch.push = push(touch, distance);
        const Vec3 normal = away / distance, moved = at - touch.anchor, slip = moved - moved.dot(normal) * normal;
        const double most = def_.friction * touch.push / stiff_;
        touch.anchor = at - (slip.norm() <= most || slip.norm() == 0 ? slip : Vec3(most / slip.norm() * slip));
    }
}

}  // namespace sim::thread
