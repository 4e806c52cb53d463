// One step of a wall.
//
// What is solved: the minimum of the incremental energy of implicit Euler without inertia: elastic energy, plus what
// damping takes, less the work of the forces.
// Method: quasi-Newton descent with exact line search. The direction is a nonlinear conjugate gradient (Polak and
// Ribiere) whose preconditioner is Newton's stiffness of some steps ago, rotated along with the wall (direction.cpp);
// it is assembled and factored (Cholesky) a slice a step (stiffness.cpp). Along the direction the energy is a
// polynomial of degree six, so its lowest point is found without another look at the wall (descent.cpp). Why this one:
// every step is as short as the next, and the energy never rises, however stiff or old the preconditioner. Source:
// material of Smith, de Goes and Kim 2018, Stable Neo-Hookean Flesh Simulation; preconditioners that lag behind as in
// Nocedal and Wright 2006, Numerical Optimization, chapters 5 and 7. Cost: one to four solves with the factors, a slice
// of a factorisation, and passes over cells and nodes.
#include "tissue/tissue.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tissue/by_nodes.hpp"

namespace tissue {

namespace {

std::vector<std::array<int, 2>> couplings(std::span<const Cells> all) {
    std::vector<std::array<int, 2>> found;
    for (const Cells& cells : all)
        for (std::size_t k = 0; k < cells.used; ++k)
            for (std::size_t b = 0; b < cells.count; ++b)
                for (std::size_t a = 0; a < b; ++a) found.push_back({cells.nodes[a][k], cells.nodes[b][k]});
    return found;
}

}  // namespace

Tissue::Tissue(const Material& material, Mesh mesh, const Solver& solver)
    : rest_(std::move(mesh)),
      material_(material),
      solver_(solver),
      laplacian_(rest_),
      cells_(cells_of(rest_)),
      mass_(rest_.nodes.size()),
      x_(rest_.nodes),
      matrix_(static_cast<int>(x_.size()), couplings(cells_)) {
    assert(!rest_.tetrahedra.empty() && "a wall of something");
    assert(material_.young > 0 && material_.bulk_over_shear >= 10 && material_.density >= 0 &&
           material_.relaxation >= 0 && material_.slowing > 0);
    assert(solver_.iterations >= 1 && solver_.steps_per_factor >= 0 && solver_.tolerance >= 0);
    for (const Tetrahedron& tet : rest_.tetrahedra)
        for (const int i : tet)
            mass_[static_cast<std::size_t>(i)] += 0.25 * material_.density * volume(tet, rest_.nodes);
    const std::size_t n = x_.size();
    for (std::vector<Vec3>* nodes :
         {&v_, &before_, &outside_, &lx_, &lx_before_, &ldirection_, &residual_, &free_residual_, &direction_,
          &last_residual_, &solved_, &left_, &next_, &factored_pull_, &pull_})
        nodes->assign(n, Vec3::Zero());
    for (std::vector<PointForce>* forces : {&stiff_, &factored_stiff_, &used_stiff_})
        forces->reserve(rest_.faces.size());
    free_.assign(n, Vec3::Ones());
    factored_x_ = x_, factored_free_ = free_;
    volumes_.resize(cells_.size()), factored_volumes_ = used_volumes_ = volumes_;
    strain_.resize(n);
    swelling_.assign(cells_.size(), Lane()), factored_pressure_ = swelling_;
    along_.resize(cells_.size());
    cell_places_.resize(cells_.size()), own_places_.resize(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c)
        for (std::size_t k = 0; k < cells_[c].used; ++k)
            for (std::size_t b = 0; b < cells_[c].count; ++b) {
                const auto& nodes = cells_[c].nodes;
                own_places_[c][k][b] = matrix_.place(nodes[b][k], nodes[b][k]);
                for (std::size_t a = 0; a < b; ++a)
                    cell_places_[c][k][pair(a, b)] = matrix_.place(nodes[a][k], nodes[b][k]);
            }
    for (int i = 0; i < static_cast<int>(n); ++i) {
        auto& places = row_places_.emplace_back();
        for (const int j : laplacian_.neighbours(i)) places.push_back(matrix_.place(i, j));
    }
}

void Tissue::place(std::span<const Vec3> nodes) {
    assert(nodes.size() == x_.size() && "one place for each node");
    x_.assign(nodes.begin(), nodes.end());
    v_.assign(x_.size(), Vec3::Zero());
    for (std::size_t c = 0; c < cells_.size(); ++c)
        swelling_[c] = volumes(cells_[c], x_).value / cells_[c].rest_volume - Lane(1);
    have_factors_ = factoring_ = false;
    last_product_ = 0;
}

Vec3 Tissue::carried(const MaterialPoint& point, std::span<const Vec3> by_nodes) const {
    const Tetrahedron& tet = rest_.tetrahedra[static_cast<std::size_t>(point.tetrahedron)];
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) sum += point.weights[k] * by_nodes[static_cast<std::size_t>(tet[k])];
    return sum;
}

Vec3 Tissue::position(const MaterialPoint& point) const {
    return carried(point, x_);
}

// The elastic energy is zero without strain, where F is 1 and |F|^2 is 3.
double Tissue::energy() const {
    std::vector<Vec3> lx;
    laplacian_.multiply(x_, lx);
    double sum = 0.5 * material_.shear() * dot(x_, lx);
    for (const Cells& cells : cells_) {
        const Lane swelling = volumes(cells, x_).value / cells.rest_volume - Lane(1);
        Lane energies = cells.rest_volume *
                        (0.5 * material_.bulk() * swelling * swelling - material_.shear() * (swelling + Lane(1.5)));
        energies.clear_from(cells.used);
        sum += energies.sum();
    }
    return sum;
}

void Tissue::apply_holds(std::span<const Hold> holds) {
    free_.assign(x_.size(), Vec3::Ones());
    for (const Hold& hold : holds) {
        assert(hold.node >= 0 && static_cast<std::size_t>(hold.node) < x_.size() && hold.target.allFinite() &&
               "a hold of a node that exists, to a finite place");
        for (Eigen::Index k = 0; k < 3; ++k) {
            if (!hold.along[static_cast<std::size_t>(k)]) continue;
            const auto i = static_cast<std::size_t>(hold.node);
            free_[i][k] = 0;
            x_[i][k] = hold.target[k];
        }
    }
}

void Tissue::add_forces(std::span<const PointForce> forces) {
    outside_.assign(x_.size(), Vec3::Zero());
    stiff_.clear();
    for (const PointForce& force : forces) {
        assert(force.at.tetrahedron >= 0 && static_cast<std::size_t>(force.at.tetrahedron) < rest_.tetrahedra.size() &&
               force.force.allFinite() && "a finite force at a point of this wall");
        share(rest_.tetrahedra[static_cast<std::size_t>(force.at.tetrahedron)], force.at.weights, force.force,
              outside_);
        if (force.stiffness > 0) stiff_.push_back(force);
    }
}

void Tissue::add_pressure(double pressure) {
    if (pressure == 0) return;
    for (const Face& face : rest_.faces) {
        if (face.side != Side::inner) continue;
        const auto at = [&](std::size_t k) -> const Vec3& { return x_[static_cast<std::size_t>(face.nodes[k])]; };
        const Vec3 share = -pressure / 6 * (at(1) - at(0)).cross(at(2) - at(0));
        for (const int i : face.nodes) outside_[static_cast<std::size_t>(i)] += share;
    }
}

// The residual is minus the derivative of the incremental energy by each node.
void Tissue::find_residual() {
    const double mu = material_.shear(), viscous = material_.viscosity() * rate_;
    for (std::size_t i = 0; i < x_.size(); ++i)
        residual_[i] =
            outside_[i] - mu * lx_[i] - viscous * (lx_[i] - lx_before_[i]) - drag_ * mass_[i] * (x_[i] - before_[i]);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const Cells& cells = cells_[c];
        volumes_[c] = volumes(cells, x_);
        swelling_[c] = volumes_[c].value / cells.rest_volume - Lane(1);
        const Lane p = pressure(c);
        for (std::size_t n = 0; n < cells.count; ++n) {
            const Lanes force = p * volumes_[c].gradient[n];
            for (std::size_t k = 0; k < cells.used; ++k)
                residual_[static_cast<std::size_t>(cells.nodes[n][k])] -= Vec3(force.x[k], force.y[k], force.z[k]);
        }
    }
    add_lost(stiff_, -1, x_, residual_), add_lost(stiff_, 1, before_, residual_);
    for (std::size_t i = 0; i < x_.size(); ++i) free_residual_[i] = residual_[i].cwiseProduct(free_[i]);
}

Descent Tissue::energy_along_direction() {
    laplacian_.multiply(direction_, ldirection_);
    double drag = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) drag += drag_ * mass_[i] * direction_[i].squaredNorm();
    double stiff = 0;
    for (const PointForce& force : stiff_) {
        const Vec3 gone = carried(force.at, direction_);
        stiff += gone.dot(force.lost(gone));
    }
    std::array<Lane, 5> more;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const Cells& cells = cells_[c];
        const auto [second, third] = bulge(cells, x_, direction_);
        Lane first;
        for (std::size_t n = 0; n < cells.count; ++n)
            first += dot(volumes_[c].gradient[n], gathered(cells, n, direction_));
        along_[c] = {first / cells.rest_volume, second / cells.rest_volume, third / cells.rest_volume};
        Lane p = pressure(c), k = Lane(material_.bulk()) / cells.rest_volume;
        p.clear_from(cells.used), k.clear_from(cells.used);
        more[0] += p * second + 0.5 * k * first * first;
        more[1] += p * third + k * first * second;
        more[2] += k * (0.5 * second * second + first * third);
        more[3] += k * second * third;
        more[4] += 0.5 * k * third * third;
    }
    Descent energy{
        -dot(free_residual_, direction_),
        0.5 * ((material_.shear() + material_.viscosity() * rate_) * dot(direction_, ldirection_) + drag + stiff)};
    for (std::size_t k = 0; k < more.size(); ++k) energy[k + 1] += more[k].sum();
    return energy;
}

void Tissue::go_along_direction(double far) {
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += far * direction_[i], lx_[i] += far * ldirection_[i];
    for (std::size_t c = 0; c < cells_.size(); ++c)
        swelling_[c] += far * (along_[c][0] + far * (along_[c][1] + far * along_[c][2]));
}

Report Tissue::step(const Input& input, double seconds) {
    assert(seconds > 0 && "a step that takes time");
    Report report;
    rate_ = 1 / seconds;
    before_ = x_;
    laplacian_.multiply(x_, lx_before_);
    drag_ = rate_ / material_.slowing;
    apply_holds(input.holds);
    add_forces(input.forces);
    add_pressure(input.pressure);
    laplacian_.multiply(x_, lx_);
    const bool newton = solver_.steps_per_factor == 0;
    if (!have_factors_) factor_at_once();
    for (int i = 0; i < solver_.iterations; ++i) {
        find_residual();
        report.residual = 0;
        for (const Vec3& force : free_residual_) report.residual = std::max(report.residual, force.norm());
        if (report.residual <= solver_.tolerance) break;
        if (newton) factor_at_once();
        find_direction(newton);
        const Descent energy = energy_along_direction();
        const double far = lowest(energy);
        go_along_direction(far);
        double power = 1;
        report.energy_change = 0;
        for (const double coefficient : energy) report.energy_change += coefficient * (power *= far);
        ++report.iterations;
    }
    for (std::size_t i = 0; i < x_.size(); ++i) v_[i] = rate_ > 0 ? Vec3(rate_ * (x_[i] - before_[i])) : Vec3::Zero();
    if (!newton) go_on_factoring((matrix_.work() + assembly_work()) / solver_.steps_per_factor);
    return report;
}

}  // namespace tissue
