#include "sim/thread/rod.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/portable_math.hpp"

namespace sim::thread {

// How stiff contact is against a link: so deep does a node go before the multiplier has taken over, in a few steps.
static constexpr double contact_over_axial = 0.1;

// A vector across `from`, turned by the least rotation that brings `from` to `to`; both of unit length.
static Vec3 transported(const Vec3& v, const Vec3& from, const Vec3& to) { return v - v.dot(to) / (1 + from.dot(to)) * (from + to); }

double RodDef::bending_stiffness() const { return young * 0.25 * std::numbers::pi * radius * radius * radius * radius; }
double RodDef::twisting_stiffness() const { return bending_stiffness() / (1 + poisson); }
double RodDef::axial_stiffness(double link) const {
    return axial_over_bending > 0 ? axial_over_bending * bending_stiffness() / (link * link) : young * std::numbers::pi * radius * radius;
}
double RodDef::mass_per_length() const { return density * std::numbers::pi * radius * radius; }

Rod::Rod(const RodDef& def, std::vector<Vec3> nodes) : def_(def) {
    now_.nodes = std::move(nodes);
    now_.velocity.assign(now_.nodes.size(), Vec3::Zero());
    mass_.assign(now_.nodes.size(), 0);
    now_.tension.assign(now_.nodes.size() - 1, 0);
    for (std::size_t k = 0; k + 1 < now_.nodes.size(); ++k) {
        rest_.push_back((now_.nodes[k + 1] - now_.nodes[k]).norm());
        for (const std::size_t i : {k, k + 1}) mass_[i] += 0.5 * rest_[k] * def_.mass_per_length();
    }
    // From the middle of the first link to that of the last: links themselves do not twist.
    for (std::size_t k = 1; k < rest_.size(); ++k) twisted_length_ += 0.5 * (rest_[k - 1] + rest_[k]);
    // A billionth of a bend's stiffness keeps what nothing holds from being nought, and moves nothing: it is against the last iterate.
    for (const double l : rest_) {
        softest_ = std::max(softest_, 1e-9 * def_.bending_stiffness() / (l * l * l));
        stiffest_ = std::max(stiffest_, def_.axial_stiffness(l) / l);
    }
    stiff_ = contact_over_axial * stiffest_;
    const Vec3 first = (now_.nodes[1] - now_.nodes[0]).normalized();
    now_.directors[0] = first.unitOrthogonal();
    now_.directors[1] = along_rod(now_.directors[0], now_.nodes);
}

// A vector across the first link, carried along the rod to the last.
Vec3 Rod::along_rod(Vec3 across, const std::vector<Vec3>& x) const {
    Vec3 before = (x[1] - x[0]).normalized();
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
        const Vec3 now = (x[k + 1] - x[k]).normalized();
        across = transported(across, before, now);
        before = now;
    }
    return across;
}

// Directors are carried in time with the links at either end; what they then differ by along the rod is the twist that the
// rod's writhe took off.
std::array<Vec3, 2> Rod::directors_at(const std::vector<Vec3>& x) const {
    const std::size_t n = x.size() - 1;
    const auto carried = [&](const Vec3& director, std::size_t k) {
        return transported(director, (now_.nodes[k + 1] - now_.nodes[k]).normalized(), (x[k + 1] - x[k]).normalized());
    };
    return {carried(now_.directors[0], 0), carried(now_.directors[1], n - 1)};
}

double Rod::twist_at(const std::vector<Vec3>& x) const {
    if (!turn_) return 0;
    const auto directors = directors_at(x);
    const Vec3 along = along_rod(directors[0], x), axis = (x[x.size() - 1] - x[x.size() - 2]).normalized();
    const double angle = geometry::portable_atan2(axis.dot(along.cross(directors[1])), along.dot(directors[1]));
    // The turn that is nearest to the one before: no step turns a rod by half a turn.
    constexpr double whole = 2 * std::numbers::pi;
    return *turn_ + angle - whole * std::round((angle - now_.turned) / whole);
}

double Rod::unbalanced() const {
    double most = 0;
    for (std::size_t i = 0; i < now_.nodes.size(); ++i)
        if (!held_[i]) {
            const double force = force_[i].norm();
            if (std::isnan(force)) return force;
            most = std::max(most, force);
        }
    return most;
}

// Nodes along `way`, no link turned by more than a third of a radian; half as far again and again until the energy does not rise.
// It is looked at with links as long as the step foresees: turning stretches them to second order, which the next step takes back,
// and so stiff are they that nothing else could be seen in the energy.
bool Rod::go(const std::vector<Vec3>& way) {
    constexpr double most_turn = 0.3;
    double largest = 0, downhill = 0;
    std::vector<double> tension(rest_.size());
    for (std::size_t k = 0; k < rest_.size(); ++k) {
        const Vec3 edge = now_.nodes[k + 1] - now_.nodes[k], by = way[k + 1] - way[k];
        largest = std::max(by.norm() / rest_[k], largest);
        tension[k] = def_.axial_stiffness(rest_[k]) * ((edge.norm() + edge.normalized().dot(by)) / rest_[k] - 1);
    }
    for (std::size_t i = 0; i < way.size(); ++i) downhill += way[i].dot(force_[i]);
    if (!std::isfinite(largest)) return false;
    const double before = energy(now_.nodes);
    constexpr int halvings = 20;
    std::vector<Vec3> x(now_.nodes.size()), judged;
    std::vector<double> lengths(rest_.size());
    double share = std::min(1.0, most_turn / largest);
    for (int half = 0; half < halvings; ++half, share *= 0.5) {
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = now_.nodes[i] + share * way[i];
        for (std::size_t k = 0; k < rest_.size(); ++k) {
            const double now = (now_.nodes[k + 1] - now_.nodes[k]).norm(), then = rest_[k] * (1 + tension[k] / def_.axial_stiffness(rest_[k]));
            lengths[k] = now + share * (then - now);
        }
        constexpr double noise = 1e-9;  // of sums over the rod, of which stretch is a thousandfold
        if (share * downhill > noise * std::abs(before)) {
            judged = x;
            bring_to(lengths, judged);
            if (!(energy(judged) <= before)) continue;
        }
        for (std::size_t k = 0; k < rest_.size(); ++k) now_.tension[k] += share * (tension[k] - now_.tension[k]);
        accept(x);
        return true;
    }
    return false;
}

// Moves nodes as little as possible until links have these lengths: Newton's method on all of them together, two rounds, of which
// each squares the error.
void Rod::bring_to(const std::vector<double>& lengths, std::vector<Vec3>& x) {
    const std::size_t n = lengths.size();
    std::vector<Vec3> along(n);
    std::vector<double> pivot(n), upper(n), push(n);
    const auto gives = [&](std::size_t i) { return held_[i] ? 0.0 : 1.0; };
    for (int round = 0; round < 2; ++round) {
        for (std::size_t k = 0; k < n; ++k) {
            const Vec3 edge = x[k + 1] - x[k];
            const double length = edge.norm();
            along[k] = edge / length;
            push[k] = length - lengths[k];
            pivot[k] = gives(k) + gives(k + 1);
            if (pivot[k] == 0) pivot[k] = 1, push[k] = 0;  // between two held nodes
            if (k > 0) upper[k - 1] = -gives(k) * along[k - 1].dot(along[k]);
        }
        for (std::size_t k = 1; k < n; ++k) {
            const double factor = upper[k - 1] / pivot[k - 1];
            pivot[k] -= factor * upper[k - 1], push[k] -= factor * push[k - 1];
            // A straight piece between held nodes has no length to give: its last pivot is nought. It is kept to a millionth of
            // the others, which are about one; what then moves too far no energy accepts.
            pivot[k] = std::max(pivot[k], 1e-6);
        }
        for (std::size_t k = n; k-- > 0;) push[k] = (push[k] - (k + 1 < n ? upper[k] * push[k + 1] : 0)) / pivot[k];
        for (std::size_t k = 0; k < n; ++k) {
            x[k] += gives(k) * push[k] * along[k];
            x[k + 1] -= gives(k + 1) * push[k] * along[k];
        }
    }
}

void Rod::accept(const std::vector<Vec3>& x) {
    const double twist = twist_at(x);
    now_.directors = directors_at(x);
    if (turn_) now_.turned = twist - *turn_;
    now_.twist = twist;
    now_.nodes = x;
}

// Whether what a step foresaw of the tensions is what they are; then it is.
bool Rod::foresaw_tensions() {
    constexpr double enough = 1e-3;  // of the bending stiffness at a node, whose sign it might change
    bool so = true;
    for (std::size_t k = 0; k < rest_.size(); ++k) {
        const double now = tension(static_cast<int>(k));
        so = so && std::abs(now - now_.tension[k]) < enough * def_.bending_stiffness() / (rest_[k] * rest_[k]);
        now_.tension[k] = now;
    }
    return so;
}

// What lies between two held nodes starts with as much of their moves as it is near them; what lies beyond the first or the last
// follows its leader, every link as long as it was.
void Rod::spread_between_held(std::vector<Vec3>& x) const {
    const auto is_held = [&](std::size_t i) { return held_[i] != 0; };
    const std::size_t n = x.size();
    std::size_t first = 0;
    while (first < n && !is_held(first)) ++first;
    if (first == n) return;
    const auto follow = [&](std::size_t i, std::size_t leader) {
        const double length = (now_.nodes[i] - now_.nodes[leader]).norm();
        x[i] = x[leader] + length * (now_.nodes[i] - x[leader]).normalized();
    };
    for (std::size_t i = first; i-- > 0;) follow(i, i + 1);
    std::size_t before = first;
    for (std::size_t i = first + 1; i < n; ++i) {
        if (!is_held(i)) continue;
        for (std::size_t k = before + 1; k < i; ++k) {
            const double share = static_cast<double>(k - before) / static_cast<double>(i - before);
            x[k] += share * (x[i] - now_.nodes[i]) + (1 - share) * (x[before] - now_.nodes[before]);
        }
        before = i;
    }
    for (std::size_t i = before + 1; i < n; ++i) follow(i, i - 1);
}

// A step too large for Newton's method is taken in halves, those in halves again: what it left is no place to go on from.
RodReport Rod::step(const RodInput& input, double seconds, int most) { return step_in_parts(input, seconds, most, 4); }

RodReport Rod::step_in_parts(const RodInput& input, double seconds, int most, int halvings) {
    const Moving before = now_;
    const RodReport whole = try_step(input, seconds, most);
    if (whole.settled || halvings == 0 || most == 0 || input.holds.empty()) return whole;
    now_ = before;
    std::vector<Hold> holds(input.holds.begin(), input.holds.end());
    for (Hold& hold : holds) hold.target = 0.5 * (hold.target + now_.nodes[static_cast<std::size_t>(hold.node)]);
    std::vector<MovingCapsule> to_middle(input.bodies.begin(), input.bodies.end()), from_middle = to_middle;
    for (std::size_t i = 0; i < to_middle.size(); ++i) {
        Capsule& middle = to_middle[i].to;
        middle.a = 0.5 * (middle.a + to_middle[i].from.a), middle.b = 0.5 * (middle.b + to_middle[i].from.b);
        from_middle[i].from = middle;
    }
    RodInput first = input, second = input;
    first.holds = holds, first.bodies = to_middle, second.bodies = from_middle;
    const int tried = whole.iterations + step_in_parts(first, 0.5 * seconds, most, halvings - 1).iterations;
    RodReport report = step_in_parts(second, 0.5 * seconds, most, halvings - 1);
    report.iterations += tried;
    return report;
}

RodReport Rod::try_step(const RodInput& input, double seconds, int most) {
    const std::vector<Vec3> start = now_.nodes;
    inertia_ = seconds > 0 && def_.density > 0 ? 1 / (seconds * seconds) : 0;
    turn_ = input.turn;
    held_.assign(now_.nodes.size(), 0);
    loads_.assign(now_.nodes.size(), Vec3::Zero());
    aim_ = now_.nodes;
    std::vector<Vec3> x = now_.nodes;
    for (std::size_t i = 0; i < now_.nodes.size(); ++i) {
        loads_[i] = mass_[i] * def_.gravity + (input.loads.empty() ? Vec3::Zero().eval() : input.loads[i]);
        aim_[i] += seconds * now_.velocity[i];
    }
    for (const Hold& hold : input.holds) {
        held_[static_cast<std::size_t>(hold.node)] = 1;
        x[static_cast<std::size_t>(hold.node)] = hold.target;
    }
    double extent = 0;
    for (const Vec3& p : now_.nodes) extent = std::max(extent, p.cwiseAbs().maxCoeff());
    spread_between_held(x);
    accept(x);
    find_touches(input.bodies);
    RodReport report;
    const double tolerance = input.tolerance.value_or(1e-14 * stiffest_ * std::max(extent, twisted_length_));
    for (;; ++report.iterations) {
        assemble(Stiffness::whole);
        report.residual = unbalanced();
        if (report.residual <= tolerance && !foresaw_tensions()) assemble(Stiffness::whole);
        report.stable = factor() == Stiffness::whole;
        report.settled = report.residual <= tolerance && report.stable;
        if (report.settled || report.iterations == most || !go(newton_step())) break;
    }
    settle_touches();
    if (seconds > 0)
        for (std::size_t i = 0; i < now_.nodes.size(); ++i) now_.velocity[i] = (now_.nodes[i] - start[i]) / seconds;
    return report;
}

double Rod::tension(int link) const {
    const auto k = static_cast<std::size_t>(link);
    return def_.axial_stiffness(rest_[k]) * ((now_.nodes[k + 1] - now_.nodes[k]).norm() / rest_[k] - 1);
}

double Rod::twist_moment() const { return def_.twisting_stiffness() / twisted_length_ * now_.twist; }

Vec3 Rod::hold_force(int node) const { return -force_[static_cast<std::size_t>(node)]; }

}  // namespace sim::thread
