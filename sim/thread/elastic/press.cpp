#include "sim/thread/elastic/press.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/geometry/lane.hpp"

// What an elastic thread touches, solved together with it: one contact after the other pushes as Coulomb wants it,
// against how the points of all answer (Gauss and Seidel on the rod's inverse at the nodes that touch).
namespace sim::thread {

using geometry::Lane;
using Mat3 = Eigen::Matrix3d;

// The push with which one contact alone would be as Coulomb wants it, from the one it has: its points are `lacks` from
// where they would be. First across, then along.
static Vec3 push_of(const Press& press, const Vec3& lacks) {
    const Vec3& n = press.normal;
    const double before = press.push.dot(n), normal = std::max(0.0, before + lacks.dot(n) / press.gives);
    Vec3 drag = press.push - before * n + press.along * (lacks - (normal - before) * press.across);
    const double size2 = drag.squaredNorm(), most = press.friction * normal;
    if (size2 > most * most) drag *= most / std::sqrt(size2);
    return normal * n + drag;
}

// How it gives way to its own push.
static void measure_own(Press& press, const Mat3& responses) {
    const Vec3& n = press.normal;
    const Mat3 own = responses + press.give * Mat3::Identity(), along = Mat3::Identity() - n * n.transpose();
    press.across = own * n;
    press.gives = n.dot(press.across);
    press.along = along * (along * own * along + own.trace() * n * n.transpose()).inverse() * along;
}

Vec3 way_of(const State& state, const Row& row) {
    const std::span<const Vec3> step = state.rod->step_found();
    const auto way = [&](int link, double s) { return Vec3((1 - s) * step[at(link)] + s * step[at(link + 1)]); };
    return row.against == Against::thread ? Vec3(way(row.link, row.s) - way(row.other, row.t)) : way(row.link, row.s);
}

// Where the step takes the points of all.
static void find_apart(State& state) {
    for (std::size_t c = 0; c < state.presses.size(); ++c) {
        const Row& row = *state.presses[c].row;
        const Vec3 apart = apart_of(state, row) + way_of(state, row);
        std::copy_n(apart.data(), 3, state.apart.data() + 3 * c);
    }
}

void push_more(State& state, const Responses& responses, std::size_t c, const Vec3& more) {
    state.presses[c].push += more;
    const double* const x = responses.row(axes(c)).data();
    const double* const y = responses.row(axes(c) + 1).data();
    const double* const z = responses.row(axes(c) + 2).data();
    const double along_x = more.x(), along_y = more.y(), along_z = more.z();
    double* const apart = state.apart.data();
    for (const Run& run : answers_to(state, c)) {
        const std::size_t past = 3 * run.past;
        std::size_t i = 3 * run.first;
        for (; i + 4 <= past; i += 4)
            (Lane::from(apart + i) +
             (Lane::from(x + i) * along_x + Lane::from(y + i) * along_y + Lane::from(z + i) * along_z))
                .to(apart + i);
        for (; i < past; ++i) apart[i] += x[i] * along_x + y[i] * along_y + z[i] * along_z;
    }
}

// One contact after the other; returns how much that changed, as share of all pushes.
static double sweep(State& state, const Responses& responses) {
    double changed = 0, all = 0;
    for (std::size_t c = 0; c < state.presses.size(); ++c) {
        const Press& press = state.presses[c];
        const Vec3 lacks = press.rest - Eigen::Map<const Vec3>(state.apart.data() + 3 * c) - press.give * press.push;
        if (press.push.squaredNorm() == 0 && lacks.dot(press.normal) <= 0) continue;  // as half of them
        const Vec3 push = push_of(press, lacks), more = push - press.push;
        changed += more.squaredNorm(), all += push.squaredNorm();
        if (more.squaredNorm() > 0) push_more(state, responses, c, more);
    }
    return all > 0 ? std::sqrt(changed / all) : 0;
}

// What the last sweep gained is carried on by `again` times where the ones before led.
static void carry_on(State& state, double again) {
    for (Press& press : state.presses) {
        const Vec3 gain = press.push - press.before;
        press.way *= again;
        press.push += press.way;
        press.way += gain;
    }
    for (std::size_t i = 0; i < state.apart.size(); ++i) {
        const double gain = state.apart[i] - state.apart_before[i];
        state.apart_way[i] *= again;
        state.apart[i] += state.apart_way[i];
        state.apart_way[i] += gain;
    }
}

static double gained(const State& state) {
    double sum = 0;
    for (const Press& press : state.presses) sum += (press.push - press.before).squaredNorm();
    return sum;
}

// Gauss and Seidel alone gain a little less each time where many work against each other; what each sweep gains is
// carried on as by nonlinear conjugate gradients [Silcowitz, Niebe and Erleben 2010, algorithm 1]. A sweep is last, so
// that no push leaves its cone.
static int sweep_until_still(State& state, const Responses& responses) {
    constexpr double enough = 1e-5;  // of all pushes, by a sweep: with a hundred times that a loaded knot creeps on by
                                     // its thickness every half second
    constexpr int most_sweeps = 60;
    double last = 0;
    state.apart_way.assign(state.apart.size(), 0.0);
    for (int sweeps = 1;; ++sweeps) {
        for (Press& press : state.presses) press.before = press.push;
        state.apart_before = state.apart;
        if (sweep(state, responses) < enough || sweeps == most_sweeps) return sweeps;
        const double now = gained(state);
        carry_on(state, now < last ? now / last : 0);
        last = now;
    }
}

int solve_together(State& state) {
    if (state.presses.empty()) return 0;
    const Responses responses = measure_responses(state);
    state.apart.resize(3 * state.presses.size());
    find_apart(state);
    for (std::size_t c = 0; c < state.presses.size(); ++c)
        measure_own(state.presses[c], responses.block<3, 3>(axes(c), axes(c)));
    const int sweeps = sweep_until_still(state, responses);
    part_presses(state, responses);
    return sweeps;
}

}  // namespace sim::thread
