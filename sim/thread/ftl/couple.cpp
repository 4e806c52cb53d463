#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/thread/stages.hpp"

namespace sim::thread {

using Mat3 = Eigen::Matrix3d;

// What a push at a row does to the lengths of the links around it: per link a vector, its scalar product with the push.
static void add_effect(const State& state, PushedRow& row, int node, double weight) {
    const auto add = [&](int link, double sign) {
        if (link < 0 || link >= state.links()) return;
        const Vec3 change = sign * state.inverse_mass[at(node)] * weight * state.unit[at(link)];
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

static void measure_effects(const State& state, PushedRow& out) {
    const Row& row = *out.row;
    out.apart = apart_of(state, row);
    add_effect(state, out, row.link, 1 - row.s);
    add_effect(state, out, row.link + 1, row.s);
    if (row.against == Against::thread) {
        add_effect(state, out, row.other, row.t - 1);
        add_effect(state, out, row.other + 1, -row.t);
    }
}

// Forward and backward through the factors of the last length solve.
static void substitute(const State& state, std::vector<double>& x) {
    x[0] *= state.pivot[0];
    for (std::size_t k = 1; k < x.size(); ++k) x[k] = state.pivot[k] * (x[k] - state.lower[k] * x[k - 1]);
    for (std::size_t k = x.size() - 1; k-- > 0;) x[k] -= state.upper[k] * x[k + 1];
}

// The inverse of the lengths' symmetric tridiagonal matrix at the links that rows touch, from the factors of the last
// solve: its diagonal, and the share of an answer that reaches from each such link to the next.
static void invert_lengths(State& state) {
    std::vector<int>& touched = state.touched;
    touched.clear();
    for (const PushedRow& row : state.pushed_rows)
        touched.insert(touched.end(), row.link.begin(), row.link.begin() + row.links);
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (PushedRow& row : state.pushed_rows)
        for (int i = 0; i < row.links; ++i)
            row.place[at(i)] =
                static_cast<int>(std::lower_bound(touched.begin(), touched.end(), row.link[at(i)]) - touched.begin());

    state.inverse.resize(touched.size());
    double diagonal = 0, share = 1;
    std::size_t next = touched.size();
    for (std::size_t k = state.rest.size(); k-- > 0 && next > 0;) {
        diagonal = state.pivot[k] + state.upper[k] * state.upper[k] * diagonal;
        share *= -state.upper[k];
        if (touched[next - 1] != static_cast<int>(k)) continue;
        state.inverse[--next] = {diagonal, share};
        share = 1;
    }
}

// How the multipliers of those lengths answer a unit push at each row along each axis: a column an axis.
static void answer(State& state) {
    const auto& inverse = state.inverse;
    const auto places = static_cast<Eigen::Index>(inverse.size()), columns = state.pushes.size();
    auto effects = state.effects.resized(places, columns), answers = state.answers.resized(places, columns);
    effects.setZero();
    for (std::size_t c = 0; c < state.pushed_rows.size(); ++c) {
        const PushedRow& row = state.pushed_rows[c];
        for (int i = 0; i < row.links; ++i)
            effects.block<1, 3>(row.place[at(i)], axes(c)) = row.effect[at(i)].transpose();
    }
    for (Eigen::Index a = places; a-- > 0;) {
        answers.row(a) = inverse[static_cast<std::size_t>(a)].diagonal * effects.row(a);
        if (a + 1 < places) answers.row(a) += inverse[static_cast<std::size_t>(a)].share * answers.row(a + 1);
    }
    auto& from_left = state.answer_from_left;
    from_left.setZero(columns);
    for (Eigen::Index a = 0; a < places; ++a) {
        answers.row(a) += inverse[static_cast<std::size_t>(a)].diagonal * from_left;
        from_left = inverse[static_cast<std::size_t>(a)].share * (from_left + effects.row(a));
    }
}

// What a push at `row` does to the points of every row from it on where they share nodes.
static void add_direct(State& state, std::size_t d, Eigen::Map<Table::Matrix>& responses) {
    const std::vector<PushedRow>& rows = state.pushed_rows;
    std::vector<double>& weight_at = state.weight_at;
    for (int i = 0; i < rows[d].nodes; ++i)
        weight_at[at(rows[d].node[at(i)])] += state.inverse_mass[at(rows[d].node[at(i)])] * rows[d].weight[at(i)];
    for (std::size_t c = d; c < rows.size(); ++c) {
        double direct = 0;
        for (int i = 0; i < rows[c].nodes; ++i) direct += weight_at[at(rows[c].node[at(i)])] * rows[c].weight[at(i)];
        if (direct != 0) responses.block<3, 3>(axes(d), axes(c)).diagonal().array() += direct;
    }
    for (int i = 0; i < rows[d].nodes; ++i) weight_at[at(rows[d].node[at(i)])] = 0;
}

// The rows that move the thread most; what is left out is met by the passes before and after.
static void collect(State& state) {
    const double about_to_push = 0.05 * state.def.radius;  // of the answer's size where knots are tight
    std::vector<PushedRow>& rows = state.pushed_rows;
    rows.clear();
    for (Row& row : state.rows)
        if (!row.glides && (row.normal_push > 0 || row.distance < row.target + about_to_push) && row.mobility > 0)
            rows.emplace_back(row);
    const auto matters = [](const PushedRow& r) {
        return std::max(r.row->normal_push * r.row->mobility, r.row->target - r.row->distance);
    };
    if (rows.size() > most_coupled) {
        std::sort(rows.begin(), rows.end(), [&](const PushedRow& a, const PushedRow& b) {
            return matters(a) != matters(b) ? matters(a) > matters(b) : a.row < b.row;
        });
        rows.erase(rows.begin() + most_coupled, rows.end());
    }
    for (PushedRow& row : rows) measure_effects(state, row);
}

// Times a slip across the normal: the push that would undo it, if `own` is how the points give way to pushes. A strand
// gives way easily across itself and hardly along itself. A matrix of a plane's two axes has the inverse (trace -
// itself) / determinant: of no axes but the scene's, so that a mirrored knot pushes alike to the last bit.
static Mat3 push_against(const Vec3& normal, const Mat3& own, double least) {
    const Mat3 across = Mat3::Identity() - normal * normal.transpose(), gives = across * own * across + least * across;
    const double trace = gives.trace(), determinant = 0.5 * (trace * trace - gives.squaredNorm());
    return (gives - trace * across) / determinant;
}

static void measure_own(State& state, std::size_t c, const Eigen::Map<Table::Matrix>& responses) {
    PushedRow& row = state.pushed_rows[c];
    row.own = responses.block<3, 3>(axes(c), axes(c));
    // However long the strand that must come along: all of it gives way by no less than this.
    const double least = row.row->mobility / (10.0 * static_cast<double>(state.nodes.size()));
    row.mobility = std::max(least, row.row->normal.dot(row.own * row.row->normal));
    row.against = push_against(row.row->normal, row.own, least);
}

// How far the points of each row move apart for a unit push at each other if all links keep their lengths. Symmetric:
// what a push at one row does to another, it does in return.
static void measure_responses(State& state) {
    const std::vector<PushedRow>& rows = state.pushed_rows;
    const Eigen::Index columns = axes(rows.size());
    state.pushes.setZero(columns);
    invert_lengths(state);
    answer(state);
    const auto answers = state.answers.resized(static_cast<Eigen::Index>(state.inverse.size()), columns);
    auto responses = state.responses.resized(columns, columns);
    responses.setZero();
    for (std::size_t d = 0; d < rows.size(); ++d) {
        const Eigen::Index others = columns - axes(d);
        for (int i = 0; i < rows[d].links; ++i)
            responses.block<3, Eigen::Dynamic>(axes(d), axes(d), 3, others).noalias() -=
                rows[d].effect[at(i)] * answers.row(rows[d].place[at(i)]).tail(others);
        add_direct(state, d, responses);
        for (std::size_t c = 0; c < d; ++c)
            responses.block<3, 3>(axes(d), axes(c)) = responses.block<3, 3>(axes(c), axes(d)).transpose();
        measure_own(state, d, responses);
    }
}

// One row of a sweep; returns its overlap before, 1 where it is small enough.
static double push(State& state, std::size_t c, const Eigen::Map<Table::Matrix>& responses) {
    const PushedRow& pushed = state.pushed_rows[c];
    Row& row = *pushed.row;
    const Vec3 apart = pushed.apart + responses.middleRows<3>(axes(c)) * state.pushes;
    const double distance = apart.dot(row.normal);
    if (distance >= row.target && row.normal_push == 0) return 0;
    const Vec3 normal = add_normal_push(row, apart, pushed.mobility) * row.normal;
    const Vec3 slip = slip_of(row, apart + pushed.own * normal);
    state.pushes.segment<3>(axes(c)) += normal + add_tangent_push(row, slip, pushed.against * slip);
    return std::max(over_goal(state, row, distance), row.slip / (slip_goal * 2 * state.def.radius));
}

static double sweep(State& state) {
    const auto responses = state.responses.resized(state.pushes.size(), state.pushes.size());
    double worst = 0;
    for (std::size_t c = 0; c < state.pushed_rows.size(); ++c) worst = std::max(worst, push(state, c, responses));
    return worst;
}

static void add_to_row(Row& row, const Vec3& push) {
    const double normal = push.dot(row.normal);
    row.normal_push += normal;
    row.tangent_push += push - normal * row.normal;
}

static void go_on_by(State& state, double again) {
    state.way *= again;
    state.pushes += state.way;
    for (std::size_t c = 0; c < state.pushed_rows.size(); ++c)
        add_to_row(*state.pushed_rows[c].row, state.way.segment<3>(axes(c)));
}

// Where rows of a knot work against each other sweeps alone gain a little less each time, for hundreds of times. What
// each gains is carried on as by nonlinear conjugate gradients [Silcowitz, Niebe and Erleben 2010, algorithm 1], and
// twenty are enough. A sweep is always last, so that no push leaves its cone.
static double solve_pushes(State& state) {
    constexpr int most_sweeps = 20;
    constexpr double small_enough = 0.3;  // a sweep's overlap is from before it
    double worst = 0, size_before = 0;
    state.way.setZero(state.pushes.size());
    for (int i = 1; i <= most_sweeps; ++i) {
        state.pushes_before = state.pushes;
        worst = sweep(state);
        if (worst < small_enough) break;
        state.gain = state.pushes - state.pushes_before;
        const double size = state.gain.squaredNorm();
        if (size < size_before && i < most_sweeps)
            go_on_by(state, size / size_before);
        else
            state.way.setZero();
        state.way += state.gain;
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

// All pushes at once, and what the lengths answer to them to first order. The pushes alone can be large where a taut
// strand lies on something: only what remains of them after the lengths have answered is a motion.
static void move_by_pushes(State& state) {
    std::vector<Vec3>& move = state.coupled_move;
    std::vector<double>& change = state.multiplier;
    move.assign(state.nodes.size(), Vec3::Zero());
    std::fill(change.begin(), change.end(), 0.0);
    for (std::size_t c = 0; c < state.pushed_rows.size(); ++c) {
        const PushedRow& row = state.pushed_rows[c];
        const Vec3 push = state.pushes.segment<3>(axes(c));
        for (int i = 0; i < row.links; ++i) change[at(row.link[at(i)])] += row.effect[at(i)].dot(push);
        for (int i = 0; i < row.nodes; ++i)
            move[at(row.node[at(i)])] += state.inverse_mass[at(row.node[at(i)])] * row.weight[at(i)] * push;
    }
    substitute(state, change);
    for (std::size_t k = 0; k < change.size(); ++k) {
        const Vec3 pull = change[k] * state.unit[k];
        move[k] += state.inverse_mass[k] * pull;
        move[k + 1] -= state.inverse_mass[k + 1] * pull;
    }
    const double share = share_within_bounds(state, move);
    for (std::size_t i = 0; i < move.size(); ++i) state.nodes[i] += share * move[i];
    for (std::size_t k = 0; k < change.size(); ++k) state.pulled[k] -= share * change[k];
    for (std::size_t c = 0; c < state.pushed_rows.size(); ++c)
        add_to_row(*state.pushed_rows[c].row, (share - 1) * state.pushes.segment<3>(axes(c)));
}

double couple(State& state) {
    collect(state);
    measure_responses(state);
    const double worst = solve_pushes(state);
    move_by_pushes(state);
    return worst;
}

}  // namespace sim::thread
