// In which direction a wall goes in a move.
//
// Method: a nonlinear conjugate gradient (Polak and Ribiere 1969) whose preconditioner is the stiffness that is
// factored. Two corrections keep an old stiffness of use: it is rotated and stretched by how the wall about each node
// has deformed since (find_strain), and the stiffness of today's point forces takes the place of the one that was
// factored (find_solved), by a few conjugate gradients. Cost: one to four solves with the factors.
#include <algorithm>
#include <cmath>

#include "tissue/by_nodes.hpp"
#include "tissue/tissue.hpp"

namespace tissue {

// The mean deformation of the cells about each node since the stiffness was found: the gradient of where nodes are with
// respect to where they were then, column by column.
void Tissue::find_strain() {
    strain_.assign(x_.size(), {});
    shared_.assign(x_.size(), 0);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const Cells& cells = cells_[c];
        const Volumes& then = used_volumes_[c];
        Lanes x, y, z;
        for (std::size_t n = 0; n < cells.count; ++n) {
            const Lanes at = gathered(cells, n, x_);
            x += then.gradient[n].x * at, y += then.gradient[n].y * at, z += then.gradient[n].z * at;
        }
        for (std::size_t k = 0; k < cells.used; ++k) {
            const Lane own_x(x.x[k], x.y[k], x.z[k], 0), own_y(y.x[k], y.y[k], y.z[k], 0),
                own_z(z.x[k], z.y[k], z.z[k], 0);
            for (std::size_t n = 0; n < cells.count; ++n) {
                const auto i = static_cast<std::size_t>(cells.nodes[n][k]);
                strain_[i][0] += own_x, strain_[i][1] += own_y, strain_[i][2] += own_z;
                shared_[i] += then.value[k];
            }
        }
    }
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const bool known = free_[i].minCoeff() > 0 && shared_[i] > 0;
        const double share = known ? 1 / shared_[i] : 0, one = known ? 0 : 1;
        strain_[i] = {share * strain_[i][0] + Lane(one, 0, 0, 0), share * strain_[i][1] + Lane(0, one, 0, 0),
                      share * strain_[i][2] + Lane(0, 0, one, 0)};
    }
}

// The solution M^-1 f, where M is the stiffness that is factored, carried along by the deformation since.
void Tissue::soften(std::span<const Vec3> force, std::vector<Vec3>& to) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Lane here(force[i].x(), force[i].y(), force[i].z(), 0);
        to[i] = Vec3((strain_[i][0] * here).sum(), (strain_[i][1] * here).sum(), (strain_[i][2] * here).sum());
    }
    matrix_.solve(to);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Lane by = strain_[i][0] * to[i].x() + strain_[i][1] * to[i].y() + strain_[i][2] * to[i].z();
        to[i] = Vec3(by[0], by[1], by[2]).cwiseProduct(free_[i]);
    }
}

void Tissue::add_lost(std::span<const PointForce> forces, double times, std::span<const Vec3> gone,
                      std::vector<Vec3>& to) const {
    for (const PointForce& force : forces)
        share(rest_.tetrahedra[static_cast<std::size_t>(force.at.tetrahedron)], force.at.weights,
              times * force.lost(carried(force.at, gone)), to);
}

// Solves with the stiffness of today's forces in place of that of the forces the factors know, by conjugate gradients
// preconditioned with the factors: few forces differ, so few iterations do. M times a direction is what was solved for,
// so that M itself is never needed.
void Tissue::find_solved() {
    soften(free_residual_, solved_);
    if (stiff_.empty() && used_stiff_.empty()) return;
    constexpr int most = 3;  // more solves
    // A hundredth of the direction, squared, which its lowest point makes up for; and of the residual, hardly anything.
    constexpr double enough = 1e-4;
    left_ = free_residual_, next_ = solved_, factored_pull_ = free_residual_;
    solved_.assign(x_.size(), Vec3::Zero());
    const double all = dot(left_, next_);
    double product = all;
    std::vector<Vec3>& softened = ldirection_;  // whose own content is not known yet
    for (int k = 0;; ++k) {
        pull_ = factored_pull_;  // becomes the whole stiffness times the direction
        add_lost(stiff_, 1, next_, pull_);
        add_lost(used_stiff_, -1, next_, pull_);
        const double curvature = dot(pull_, next_);
        if (!(curvature > 0)) break;
        const double far = product / curvature;
        for (std::size_t i = 0; i < x_.size(); ++i)
            solved_[i] += far * next_[i], left_[i] = (left_[i] - far * pull_[i]).cwiseProduct(free_[i]);
        if (k == most || dot(left_, left_) <= enough * enough * dot(free_residual_, free_residual_)) break;
        soften(left_, softened);
        const double now = dot(left_, softened), kept = now / product;
        if (!(now > enough * all)) break;
        for (std::size_t i = 0; i < x_.size(); ++i)
            next_[i] = softened[i] + kept * next_[i], factored_pull_[i] = left_[i] + kept * factored_pull_[i];
        product = now;
    }
    if (!(dot(free_residual_, solved_) > 0)) soften(free_residual_, solved_);
}

// The next direction. At the lowest point along the last one no residual is left along it; where some is, the load is
// new, and the last direction may be mere rounding.
void Tissue::find_direction(bool afresh) {
    find_strain();
    find_solved();
    const double product = dot(free_residual_, solved_),
                 kept = afresh || last_product_ <= 0
                            ? 0
                            : std::max(0.0, (product - dot(last_residual_, solved_)) / last_product_);
    const double carried_on = kept * dot(free_residual_, direction_);
    const bool is_new_load = !(std::abs(carried_on) < 0.5 * product);
    for (std::size_t i = 0; i < x_.size(); ++i)
        direction_[i] = solved_[i] + (is_new_load ? 0 : kept) * direction_[i].cwiseProduct(free_[i]);
    if (!(dot(free_residual_, direction_) > 0)) direction_ = solved_;
    last_residual_ = free_residual_;
    last_product_ = product;
}

}  // namespace tissue
