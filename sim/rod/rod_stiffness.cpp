#include <algorithm>
#include <cmath>

#include "sim/rod/rod.hpp"

namespace sim::rod {

using Block = ChainMatrix::Block;

// What a bend at a node between links a and b is worth: B over the thread between their middles, for half the square of
// the difference of their tangents. That is twice the sine of half their angle, which makes the curvature that of the
// circle through three nodes; the tangent of half the angle (Bergou et al. 2008, eq. 1) has five times the error.
// Nothing bends at a cut.
static double bend_stiffness(const RodDef& def, double a, double b) {
    return a > 0 && b > 0 ? 2 * def.bending_stiffness() / (a + b) : 0;
}

void Rod::measure(const std::vector<Vec3>& x, std::vector<Link>& links) {
    links.resize(x.size() - 1);
    for (std::size_t k = 0; k < links.size(); ++k) {
        const Vec3 edge = x[k + 1] - x[k];
        links[k].length = edge.norm();
        links[k].along = edge / links[k].length;
    }
}

double Rod::energy_of(const std::vector<Link>& links) const {
    double sum = 0;
    for (std::size_t k = 0; k < rest_length_.size(); ++k) {
        if (is_cut(k)) continue;
        const double strain = links[k].length / rest_length_[k] - 1;
        sum += 0.5 * def_.axial_stiffness(rest_length_[k]) * rest_length_[k] * strain * strain;
        if (k == 0) continue;
        const double bend = (links[k].along - links[k - 1].along).norm() - natural_[k];
        sum += 0.5 * bend_stiffness(def_, rest_length_[k - 1], rest_length_[k]) * bend * bend;
    }
    return sum;
}

double Rod::energy(const std::vector<Vec3>& x, std::vector<Link>& links) {
    measure(x, links);
    double sum = energy_of(links) + contact_energy(x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum -= loads_[i].dot(x[i]);
        if (inertia_ > 0) sum += 0.5 * inertia_ * inert_[i] * (x[i] - aim_[i]).squaredNorm();
    }
    const double twist = twist_at(x);
    return sum + 0.5 * def_.twisting_stiffness() / twisted_length_ * twist * twist;
}

void Rod::add_stretch(Keep keep) {
    for (std::size_t k = 0; k < rest_length_.size(); ++k) {
        Link& link = links_[k];
        if (is_cut(k)) {
            link.pull = link.aside = Vec3::Zero();
            link.own = 0;
            continue;
        }
        const double axial = def_.axial_stiffness(rest_length_[k]);
        // A link that is pushed together would fall aside.
        const double across = (keep == Keep::whole ? now_.tension[k] : std::max(0.0, now_.tension[k])) / link.length;
        link.pull = axial * (link.length / rest_length_[k] - 1) * link.along;
        link.own = across;
        link.aside = 0.5 * (axial / rest_length_[k] - across) * link.along;
    }
}

// What share of a bend is more than the natural one. A straight one does not know where to; it is left a tenth of it to
// find out.
static double excess(double natural, double bend) {
    return natural > 0 ? 1 - natural / std::max(bend, 0.1 * natural) : 1;
}

// With a natural bend the stiffness is that without one, which is no less.
void Rod::add_bending(Keep keep) {
    for (std::size_t k = 0; k + 1 < rest_length_.size(); ++k) {
        Link &a = links_[k], &b = links_[k + 1];
        const double stiffness = bend_stiffness(def_, rest_length_[k], rest_length_[k + 1]), c = a.along.dot(b.along);
        const Vec3 b_off_a = b.along - c * a.along, a_off_b = a.along - c * b.along;
        const double more = stiffness * excess(natural_[k + 1], (b.along - a.along).norm());
        a.pull -= more / a.length * b_off_a, b.pull -= more / b.length * a_off_b;
        const auto add = [&](Link& link, const Vec3& off) {
            const double s = stiffness / (link.length * link.length), across = keep == Keep::whole ? s * c : s;
            link.own += across;
            link.aside -= 0.5 * across * link.along;
            if (keep == Keep::whole) link.aside += s * off;
        };
        add(a, b_off_a), add(b, a_off_b);
    }
}

// Second derivative of the bend between a link and the next by their vectors.
Block Rod::cross(std::size_t link) const {
    const Link &a = links_[link], &b = links_[link + 1];
    const double s = -bend_stiffness(def_, rest_length_[link], rest_length_[link + 1]) / (a.length * b.length),
                 c = a.along.dot(b.along);
    const Vec3 of_a = -s * (a.along - c * b.along), of_b = -s * b.along;
    Block block = a.along * of_a.transpose() + b.along * of_b.transpose();
    block.diagonal().array() += s;
    return block;
}

static void put(double* column, const Block& own, const Block& next, const Block& second) {
    for (Eigen::Index c = 0; c < 3; ++c, column += ChainMatrix::stride) {
        for (Eigen::Index r = c; r < 3; ++r) column[r - c] = own(r, c);
        for (Eigen::Index r = 0; r < 3; ++r) column[3 - c + r] = next(c, r), column[6 - c + r] = second(c, r);
    }
}

// From the links' vectors to the nodes that they lie between.
void Rod::spread_to_nodes() {
    const std::size_t n = rest_length_.size();
    Block own_before = Block::Zero(), cross_before = Block::Zero();
    for (std::size_t i = 0; i <= n; ++i) {
        Block own = Block::Zero(), crossing = Block::Zero();
        if (i < n) {
            const Link& link = links_[i];
            own = link.aside * link.along.transpose() + link.along * link.aside.transpose();
            own.diagonal().array() += link.own;
            force_[i] += link.pull, force_[i + 1] -= link.pull;
        }
        if (i + 1 < n) crossing = cross(i);
        Block at_node = own_before + own - cross_before - cross_before.transpose();
        at_node.diagonal().array() += std::max(softest_, inertia_ * inert_[i]);  // more than inertia would be drag
        put(matrix_.column(3 * i), at_node, cross_before - own + crossing, -crossing);
        own_before = own, cross_before = crossing;
    }
}

// Each shared among the nodes of its points.
void Rod::add_pairs(std::span<const Pair> pairs) {
    for (const Pair& pair : pairs)
        for (std::size_t k = 0; k < static_cast<std::size_t>(pair.nodes); ++k)
            force_[static_cast<std::size_t>(pair.node[k])] += pair.weight[k] * pair.force;
}

void Rod::add_rolling(std::span<const Rolling> rolling) {
    for (const Rolling& roll : rolling) {
        const std::size_t i = static_cast<std::size_t>(roll.link);
        const Block turning =
            roll.moment / (links_[i].length * links_[i].length) * roll.normal * roll.normal.transpose();
        matrix_.add(i, i, turning), matrix_.add(i, i + 1, -turning), matrix_.add(i + 1, i + 1, turning);
    }
}

void Rod::assemble(Keep keep, std::span<const Pair> pairs, std::span<const Rolling> rolling) {
    matrix_.clear(now_.nodes.size());
    measure(now_.nodes, links_);
    for (std::size_t i = 0; i < now_.nodes.size(); ++i)
        force_[i] = loads_[i] - inertia_ * inert_[i] * (now_.nodes[i] - aim_[i]);
    add_stretch(keep);
    add_bending(keep);
    spread_to_nodes();
    add_contact();
    add_pairs(pairs);
    add_rolling(rolling);
    if (turn_) {
        if (keep == Keep::whole) add_twist();
        find_twist_gradient();
        for (std::size_t i = 0; i < now_.nodes.size(); ++i) force_[i] -= twist_moment() * gradient_[i];
    }
    led_.assign(now_.nodes.size(), Vec3::Zero());
    for (std::size_t i = 0; i < now_.nodes.size(); ++i) {
        if (!held_[i]) continue;
        if (!due_.empty()) matrix_.lead(i, due_[i], led_);
        matrix_.fix(i);
        if (turn_) gradient_[i].setZero();
    }
}

// Where the whole stiffness is not positive, as on the way past a buckling, as little as will do is added to all of its
// diagonal (Levenberg), at last nothing but Gauss and Newton's part is kept.
Rod::Keep Rod::factor() {
    constexpr double least = 1e4,
                     most = 1e9;  // of what is added anyway: a hundred-thousandth of a bend's stiffness to all of it
    if (matrix_.factor()) return Keep::whole;
    for (double more = least; more <= most; more *= 10)
        if (matrix_.factor(more * softest_)) return Keep::positive;
    assemble(Keep::positive);
    matrix_.factor();  // of what is not finite nothing comes, and go() sees that
    return Keep::positive;
}

// Twist is one number for all nodes, so it adds a matrix of rank one (Sherman and Morrison).
void Rod::find_newton_step() {
    newton_.resize(force_.size());
    const auto stay_held = [&] {
        for (std::size_t i = 0; i < newton_.size(); ++i)
            if (held_[i]) newton_[i] = due_.empty() ? Vec3::Zero().eval() : due_[i];
    };
    for (std::size_t i = 0; i < newton_.size(); ++i) newton_[i] = force_[i] + led_[i];
    stay_held();
    matrix_.solve(newton_);
    stay_held();  // whatever was added to the diagonal
    if (!turn_) return;
    spread_ = gradient_;
    matrix_.solve(spread_);
    double through = 0, own = 0;
    for (std::size_t i = 0; i < newton_.size(); ++i)
        through += gradient_[i].dot(newton_[i]), own += gradient_[i].dot(spread_[i]);
    const double twisting = def_.twisting_stiffness() / twisted_length_,
                 share = twisting * through / (1 + twisting * own);
    for (std::size_t i = 0; i < newton_.size(); ++i) newton_[i] -= share * spread_[i];
}

}  // namespace sim::rod
