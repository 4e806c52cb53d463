#include "sim/thread/ftl/capstan_solver.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/geometry/at.hpp"

// Thread that lies along steel. Its tension presses every one of its links on the steel, and what they drag changes the
// tension (Euler's and Eytelwein's capstan): passes over contacts and lengths in turn hand that on by a link or two
// each, so a long wrap seems to hang. Here all lengths, pushes and friction of such contacts are one linear system: one
// Newton step with an active set of contacts, the ratio of friction that holds a stretch found by the secant method
// from step to step. Each link's part of the system meets only its neighbours', so it is a band matrix and solved
// directly: O(n).
namespace sim::thread::ftl {

namespace {

// Along the thread and the steel, towards its last node.
Vec3 tangent(const State& state, const Row& row) {
    const auto last = at(row.s == 1 && row.link + 2 <= state.links() ? row.link + 2 : row.link + 1);
    const Vec3 along = state.nodes[last] - state.nodes[at(row.link)];
    return (along - along.dot(row.normal) * row.normal).stableNormalized();
}

double depth(const State& state, const Row& row) {
    return row.target - apart_of(state, row).dot(row.normal);
}

bool presses(const State& state, const Row& row) {
    return row.pressed || row.normal_push + depth(state, row) / row.mobility > 0;
}

// Along a taut stretch of thread all slides or all holds: how much of Coulomb's friction it takes to hold is one
// number, found by the secant method; more than all of it slides.
void find_friction_ratio(State& state, std::span<const int> stretch) {
    const double still = 1e-3 * state.def.radius;
    double pushes = 0, slip = 0, ratio = 0, slip_before = 0, friction_ratio_before = 0;
    for (const int i : stretch) {
        const Row& row = state.rows[at(i)];
        const double push = std::max(0.0, row.normal_push);
        pushes += push;
        slip += push * slip_of(row, apart_of(state, row)).dot(tangent(state, row));
        ratio += push * row.friction_ratio;
        slip_before += push * row.slip_before;
        friction_ratio_before += push * row.friction_ratio_before;
    }
    if (pushes == 0 || std::abs(slip) < still * pushes) return;
    const double more_ratio = (ratio - friction_ratio_before) / pushes, more_slip = (slip - slip_before) / pushes;
    const double secant = ratio / pushes - slip / pushes * more_ratio / more_slip;
    const double next = more_ratio * more_slip < 0 ? std::clamp(secant, -1.0, 1.0) : std::copysign(1.0, slip);
    for (const int i : stretch) {
        Row& row = state.rows[at(i)];
        row.slip_before = slip / pushes;
        row.friction_ratio_before = ratio / pushes;
        row.friction_ratio = next;
    }
}

void find_friction_ratios(State& state) {
    const auto end = state.on_steel.end();
    const auto row_at = [&](int i) -> const Row& { return state.rows[at(i)]; };
    const auto is_part = [&](int i) { return row_at(i).mobility > 0 && presses(state, row_at(i)); };
    for (auto first = state.on_steel.begin(); first != end;) {
        auto last = first + 1;
        if (is_part(*first)) {
            while (last != end && is_next_link(row_at(last[-1]), row_at(*last)) && is_part(*last)) ++last;
            find_friction_ratio(state, {first, last});
        }
        first = last;
    }
}

// Friction across the thread is what it was and what undoes the slip, as far as the cone leaves room beside what it
// drags along.
Vec3 push_across(const State& state, const Row& row, const Vec3& along) {
    const Vec3 slip = slip_of(row, apart_of(state, row)), wanted = row.tangent_push - slip / row.mobility;
    const Vec3 across = wanted - wanted.dot(along) * along;
    const double size = across.norm(),
                 most = row.friction * row.normal_push * std::sqrt(1 - row.friction_ratio * row.friction_ratio);
    return size > most ? Vec3(most / size * across) : across;
}

// Links thrown about by a step too long may have no solution; what is left stretched makes tools wait.
void forget_pushes(State& state) {
    for (const int i : state.on_steel) {
        state.rows[at(i)].normal_push = 0;
        state.rows[at(i)].tangent_push.setZero();
    }
}

}  // namespace

CapstanSolver::CapstanSolver(std::size_t most_links) {
    for (auto* of_nodes : {&line_, &displaced_}) of_nodes->reserve(most_links + 1);
    stiff_.reserve(most_links + 1);
    unknowns_.reserve(2 * most_links);
    unknown_.reserve(2 * most_links);
    band_.reserve(2 * most_links);
}

// A taut strand is stiff across itself: a node that leaves its line by x is drawn back by x times tension over length
// on either side. Without that a small kink, drawn straight by what tension has grown, becomes a larger one.
void CapstanSolver::measure_stiffness(const State& state) {
    constexpr double share = 0.25;  // of what all neighbours at rest would make it; more damps what is to be found
    stiff_.assign(state.nodes.size(), 1.0);
    line_.assign(state.nodes.size(), Vec3::Zero());
    for (std::size_t i = 1; i + 1 < state.nodes.size(); ++i) {
        if (state.is_end(i)) continue;
        line_[i] = (state.nodes[i + 1] - state.nodes[i - 1]).stableNormalized();
        for (const std::size_t k : {i - 1, i})
            stiff_[i] += share * std::max({0.0, -state.pulled[k], -state.last.pulled[k]}) / state.rest_length[k];
    }
}

// How a node moves for a push.
Vec3 CapstanSolver::move_of(const State& state, int node, const Vec3& push) const {
    const Vec3& line = line_[at(node)];
    const Vec3 along = line.dot(push) * line;
    return state.inverse_mass[at(node)] * (along + (push - along) / stiff_[at(node)]);
}

void CapstanSolver::move_row(const State& state, const Row& row, const Vec3& push) {
    displaced_[at(row.link)] += (1 - row.s) * move_of(state, row.link, push);
    displaced_[at(row.link + 1)] += row.s * move_of(state, row.link + 1, push);
}

void CapstanSolver::change_push(const State& state, Row& row, double normal, const Vec3& tangent) {
    move_row(state, row, (normal - row.normal_push) * row.normal + tangent - row.tangent_push);
    row.normal_push = normal;
    row.tangent_push = tangent;
}

void CapstanSolver::add_contact(const State& state, Row& row) {
    constexpr double compliance =
        1e-2;  // beside a diagonal of 1: contacts that nearly say the same do not work against each other
    if (row.mobility == 0) return;
    const bool is_on = presses(state, row);
    row.pressed = false;
    if (!is_on) return change_push(state, row, 0, Vec3::Zero());
    const Vec3 along = tangent(state, row), drag = -row.friction * row.friction_ratio * along;
    change_push(state, row, row.normal_push, row.normal_push * drag + push_across(state, row, along));
    unknowns_.push_back({&row, row.link, {1 - row.s, row.s}, row.normal, row.normal + drag, compliance});
    unknown_.push_back(depth(state, row));
}

void CapstanSolver::add_length(const LengthSolver& lengths, int link) {
    constexpr double compliance = 1e-6;  // as lengths alone have it
    const Vec3& unit = lengths.unit(at(link));
    unknowns_.push_back({nullptr, link, {-1, 1}, unit, unit, compliance});
    unknown_.push_back(lengths.lack(at(link)));
}

// By links: the length, then what presses on it.
double CapstanSolver::collect(State& state, LengthSolver& lengths) {
    unknowns_.clear();
    unknown_.clear();
    const double worst = lengths.measure(state);
    auto row = state.on_steel.begin();
    for (int k = 0; k < state.links(); ++k) {
        add_length(lengths, k);
        if (row != state.on_steel.end() && state.rows[at(*row)].link == k) add_contact(state, state.rows[at(*row++)]);
    }
    return worst;
}

// How much of what `of` measures a unit of `by` brings.
double CapstanSolver::response(const State& state, const Unknown& of, const Unknown& by) const {
    double sum = 0;
    for (int a = 0; a < 2; ++a)
        if (const int b = of.link + a - by.link; b == 0 || b == 1)
            sum += of.weight[at(a)] * by.weight[at(b)] * of.axis.dot(move_of(state, of.link + a, by.force));
    return sum;
}

void CapstanSolver::fill_band(const State& state) {
    const std::vector<Unknown>& unknowns = unknowns_;
    band_.clear();
    for (std::size_t i = 0, first = 0, end = 0; i < unknowns.size(); ++i) {
        while (unknowns[first].link + 1 < unknowns[i].link) ++first;
        while (end < unknowns.size() && unknowns[end].link <= unknowns[i].link + 1) ++end;
        band_.add_row(first, end);
        for (std::size_t j = first; j < end; ++j) band_(i, j) = response(state, unknowns[i], unknowns[j]);
        band_(i, i) += unknowns[i].compliance;
    }
}

void CapstanSolver::push(State& state, const Unknown& unknown, double by) {
    for (int a = 0; a < 2; ++a)
        displaced_[at(unknown.link + a)] +=
            by * unknown.weight[at(a)] * move_of(state, unknown.link + a, unknown.force);
    if (!unknown.row) {
        state.pulled[at(unknown.link)] += by;
        return;
    }
    unknown.row->normal_push += by;
    unknown.row->tangent_push += by * (unknown.force - unknown.axis);
}

bool is_on_steel(const State& state) {
    return std::any_of(state.on_steel.begin(), state.on_steel.end(), [&](int i) {
        const Row& row = state.rows[at(i)];
        return row.mobility > 0 && (row.normal_push > 0 || presses(state, row));
    });
}

double CapstanSolver::solve(State& state, LengthSolver& lengths) {
    find_friction_ratios(state);
    measure_stiffness(state);
    displaced_.assign(state.nodes.size(), Vec3::Zero());
    const double worst = collect(state, lengths);
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        const Unknown& u = unknowns_[i];
        unknown_[i] -= u.axis.dot(u.weight[0] * displaced_[at(u.link)] + u.weight[1] * displaced_[at(u.link + 1)]);
    }
    fill_band(state);
    band_.solve(unknown_);
    if (!std::all_of(unknown_.begin(), unknown_.end(), [](double x) { return std::isfinite(x); }))
        return forget_pushes(state), worst;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) push(state, unknowns_[i], unknown_[i]);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) state.nodes[i] += displaced_[i];
    return worst;
}

}  // namespace sim::thread::ftl
