#include <algorithm>

#include "sim/thread/state.hpp"

namespace sim::thread {

using Mat3 = Eigen::Matrix3d;

static std::size_t at(int i) { return static_cast<std::size_t>(i); }

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
template <typename Number>
static void substitute(const State& state, std::vector<Number>& x) {
    x[0] *= state.pivot[0];
    for (std::size_t k = 1; k < x.size(); ++k) x[k] = state.pivot[k] * (x[k] - state.lower[k] * x[k - 1]);
    for (std::size_t k = x.size() - 1; k-- > 0;) x[k] -= state.upper[k] * x[k + 1];
}

// How the multipliers of all lengths answer a unit push at a row along each axis, by the factors of the last solve.
static void answer(const State& state, const PushedRow& row, std::vector<Vec3>& multiplier) {
    std::fill(multiplier.begin(), multiplier.end(), Vec3::Zero());
    for (int i = 0; i < row.links; ++i) multiplier[at(row.link[at(i)])] = row.effect[at(i)];
    substitute(state, multiplier);
}

// How far the points of `row` move apart for a push at `other` if all links keep their lengths.
static Mat3 response(const State& state, const PushedRow& row, const PushedRow& other, const std::vector<Vec3>& multiplier) {
    double direct = 0;
    for (int i = 0; i < row.nodes; ++i)
        for (int j = 0; j < other.nodes; ++j)
            if (row.node[at(i)] == other.node[at(j)])
                direct += state.inverse_mass[at(row.node[at(i)])] * row.weight[at(i)] * other.weight[at(j)];
    Mat3 moved = direct * Mat3::Identity();
    for (int i = 0; i < row.links; ++i) moved -= row.effect[at(i)] * multiplier[at(row.link[at(i)])].transpose();
    return moved;
}

// The rows that move the thread most; what is left out is met by the passes before and after.
static void collect(State& state) {
    constexpr std::size_t most_rows = 32;
    std::vector<PushedRow>& rows = state.pushed_rows;
    rows.clear();
    for (Row& row : state.rows)
        if ((row.normal_push > 0 || row.distance < row.target) && row.mobility > 0) rows.emplace_back(row);
    const auto matters = [](const PushedRow& r) { return std::max(r.row->normal_push * r.row->mobility, r.row->target - r.row->distance); };
    if (rows.size() > most_rows) {
        std::sort(rows.begin(), rows.end(), [&](const PushedRow& a, const PushedRow& b) {
            return matters(a) != matters(b) ? matters(a) > matters(b) : a.row < b.row;
        });
        rows.erase(rows.begin() + most_rows, rows.end());
    }
    for (PushedRow& row : rows) measure_effects(state, row);
}

static void measure_responses(State& state) {
    const std::vector<PushedRow>& rows = state.pushed_rows;
    state.responses.resize(rows.size() * rows.size());
    state.answer.resize(state.rest.size());
    for (std::size_t d = 0; d < rows.size(); ++d) {
        answer(state, rows[d], state.answer);
        for (std::size_t c = 0; c < rows.size(); ++c) state.responses[d * rows.size() + c] = response(state, rows[c], rows[d], state.answer);
    }
}

// One row of a sweep; returns its overlap before, 1 where it is small enough.
static double push(State& state, std::size_t c) {
    std::vector<PushedRow>& rows = state.pushed_rows;
    PushedRow& row = rows[c];
    const Mat3* responses = &state.responses[c * rows.size()];
    const Mat3& own = responses[c];
    const double overlap = over_goal(state, *row.row, row.apart.dot(row.row->normal));
    // However long the strand that must come along: all of it gives way by no less than this.
    const double least = row.row->mobility / (10.0 * static_cast<double>(state.nodes.size()));
    const double mobility = std::max(least, row.row->normal.dot(own * row.row->normal));
    const Vec3 more = push_of(*row.row, row.apart, mobility, std::max(least, own.trace() - mobility));
    row.push += more;
    row.moved = (own * more).norm();
    for (std::size_t e = 0; e < rows.size(); ++e) rows[e].apart += responses[e] * more;
    return std::max(overlap, row.row->slip / (strand_goal * 2 * state.def.radius));
}

// All pushes at once, and what the lengths answer to them to first order. The pushes alone can be large where a taut strand
// lies on something: only what remains of them after the lengths have answered is a motion.
static void move_by_pushes(State& state) {
    std::vector<double>& change = state.multiplier;
    std::fill(change.begin(), change.end(), 0.0);
    for (const PushedRow& row : state.pushed_rows) {
        for (int i = 0; i < row.links; ++i) change[at(row.link[at(i)])] += row.effect[at(i)].dot(row.push);
        push_apart(state, *row.row, row.push);
    }
    substitute(state, change);
    for (std::size_t k = 0; k < change.size(); ++k) {
        const Vec3 pull = change[k] * state.unit[k];
        state.pulled[k] -= change[k];
        state.nodes[k] += state.inverse_mass[k] * pull;
        state.nodes[k + 1] -= state.inverse_mass[k + 1] * pull;
    }
}

double couple(State& state) {
    constexpr int most_sweeps = 20;
    std::vector<PushedRow>& rows = state.pushed_rows;
    collect(state);
    measure_responses(state);
    double worst = 0;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double most = 0;
        for (std::size_t c = 0; c < rows.size(); ++c) {
            const double overlap = push(state, c);
            if (sweep == 0) worst = std::max(worst, overlap);
            most = std::max(most, rows[c].moved);
        }
        if (most < 1e-3 * state.def.radius) break;
    }
    move_by_pushes(state);
    return worst;
}

}  // namespace sim::thread
