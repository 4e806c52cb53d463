#include "sim/thread/ftl/coupled_solver.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"

// Where one strand drags a long one by a single crossing, passes over contacts and lengths in turn move the crossing by
// the share of one link in the whole strand each. Here the rows that push are solved with all lengths at once: the
// lengths, whose matrix is tridiagonal, are eliminated (Schur complement on the contacts), and the dense remainder of
// at most 3 * 64 unknowns is solved with Coulomb's cones by projected Gauss-Seidel, its sweeps carried on as by
// nonlinear conjugate gradients [Silcowitz, Niebe and Erleben 2010].

namespace sim::thread::ftl {

using Mat3 = Eigen::Matrix3d;

CoupledSolver::CoupledSolver(std::size_t most_links) {
    pushed_.reserve(8 * most_links);
    delassus_.resized(3 * most_rows, 3 * most_rows);
    for (Table* of_links : {&effects_, &multipliers_}) of_links->resized(8 * most_rows, 3 * most_rows);
    touched_.reserve(8 * most_rows);
    inverse_.reserve(8 * most_rows);
    move_.reserve(most_links + 1);
    weight_at_.reserve(most_links + 1);
    change_.reserve(most_links);
}

// What a push at a row does to the lengths of the links around it: per link a vector, its scalar product with the push.
void CoupledSolver::add_effect(const State& state, const LengthSolver& lengths, PushedRow& row, int node,
                               double weight) const {
    const auto add = [&](int link, double sign) {
        if (link < 0 || link >= state.links()) return;
        const Vec3 change = sign * state.inverse_mass[at(node)] * weight * lengths.unit(at(link));
        for (int i = 0; i < row.links; ++i)
            if (row.link[at(i)] == link) {
                row.effect[at(i)] += change;
                return;
            }
        row.link[at(row.links)] = link;
        row.effect[at(row.links++)] = change;
    };
    row.node[at(row.nodes)] = node;
    row.weight[at(row.nodes++)] = weight;
    add(node - 1, 1);
    add(node, -1);
}

void CoupledSolver::measure_effects(const State& state, const LengthSolver& lengths, PushedRow& out) const {
    const Row& row = *out.row;
    out.apart = apart_of(state, row);
    add_effect(state, lengths, out, row.link, 1 - row.s);
    add_effect(state, lengths, out, row.link + 1, row.s);
    if (row.against == Against::thread) {
        add_effect(state, lengths, out, row.other, row.t - 1);
        add_effect(state, lengths, out, row.other + 1, -row.t);
    }
}

// The inverse of the lengths' symmetric tridiagonal matrix at the links that rows touch, from the factors of the last
// solve: its diagonal, and the share of a solution that reaches from each such link to the next.
void CoupledSolver::invert_lengths(const State& state, const LengthSolver& lengths) {
    std::vector<int>& touched = touched_;
    touched.clear();
    for (const PushedRow& row : pushed_) touched.insert(touched.end(), row.link.begin(), row.link.begin() + row.links);
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (PushedRow& row : pushed_)
        for (int i = 0; i < row.links; ++i)
            row.place[at(i)] =
                static_cast<int>(std::lower_bound(touched.begin(), touched.end(), row.link[at(i)]) - touched.begin());

    inverse_.resize(touched.size());
    double diagonal = 0, share = 1;
    std::size_t next = touched.size();
    for (std::size_t k = state.rest_length.size(); k-- > 0 && next > 0;) {
        diagonal = lengths.pivot(k) + lengths.upper(k) * lengths.upper(k) * diagonal;
        share *= -lengths.upper(k);
        if (touched[next - 1] != static_cast<int>(k)) continue;
        inverse_[--next] = {diagonal, share};
        share = 1;
    }
}

// How the multipliers of those lengths respond to a unit push at each row along each axis: a column an axis.
void CoupledSolver::find_multipliers() {
    const auto& inverse = inverse_;
    const auto places = static_cast<Eigen::Index>(inverse.size()), columns = pushes_.size();
    auto effects = effects_.resized(places, columns), multipliers = multipliers_.resized(places, columns);
    effects.setZero();
    for (std::size_t c = 0; c < pushed_.size(); ++c) {
        const PushedRow& row = pushed_[c];
        for (int i = 0; i < row.links; ++i)
            effects.block<1, 3>(row.place[at(i)], axes(c)) = row.effect[at(i)].transpose();
    }
    for (Eigen::Index a = places; a-- > 0;) {
        multipliers.row(a) = inverse[static_cast<std::size_t>(a)].diagonal * effects.row(a);
        if (a + 1 < places) multipliers.row(a) += inverse[static_cast<std::size_t>(a)].share * multipliers.row(a + 1);
    }
    auto& from_left = from_left_;
    from_left.setZero(columns);
    for (Eigen::Index a = 0; a < places; ++a) {
        multipliers.row(a) += inverse[static_cast<std::size_t>(a)].diagonal * from_left;
        from_left = inverse[static_cast<std::size_t>(a)].share * (from_left + effects.row(a));
    }
}

// What a push at `row` does to the points of every row from it on where they share nodes.
void CoupledSolver::add_direct(const State& state, std::size_t d, Eigen::Map<Table::Matrix>& delassus) {
    const std::vector<PushedRow>& rows = pushed_;
    std::vector<double>& weight_at = weight_at_;
    for (int i = 0; i < rows[d].nodes; ++i)
        weight_at[at(rows[d].node[at(i)])] += state.inverse_mass[at(rows[d].node[at(i)])] * rows[d].weight[at(i)];
    for (std::size_t c = d; c < rows.size(); ++c) {
        double direct = 0;
        for (int i = 0; i < rows[c].nodes; ++i) direct += weight_at[at(rows[c].node[at(i)])] * rows[c].weight[at(i)];
        if (direct != 0) delassus.block<3, 3>(axes(d), axes(c)).diagonal().array() += direct;
    }
    for (int i = 0; i < rows[d].nodes; ++i) weight_at[at(rows[d].node[at(i)])] = 0;
}

// The rows that move the thread most; what is left out is met by the passes before and after.
void CoupledSolver::collect(State& state, const LengthSolver& lengths) {
    const double about_to_push = 0.05 * state.def.radius;  // of the solution's size where knots are tight
    std::vector<PushedRow>& rows = pushed_;
    rows.clear();
    for (Row& row : state.rows)
        if (!row.in_wrap && (row.normal_push > 0 || row.distance < row.target + about_to_push) && row.mobility > 0)
            rows.emplace_back(row);
    const auto matters = [](const PushedRow& r) {
        return std::max(r.row->normal_push * r.row->mobility, r.row->target - r.row->distance);
    };
    if (rows.size() > most_rows) {
        std::sort(rows.begin(), rows.end(), [&](const PushedRow& a, const PushedRow& b) {
            return matters(a) != matters(b) ? matters(a) > matters(b) : a.row < b.row;
        });
        rows.erase(rows.begin() + most_rows, rows.end());
    }
    for (PushedRow& row : rows) measure_effects(state, lengths, row);
}

// Times a slip across the normal: the push that would undo it, if `own` is the compliance of its points. A strand is
// compliant across itself and hardly along itself. A matrix of a plane's two axes has the inverse (trace -
// itself) / determinant: of no axes but the scene's, so that a mirrored knot pushes alike to the last bit.
static Mat3 push_against(const Vec3& normal, const Mat3& own, double least) {
    const Mat3 across = Mat3::Identity() - normal * normal.transpose(),
               compliance = across * own * across + least * across;
    const double trace = compliance.trace(), determinant = 0.5 * (trace * trace - compliance.squaredNorm());
    return (compliance - trace * across) / determinant;
}

void CoupledSolver::measure_diagonal_block(const State& state, std::size_t c,
                                           const Eigen::Map<Table::Matrix>& delassus) {
    PushedRow& row = pushed_[c];
    row.diagonal_block = delassus.block<3, 3>(axes(c), axes(c));
    // However long the strand that must come along: all of it has no less compliance than this.
    const double least = row.row->mobility / (10.0 * static_cast<double>(state.nodes.size()));
    row.mobility = std::max(least, row.row->normal.dot(row.diagonal_block * row.row->normal));
    row.against = push_against(row.row->normal, row.diagonal_block, least);
}

// How far the points of each row move apart for a unit push at each other if all links keep their lengths. Symmetric:
// what a push at one row does to another, it does in return.
void CoupledSolver::measure_delassus(const State& state, const LengthSolver& lengths) {
    const std::vector<PushedRow>& rows = pushed_;
    const Eigen::Index columns = axes(rows.size());
    pushes_.setZero(columns);
    weight_at_.resize(state.nodes.size());
    invert_lengths(state, lengths);
    find_multipliers();
    const auto multipliers = multipliers_.resized(static_cast<Eigen::Index>(inverse_.size()), columns);
    auto delassus = delassus_.resized(columns, columns);
    delassus.setZero();
    for (std::size_t d = 0; d < rows.size(); ++d) {
        const Eigen::Index others = columns - axes(d);
        for (int i = 0; i < rows[d].links; ++i)
            delassus.block<3, Eigen::Dynamic>(axes(d), axes(d), 3, others).noalias() -=
                rows[d].effect[at(i)] * multipliers.row(rows[d].place[at(i)]).tail(others);
        add_direct(state, d, delassus);
        for (std::size_t c = 0; c < d; ++c)
            delassus.block<3, 3>(axes(d), axes(c)) = delassus.block<3, 3>(axes(c), axes(d)).transpose();
        measure_diagonal_block(state, d, delassus);
    }
}

// One row of a sweep; returns its overlap before, 1 where it is small enough.
double CoupledSolver::push(const State& state, std::size_t c, const Eigen::Map<Table::Matrix>& delassus) {
    const PushedRow& pushed = pushed_[c];
    Row& row = *pushed.row;
    const Vec3 apart = pushed.apart + delassus.middleRows<3>(axes(c)) * pushes_;
    const double distance = apart.dot(row.normal);
    if (distance >= row.target && row.normal_push == 0) return 0;
    const Vec3 normal = add_normal_push(row, apart, pushed.mobility) * row.normal;
    const Vec3 slip = contact::slip_of(row, apart + pushed.diagonal_block * normal);
    pushes_.segment<3>(axes(c)) += normal + add_tangent_push(row, slip, pushed.against * slip);
    return std::max(over_goal(state, row, distance), row.slip / (slip_goal * 2 * state.def.radius));
}

double CoupledSolver::sweep(const State& state) {
    const auto delassus = delassus_.resized(pushes_.size(), pushes_.size());
    double worst = 0;
    for (std::size_t c = 0; c < pushed_.size(); ++c) worst = std::max(worst, push(state, c, delassus));
    return worst;
}

static void add_to_row(Row& row, const Vec3& push) {
    const double normal = push.dot(row.normal);
    row.normal_push += normal;
    row.tangent_push += push - normal * row.normal;
}

void CoupledSolver::go_on_by(double again) {
    search_ *= again;
    pushes_ += search_;
    for (std::size_t c = 0; c < pushed_.size(); ++c) add_to_row(*pushed_[c].row, search_.segment<3>(axes(c)));
}

// Where rows of a knot work against each other sweeps alone gain a little less each time, for hundreds of times. What
// each gains is carried on as by nonlinear conjugate gradients [Silcowitz, Niebe and Erleben 2010, algorithm 1], and
// twenty are enough. A sweep is always last, so that no push leaves its cone.
double CoupledSolver::solve_pushes(const State& state) {
    constexpr int most_sweeps = 20;
    constexpr double small_enough = 0.3;  // a sweep's overlap is from before it
    double worst = 0, size_before = 0;
    search_.setZero(pushes_.size());
    for (int i = 1; i <= most_sweeps; ++i) {
        pushes_before_ = pushes_;
        worst = sweep(state);
        if (worst < small_enough) break;
        gain_ = pushes_ - pushes_before_;
        const double size = gain_.squaredNorm();
        if (size < size_before && i < most_sweeps)
            go_on_by(size / size_before);
        else
            search_.setZero();
        search_ += gain_;
        size_before = size;
    }
    return worst;
}

// A node clipped at its bound would stretch its links, which nothing here would mend: so all go as far as each may.
static double share_within_bounds(const State& state, const std::vector<Vec3>& move) {
    double share = 1;
    for (std::size_t i = 0; i < move.size(); ++i) {
        const Vec3 moved = state.nodes[i] - state.before[i];
        const double bound2 = state.bound[i] * state.bound[i], left = bound2 - moved.squaredNorm();
        if ((moved + share * move[i]).squaredNorm() <= bound2) continue;
        const double along = moved.dot(move[i]), size2 = move[i].squaredNorm();
        share = left > 0 ? (std::sqrt(along * along + size2 * left) - along) / size2 : 0;
    }
    return share;
}

// All pushes at once, and how the lengths respond to first order. The pushes alone can be large where a taut
// strand lies on something: only what remains of them after the lengths have answered is a motion.
void CoupledSolver::move_by_pushes(State& state, const LengthSolver& lengths) {
    std::vector<Vec3>& move = move_;
    std::vector<double>& change = change_;
    move.assign(state.nodes.size(), Vec3::Zero());
    change.assign(state.rest_length.size(), 0.0);
    for (std::size_t c = 0; c < pushed_.size(); ++c) {
        const PushedRow& row = pushed_[c];
        const Vec3 push = pushes_.segment<3>(axes(c));
        for (int i = 0; i < row.links; ++i) change[at(row.link[at(i)])] += row.effect[at(i)].dot(push);
        for (int i = 0; i < row.nodes; ++i)
            move[at(row.node[at(i)])] += state.inverse_mass[at(row.node[at(i)])] * row.weight[at(i)] * push;
    }
    lengths.substitute(change);
    for (std::size_t k = 0; k < change.size(); ++k) {
        const Vec3 pull = change[k] * lengths.unit(k);
        move[k] += state.inverse_mass[k] * pull;
        move[k + 1] -= state.inverse_mass[k + 1] * pull;
    }
    const double share = share_within_bounds(state, move);
    for (std::size_t i = 0; i < move.size(); ++i) state.nodes[i] += share * move[i];
    for (std::size_t k = 0; k < change.size(); ++k) state.pulled[k] -= share * change[k];
    for (std::size_t c = 0; c < pushed_.size(); ++c)
        add_to_row(*pushed_[c].row, (share - 1) * pushes_.segment<3>(axes(c)));
}

double CoupledSolver::solve(State& state, const LengthSolver& lengths) {
    collect(state, lengths);
    measure_delassus(state, lengths);
    const double worst = solve_pushes(state);
    move_by_pushes(state, lengths);
    return worst;
}

Vec3 CoupledSolver::foreseen(std::size_t c) {
    const auto delassus = delassus_.resized(pushes_.size(), pushes_.size());
    return pushed_[c].apart + delassus.middleRows<3>(axes(c)) * pushes_;
}

}  // namespace sim::thread::ftl
