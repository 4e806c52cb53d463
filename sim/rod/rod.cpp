#include "sim/rod/rod.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace sim::rod {

// How stiff contact is against a link: so deep does a node go before the multiplier has taken over, in a few steps.
static constexpr double contact_over_axial = 0.1;

double RodDef::bending_stiffness() const {
    return bending_share * young * 0.25 * std::numbers::pi * radius * radius * radius * radius;
}
double RodDef::yield_curvature() const {
    return 16 / (3 * std::numbers::pi) * yield_strain / radius;
}
double RodDef::twisting_stiffness() const {
    return bending_stiffness() / (1 + poisson);
}
double RodDef::axial_stiffness(double link) const {
    if (axial_over_bending > 0) return axial_over_bending * bending_stiffness() / (link * link);
    const double shorter = std::max(1.0, 0.5 * radius / link);  // than where it would stretch rather than bend
    return young * std::numbers::pi * radius * radius * shorter * shorter;
}
double RodDef::most_pull() const {
    return most_strain * young * std::numbers::pi * radius * radius;
}
// Ten times what a thickness of it gives: a thread that is pulled until it is a tenth longer is pressed in by a
// hundredth of its thickness.
double RodDef::contact_stiffness(double link) const {
    return 10 * axial_stiffness(link) / (2 * radius);
}
double RodDef::mass_per_length() const {
    return density * std::numbers::pi * radius * radius;
}

Rod::Rod(const RodDef& def, std::vector<Vec3> nodes) : def_(def) {
    assert(nodes.size() >= 2 && "a rod of at least one link");
    assert(def.radius > 0 && def.young > 0 && def.bending_share > 0 && def.density >= 0 && def.friction >= 0);
    now_.nodes = std::move(nodes);
    now_.velocity.assign(now_.nodes.size(), Vec3::Zero());
    now_.tension.assign(now_.nodes.size() - 1, 0);
    for (std::size_t k = 0; k + 1 < now_.nodes.size(); ++k)
        rest_length_.push_back((now_.nodes[k + 1] - now_.nodes[k]).norm());
    natural_.assign(now_.nodes.size(), 0);
    measure(now_.nodes, links_);
    for (std::size_t i = 1; i < rest_length_.size() && def_.keeps_shape; ++i)
        natural_[i] = (links_[i].along - links_[i - 1].along).norm();
    resize();
    const Vec3 first = (now_.nodes[1] - now_.nodes[0]).normalized();
    now_.directors[0] = first.unitOrthogonal();
    now_.directors[1] = along_rod(now_.directors[0], now_.nodes);
}

void Rod::resize() {
    force_.resize(now_.nodes.size());
    mass_.assign(now_.nodes.size(), 0);
    twisted_length_ = softest_ = stiffest_ = 0;
    for (std::size_t k = 0; k < rest_length_.size(); ++k) {
        const double l = rest_length_[k];
        if (is_cut(k)) continue;
        for (const std::size_t i : {k, k + 1}) mass_[i] += 0.5 * l * def_.mass_per_length();
        // From the middle of the first link to that of the last: links themselves do not twist.
        if (k > 0) twisted_length_ += 0.5 * (rest_length_[k - 1] + l);
        // A billionth of a bend's stiffness keeps what nothing holds from being nought, and moves nothing: it is
        // against the last iterate.
        softest_ = std::max(softest_, 1e-9 * def_.bending_stiffness() / (l * l * l));
        stiffest_ = std::max(stiffest_, def_.axial_stiffness(l) / l);
    }
    stiff_ = contact_over_axial * stiffest_;
}

void Rod::reserve(std::size_t links) {
    for (auto* of_nodes : {&now_.nodes, &now_.velocity, &start_, &due_, &led_, &aim_, &loads_, &force_, &gradient_,
                           &newton_, &spread_, &trial_})
        of_nodes->reserve(links + 1);
    for (auto* of_links :
         {&rest_length_, &mass_, &inert_, &natural_, &now_.tension, &foreseen_, &lengths_, &pivot_, &upper_, &shorten_})
        of_links->reserve(links + 1);
    held_.reserve(links + 1);
    for (auto* measured : {&links_, &tried_}) measured->reserve(links);
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

// The largest turn of a link in one step [rad].
static constexpr double most_turn = 0.3;

double Rod::largest_turn() const {
    double largest = 0;
    for (std::size_t k = 0; k < rest_length_.size(); ++k)
        if (!is_cut(k)) largest = std::max((newton_[k + 1] - newton_[k]).norm() / rest_length_[k], largest);
    return largest;
}

// Of links as long as the step makes them, without their turning.
void Rod::foresee_tensions() {
    foreseen_.resize(rest_length_.size());
    for (std::size_t k = 0; k < rest_length_.size(); ++k)
        foreseen_[k] =
            is_cut(k)
                ? 0
                : def_.axial_stiffness(rest_length_[k]) *
                      ((links_[k].length + links_[k].along.dot(newton_[k + 1] - newton_[k])) / rest_length_[k] - 1);
}

// Into trial_: nodes along the step, with links as long as it foresees: turning stretches them to second order, and so
// stiff are they that nothing else could be seen in the energy.
void Rod::try_share(double share) {
    trial_.resize(now_.nodes.size());
    lengths_.resize(rest_length_.size());
    for (std::size_t i = 0; i < trial_.size(); ++i) trial_[i] = now_.nodes[i] + share * newton_[i];
    for (std::size_t k = 0; k < rest_length_.size(); ++k) {
        if (is_cut(k)) continue;
        const double then = rest_length_[k] * (1 + foreseen_[k] / def_.axial_stiffness(rest_length_[k]));
        lengths_[k] = links_[k].length + share * (then - links_[k].length);
    }
    bring_to(lengths_, trial_);
}

void Rod::take_trial(double share) {
    for (std::size_t k = 0; k < rest_length_.size(); ++k) now_.tension[k] += share * (foreseen_[k] - now_.tension[k]);
    accept(trial_);
}

// Nodes along the Newton step, half as far again and again until the energy does not rise.
double Rod::go() {
    constexpr int halvings = 20;
    constexpr double noise = 1e-9;  // of sums over the rod, of which stretch is a thousandfold
    const double largest = largest_turn();
    if (!std::isfinite(largest)) return 0;
    double downhill = 0;
    for (std::size_t i = 0; i < newton_.size(); ++i) downhill += newton_[i].dot(force_[i]);
    foresee_tensions();
    const double before = energy(now_.nodes, links_);
    double share = std::min(1.0, most_turn / largest);
    for (int half = 0; half < halvings; ++half, share *= 0.5) {
        try_share(share);
        if (share * downhill > noise * std::abs(before) && !(energy(trial_, tried_) <= before)) continue;
        take_trial(share);
        return share;
    }
    return 0;
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
    for (std::size_t k = 0; k < rest_length_.size(); ++k) {
        const double now = tension(static_cast<int>(k));
        so = so && (is_cut(k) || std::abs(now - now_.tension[k]) <
                                     enough * def_.bending_stiffness() / (rest_length_[k] * rest_length_[k]));
        now_.tension[k] = now;
    }
    return so;
}

// What lies between two held nodes starts with as much of their moves as it is near them; what lies beyond the first or
// the last follows its leader, every link as long as it was.
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

// A step too large for Newton's method is taken in halves, those in halves again: what it left is no place to go on
// from.
RodReport Rod::step(const RodInput& input, double seconds, int most) {
    const RodReport report = step_in_parts(input, seconds, most, 4);
    take_set();
    return report;
}

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
    begin(input, seconds);
    trial_ = now_.nodes;
    for (const Hold& hold : input.holds) trial_[static_cast<std::size_t>(hold.node)] = hold.target;
    spread_between_held(trial_);
    accept(trial_);
    find_touches(input.bodies);
    due_.clear();
    RodReport report;
    while (!is_settled(report) && report.iterations < most && improve()) ++report.iterations;
    settle_touches();
    find_velocity();
    return report;
}

void Rod::begin(const RodInput& input, double seconds) {
    assert(seconds >= 0);
    assert((input.loads.empty() || input.loads.size() == now_.nodes.size()) && "a load for each node, or none");
    assert((input.asleep.empty() || input.asleep.size() == now_.nodes.size()) && "a mark for each node, or none");
    for ([[maybe_unused]] const Hold& hold : input.holds)
        assert(hold.node >= 0 && static_cast<std::size_t>(hold.node) < now_.nodes.size() && "a node of the rod");
    start_ = aim_ = now_.nodes;
    seconds_ = seconds;
    // Drag of the step's end is one more square about where the node was: the two together are one about a place
    // between.
    const double with_drag = def_.halting_time > 0 ? 1 + seconds / def_.halting_time : 1;
    inertia_ = seconds > 0 && def_.density > 0 ? with_drag / (seconds * seconds) : 0;
    turn_ = input.turn;
    if (input.asleep.empty())
        held_.assign(now_.nodes.size(), 0);
    else
        held_.assign(input.asleep.begin(), input.asleep.end());
    for (const Hold& hold : input.holds) held_[static_cast<std::size_t>(hold.node)] = 1;
    find_inert();
    loads_.resize(now_.nodes.size());
    double extent = twisted_length_;
    for (std::size_t i = 0; i < now_.nodes.size(); ++i) {
        loads_[i] = mass_[i] * def_.gravity;
        if (!input.loads.empty()) loads_[i] += input.loads[i];
        aim_[i] += seconds / with_drag * now_.velocity[i];
        extent = std::max(extent, now_.nodes[i].cwiseAbs().maxCoeff());
    }
    tolerance_ = input.tolerance.value_or(1e-14 * stiffest_ * extent);
}

// In balance in every tick nothing has inertia but, cut off and held by nobody, what would fall without end.
void Rod::find_inert() {
    if (!def_.quasi_static) {
        inert_ = mass_;
        return;
    }
    inert_.assign(mass_.size(), 0);
    std::size_t first = 0;
    for (std::size_t i = 0; i < mass_.size(); ++i) {
        if (i < rest_length_.size() && !is_cut(i)) continue;
        const bool whole = i - first == rest_length_.size(),
                   held = std::find(held_.data() + first, held_.data() + i + 1, 1) != held_.data() + i + 1;
        if (!whole && !held) std::copy(mass_.data() + first, mass_.data() + i + 1, inert_.data() + first);
        first = i + 1;
    }
}

void Rod::lead(std::span<const Hold> targets) {
    due_.assign(now_.nodes.size(), Vec3::Zero());
    for (const Hold& hold : targets)
        due_[static_cast<std::size_t>(hold.node)] = hold.target - now_.nodes[static_cast<std::size_t>(hold.node)];
}

bool Rod::is_settled(RodReport& report) {
    assemble(Keep::whole);
    report.residual = unbalanced();
    if (report.residual <= tolerance_ && !foresaw_tensions()) assemble(Keep::whole);
    report.stable = factor() == Keep::whole;
    return report.settled = report.residual <= tolerance_ && report.stable;
}

double Rod::improve() {
    find_newton_step();
    return go();
}

// Nothing of how forces turn with the nodes but what stiffens: pressed by others a rod balances in many shapes in which
// it alone would not.
void Rod::find_free_step(std::span<const Hold> targets, std::span<const Pair> pairs, std::span<const Rolling> rolling) {
    lead(targets);
    assemble(Keep::positive, pairs, rolling);
    matrix_.factor();
    find_newton_step();
}

void Rod::add_forces(const std::vector<Vec3>& forces) {
    assert(forces.size() == now_.nodes.size() && "a force for each node");
    spread_ = forces;
    for (std::size_t i = 0; i < spread_.size(); ++i)
        if (held_[i]) spread_[i].setZero();
    matrix_.solve(spread_);
    for (std::size_t i = 0; i < spread_.size(); ++i) newton_[i] += spread_[i];
}

double Rod::share_within(double most) {
    assert(most >= 0);
    foresee_tensions();
    double share = 1;
    for (std::size_t k = 0; k < rest_length_.size(); ++k) {
        const double now = tension(static_cast<int>(k)), then = foreseen_[k];
        if (std::abs(then) > most && std::abs(then) > std::abs(now))
            share = std::min(share, std::max(0.0, most - std::abs(now)) / std::abs(then - now));
    }
    return share;
}

// Whether links at `x` are no longer than they may be, or are: a kink that is pulled straight turns farther than its
// tensions foresee.
bool Rod::pulls_within(const std::vector<Vec3>& x) const {
    for (std::size_t k = 0; k < rest_length_.size(); ++k) {
        if (is_cut(k)) continue;
        const double longest = rest_length_[k] * (1 + def_.most_pull() / def_.axial_stiffness(rest_length_[k]));
        if ((x[k + 1] - x[k]).norm() > std::max(longest, links_[k].length)) return false;
    }
    return true;
}

double Rod::go_by(double share, std::span<const Vec3> from, std::span<const double> bound) {
    assert(from.size() == now_.nodes.size() && bound.size() == now_.nodes.size() &&
           "a place and a bound for each node");
    const double largest = largest_turn();
    if (!std::isfinite(largest)) return 0;
    foresee_tensions();
    share = std::min(share, most_turn / largest);
    const auto is_within = [&] {
        for (std::size_t i = 0; i < trial_.size(); ++i)
            if ((trial_[i] - from[i]).squaredNorm() > bound[i] * bound[i]) return false;
        return pulls_within(trial_);
    };
    constexpr int halvings = 6;
    for (int half = 0; half < halvings; ++half, share *= 0.5) {
        try_share(share);
        if (!is_within()) continue;
        take_trial(share);
        return share;
    }
    return 0;
}

void Rod::find_velocity() {
    if (seconds_ > 0)
        for (std::size_t i = 0; i < now_.nodes.size(); ++i) now_.velocity[i] = (now_.nodes[i] - start_[i]) / seconds_;
}

// Natural bends follow, so that nowhere more than what yields is left to spring back.
void Rod::take_set() {
    if (def_.yield_strain == 0) return;
    measure(now_.nodes, links_);
    for (std::size_t i = 1; i < rest_length_.size(); ++i) {
        const double springs = 0.5 * (rest_length_[i - 1] + rest_length_[i]) * def_.yield_curvature(),
                     bend = (links_[i].along - links_[i - 1].along).norm();
        natural_[i] = std::clamp(natural_[i], std::max(0.0, bend - springs), bend + springs);
    }
}

void Rod::end() {
    find_velocity();
    take_set();
}

double Rod::tension(int link) const {
    const auto k = static_cast<std::size_t>(link);
    return is_cut(k) ? 0
                     : def_.axial_stiffness(rest_length_[k]) *
                           ((now_.nodes[k + 1] - now_.nodes[k]).norm() / rest_length_[k] - 1);
}

Vec3 Rod::hold_force(int node) const {
    return -force_[static_cast<std::size_t>(node)];
}

}  // namespace sim::rod
