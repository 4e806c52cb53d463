#include <gtest/gtest.h>

#include <random>

#include "sim/thread/stages.hpp"
#include "tests/sim/thread/scene.hpp"

namespace {

using namespace scene;
using sim::thread::PushedRow;
using sim::thread::State;

// A tight overhand, its ends held, every node off by up to a hundredth of the thread's thickness.
State disturbed_overhand(unsigned seed) {
    Thread thread({}, overhand(120));
    Pull pull(thread);
    tighten(thread, pull, 0.1, 80);
    State state({}, {thread.nodes().begin(), thread.nodes().end()});
    std::mt19937 random(seed);
    const auto off = [&] { return 0.02 * radius * (random() / 2147483648.0 - 1); };
    for (Vec3& node : state.nodes) node += Vec3(off(), off(), off());
    state.inverse_mass.front() = state.inverse_mass.back() = 0;
    state.before = state.nodes;
    sim::thread::look_around(state, 0);
    sim::thread::measure_gaps(state, radius);
    return state;
}

// The coupled solve says beforehand how far each contact will part when all push and all lengths answer. A wrong sign,
// a forgotten neighbour or a wrong inverse would send strands where nobody looked. A contact's points move linearly
// with the nodes, so only rounding may differ.
TEST(Couple, ContactsPartAsFarAsTheSolveSaid) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        State state = disturbed_overhand(seed);
        sim::thread::solve_lengths(state);
        sim::thread::aim(state);
        const std::vector<Vec3> start = state.nodes;
        sim::thread::couple(state);
        ASSERT_GT(state.pushed_rows.size(), 4u);
        double move = 0, error = 0;
        for (std::size_t i = 0; i < start.size(); ++i) move = std::max(move, (state.nodes[i] - start[i]).norm());
        ASSERT_GT(move, 0);
        const auto responses = state.responses.resized(state.pushes.size(), state.pushes.size());
        for (std::size_t c = 0; c < state.pushed_rows.size(); ++c) {
            const PushedRow& row = state.pushed_rows[c];
            const Vec3 said = row.apart + responses.middleRows<3>(static_cast<Eigen::Index>(3 * c)) * state.pushes;
            error = std::max(error, (sim::thread::apart_of(state, *row.row) - said).norm());
        }
        EXPECT_LE(error, 1e-9 * move) << "of a move of " << move / radius << " radii";
    }
}

// Lengths are kept while contacts part, but for what a first-order answer leaves: squares of moves over a link's
// length.
TEST(Couple, LengthsAreKept) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        State state = disturbed_overhand(seed);
        for (int i = 0; i < 4; ++i) sim::thread::solve_lengths(state);
        sim::thread::aim(state);
        const std::vector<Vec3> start = state.nodes;
        sim::thread::couple(state);
        double move = 0;
        for (std::size_t i = 0; i < start.size(); ++i) move = std::max(move, (state.nodes[i] - start[i]).norm());
        ASSERT_GT(move, 0);
        const double link = 2 * radius;
        EXPECT_LE(sim::thread::worst_stretch(state, state.nodes),
                  4 * move * move / (link * link) + sim::thread::stretch_tolerance);
    }
}

}  // namespace
