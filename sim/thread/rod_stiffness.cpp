#include <algorithm>

#include "sim/thread/bend.hpp"
#include "sim/thread/rod.hpp"

namespace sim::thread {

using Block = Band::Block;

double Rod::energy(const std::vector<Vec3>& x) const {
    double sum = 0;
    const double bending = def_.bending_stiffness();
    for (std::size_t k = 0; k < rest_.size(); ++k) {
        const double strain = (x[k + 1] - x[k]).norm() / rest_[k] - 1;
        sum += 0.5 * def_.axial_stiffness(rest_[k]) * rest_[k] * strain * strain;
    }
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const Bend bend(x[i] - x[i - 1], x[i + 1] - x[i]);
        sum += bending * bend.difference.squaredNorm() / (rest_[i - 1] + rest_[i]);
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum -= loads_[i].dot(x[i]);
        if (inertia_ > 0) sum += 0.5 * inertia_ * mass_[i] * (x[i] - aim_[i]).squaredNorm();
    }
    const double twist = twist_at(x);
    return sum + contact_energy(x) + 0.5 * def_.twisting_stiffness() / twisted_length_ * twist * twist;
}

void Rod::add_stretch(Stiffness stiffness) {
    for (std::size_t k = 0; k < rest_.size(); ++k) {
        const Vec3 edge = now_.nodes[k + 1] - now_.nodes[k];
        const double length = edge.norm(), axial = def_.axial_stiffness(rest_[k]), pull = axial * (length / rest_[k] - 1);
        const Vec3 t = edge / length;
        force_[k] += pull * t, force_[k + 1] -= pull * t;
        // A link that is pushed together would fall aside.
        const double across = (stiffness == Stiffness::whole ? now_.tension[k] : std::max(0.0, now_.tension[k])) / length;
        const Block block = (axial / rest_[k] - across) * t * t.transpose() + across * Block::Identity();
        band_.at(k, k) += block, band_.at(k + 1, k + 1) += block, band_.at(k, k + 1) -= block;
    }
}

void Rod::add_bending(Stiffness stiffness) {
    for (std::size_t i = 1; i + 1 < now_.nodes.size(); ++i) {
        const Bend bend(now_.nodes[i] - now_.nodes[i - 1], now_.nodes[i + 1] - now_.nodes[i]);
        const double bending = 2 * def_.bending_stiffness() / (rest_[i - 1] + rest_[i]);
        const Vec3 first = bending * bend.by_first(), last = bending * bend.by_last();
        force_[i - 1] -= first, force_[i] += first + last, force_[i + 1] -= last;
        auto [a, b, both] = bend.second(stiffness == Stiffness::whole);
        a *= bending, b *= bending, both *= bending;
        band_.at(i - 1, i - 1) += a, band_.at(i, i) += a + b + both + both.transpose(), band_.at(i + 1, i + 1) += b;
        band_.at(i - 1, i) -= a + both, band_.at(i, i + 1) -= b + both, band_.at(i - 1, i + 1) += both;
    }
}

void Rod::add_twist() {
    for (std::size_t i = 1; i + 1 < now_.nodes.size(); ++i) {
        const auto second = Bend(now_.nodes[i] - now_.nodes[i - 1], now_.nodes[i + 1] - now_.nodes[i]).turn_by_nodes();
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = r; c < 3; ++c) band_.at(i - 1 + r, i - 1 + c) += twist_moment() * second[r][c];
    }
}

// How the writhe, and so the twist, changes with the nodes (Bergou et al. 2010, eq. 10).
void Rod::find_twist_gradient() {
    gradient_.assign(now_.nodes.size(), Vec3::Zero());
    for (std::size_t i = 1; i + 1 < now_.nodes.size(); ++i) {
        const Bend bend(now_.nodes[i] - now_.nodes[i - 1], now_.nodes[i + 1] - now_.nodes[i]);
        const Vec3 before = -0.5 / bend.la * bend.binormal(), after = 0.5 / bend.lb * bend.binormal();
        gradient_[i - 1] += before, gradient_[i] -= before + after, gradient_[i + 1] += after;
    }
}

void Rod::assemble(Stiffness stiffness) {
    force_ = loads_;
    band_.clear(now_.nodes.size());
    add_stretch(stiffness);
    add_bending(stiffness);
    add_contact();
    if (inertia_ > 0)
        for (std::size_t i = 0; i < now_.nodes.size(); ++i) {
            force_[i] -= inertia_ * mass_[i] * (now_.nodes[i] - aim_[i]);
            band_.at(i, i) += inertia_ * mass_[i] * Block::Identity();
        }
    if (turn_) {
        if (stiffness == Stiffness::whole) add_twist();
        find_twist_gradient();
        for (std::size_t i = 0; i < now_.nodes.size(); ++i) force_[i] -= twist_moment() * gradient_[i];
    }
    for (std::size_t i = 0; i < now_.nodes.size(); ++i) {
        band_.at(i, i) += softest_ * Block::Identity();
        if (!held_[i]) continue;
        band_.fix(i);
        if (turn_) gradient_[i].setZero();
    }
}

// Where the whole stiffness is not positive, as on the way past a buckling, as little as will do is added to all of its diagonal
// (Levenberg), at last nothing but Gauss and Newton's part is kept.
Rod::Stiffness Rod::factor() {
    whole_ = band_;
    constexpr double least = 1e4, most = 1e9;  // of what is added anyway: a hundred-thousandth of a bend's stiffness to all of it
    if (band_.factor()) return Stiffness::whole;
    for (double more = least; more <= most; more *= 10) {
        band_ = whole_;
        for (std::size_t i = 0; i < now_.nodes.size(); ++i) band_.at(i, i) += more * softest_ * Block::Identity();
        if (band_.factor()) return Stiffness::positive;
    }
    assemble(Stiffness::positive);
    band_.factor();  // of what is not finite nothing comes, and go() sees that
    return Stiffness::positive;
}

// Twist is one number for all nodes, so it adds a matrix of rank one (Sherman and Morrison).
std::vector<Vec3> Rod::newton_step() {
    std::vector<Vec3> x = force_;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (held_[i]) x[i].setZero();
    band_.solve(x);
    if (!turn_) return x;
    std::vector<Vec3> spread = gradient_;
    band_.solve(spread);
    double through = 0, own = 0;
    for (std::size_t i = 0; i < x.size(); ++i) through += gradient_[i].dot(x[i]), own += gradient_[i].dot(spread[i]);
    const double twisting = def_.twisting_stiffness() / twisted_length_, share = twisting * through / (1 + twisting * own);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= share * spread[i];
    return x;
}

}  // namespace sim::thread
