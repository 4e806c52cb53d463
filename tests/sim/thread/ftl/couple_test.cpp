#include <gtest/gtest.h>

#include <random>

#include "sim/thread/contact/detection.hpp"
#include "sim/thread/contact/gaps.hpp"
#include "sim/thread/ftl/coupled_solver.hpp"
#include "tests/sim/thread/scene.hpp"

namespace coupling {

using namespace scene;
using sim::thread::ftl::CoupledSolver;
using sim::thread::ftl::LengthSolver;
using sim::thread::ftl::State;

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
    sim::thread::contact::Detection(state.most_links()).look_around(state, 0);
    measure_gaps(state, radius);
    return state;
}

// The coupled solve says beforehand how far each contact will part when all push and all lengths answer. A wrong sign,
// a forgotten neighbour or a wrong inverse would send strands where nobody looked. A contact's points move linearly
// with the nodes, so only rounding may differ.
TEST(Couple, ContactsPartAsFarAsTheSolveSaid) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        State state = disturbed_overhand(seed);
        LengthSolver lengths(state.most_links());
        CoupledSolver coupled(state.most_links());
        lengths.solve(state);
        aim(state);
        const std::vector<Vec3> start = state.nodes;
        coupled.solve(state, lengths);
        ASSERT_GT(coupled.rows(), 4u);
        double move = 0, error = 0;
        for (std::size_t i = 0; i < start.size(); ++i) move = std::max(move, (state.nodes[i] - start[i]).norm());
        ASSERT_GT(move, 0);
        for (std::size_t c = 0; c < coupled.rows(); ++c)
            error = std::max(error, (apart_of(state, coupled.row(c)) - coupled.foreseen(c)).norm());
        EXPECT_LE(error, 1e-9 * move) << "of a move of " << move / radius << " radii";
    }
}

// Lengths are kept while contacts part, but for what a first-order answer leaves: squares of moves over a link's
// length.
TEST(Couple, LengthsAreKept) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        State state = disturbed_overhand(seed);
        LengthSolver lengths(state.most_links());
        for (int i = 0; i < 4; ++i) lengths.solve(state);
        aim(state);
        const std::vector<Vec3> start = state.nodes;
        CoupledSolver(state.most_links()).solve(state, lengths);
        double move = 0;
        for (std::size_t i = 0; i < start.size(); ++i) move = std::max(move, (state.nodes[i] - start[i]).norm());
        ASSERT_GT(move, 0);
        const double link = 2 * radius;
        EXPECT_LE(worst_stretch(state, state.nodes),
                  4 * move * move / (link * link) + sim::thread::ftl::stretch_tolerance);
    }
}

}  // namespace coupling
