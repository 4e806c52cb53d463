// Which way a wall goes in a move.
#include <algorithm>
#include <cmath>

#include "tissue/by_nodes.hpp"
#include "tissue/tissue.hpp"

namespace tissue {

// Mean gradient of cells, and of the cells about a node, with respect to where nodes were when the stiffness was found:
// as that is, column by column.
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

// M^-1 of what pushes, where M is the stiffness that is factored, drawn along.
void Tissue::soften(std::span<const Vec3> push, std::vector<Vec3>& to) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Lane force(push[i].x(), push[i].y(), push[i].z(), 0);
        to[i] = Vec3((strain_[i][0] * force).sum(), (strain_[i][1] * force).sum(), (strain_[i][2] * force).sum());
    }
    matrix_.solve(to);
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Lane by = strain_[i][0] * to[i].x() + strain_[i][1] * to[i].y() + strain_[i][2] * to[i].z();
        to[i] = Vec3(by[0], by[1], by[2]).cwiseProduct(free_[i]);
    }
}

void Tissue::add_lost(std::span<const PointForce> forces, double times, std::span<const Vec3> way,
                      std::vector<Vec3>& to) const {
    for (const PointForce& force : forces)
        share(rest_.tetrahedra[static_cast<std::size_t>(force.at.tetrahedron)], force.at.weights,
              times * force.lost(carried(force.at, way)), to);
}

// Solved with the stiffness of today's forces for that of those the factors know, by conjugate gradients, each a solve:
// few differ, so few do. M times the way is what was solved for, so that M is never needed.
void Tissue::find_solved() {
    soften(push_, solved_);
    if (stiff_.empty() && used_stiff_.empty()) return;
    constexpr int most = 3;          // solves more
    constexpr double enough = 1e-4;  // a hundredth of the way, squared: the lowest point along it makes up for it; and
                                     // of what pushes, that hardly anything is left
    left_ = push_, next_ = solved_, along_way_ = push_;
    solved_.assign(x_.size(), Vec3::Zero());
    const double all = dot(left_, next_);
    double product = all;
    std::vector<Vec3>& softened = lway_;  // not known yet
    for (int k = 0;; ++k) {
        pull_ = along_way_;  // the whole stiffness times the way
        add_lost(stiff_, 1, next_, pull_);
        add_lost(used_stiff_, -1, next_, pull_);
        const double curvature = dot(pull_, next_);
        if (!(curvature > 0)) break;
        const double far = product / curvature;
        for (std::size_t i = 0; i < x_.size(); ++i)
            solved_[i] += far * next_[i], left_[i] = (left_[i] - far * pull_[i]).cwiseProduct(free_[i]);
        if (k == most || dot(left_, left_) <= enough * enough * dot(push_, push_)) break;
        soften(left_, softened);
        const double now = dot(left_, softened), kept = now / product;
        if (!(now > enough * all)) break;
        for (std::size_t i = 0; i < x_.size(); ++i)
            next_[i] = softened[i] + kept * next_[i], along_way_[i] = left_[i] + kept * along_way_[i];
        product = now;
    }
    if (!(dot(push_, solved_) > 0)) soften(push_, solved_);
}

// Nonlinear conjugate gradients (Polak and Ribiere) with the factored stiffness for a metric. At the lowest point of
// the last way nothing pushes along it; where something does, the load is new, and the last way may be mere rounding.
void Tissue::find_way(bool afresh) {
    find_strain();
    find_solved();
    const double product = dot(push_, solved_),
                 kept = afresh || last_product_ <= 0
                            ? 0
                            : std::max(0.0, (product - dot(last_push_, solved_)) / last_product_);
    const double carried_on = kept * dot(push_, way_);
    const bool is_new_load = !(std::abs(carried_on) < 0.5 * product);
    for (std::size_t i = 0; i < x_.size(); ++i)
        way_[i] = solved_[i] + (is_new_load ? 0 : kept) * way_[i].cwiseProduct(free_[i]);
    if (!(dot(push_, way_) > 0)) way_ = solved_;
    last_push_ = push_;
    last_product_ = product;
}

}  // namespace tissue
