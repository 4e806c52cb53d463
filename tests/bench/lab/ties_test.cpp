#include "tests/bench/lab/ties.hpp"

#include <gtest/gtest.h>

#include "sim/knot/namer.hpp"
#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/hitches.hpp"

namespace {

using namespace bench::lab;

// A start that is not the knot it is called would make every later comparison worthless.
TEST(Ties, LooseThreadsAreTheKnotsTheyAreCalled) {
    const double radius = ThreadDef{}.radius;
    for (const KnownKnot& knot : known_knots)
        for (const double radius_per_link : {0.2, 0.6}) {
            const auto nodes = loose_thread(knot.knot, 60, radius / radius_per_link, radius).nodes;
            const auto name = sim::knot::name_knot(nodes);
            EXPECT_EQ(name.knot, knot.type) << knot.words;
            EXPECT_TRUE(name.certain) << knot.words;
        }
}

// Every kind of knot is met among these seeds; `carrel bench ties` plays 10,000.
TEST(Ties, SeededTiesKeepTheirKnots) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Tied tied = ties(seed);
        EXPECT_TRUE(tied.good()) << words(seed, tie_of(seed), tied);
        EXPECT_FALSE(tied.before.empty()) << seed;
    }
}

TEST(Ties, TheSameSeedGivesTheSameBits) {
    const Tied a = ties(3), b = ties(3);
    EXPECT_EQ(a.left, b.left);
    EXPECT_EQ(a.stretch, b.stretch);
    EXPECT_EQ(a.ticks, b.ticks);
}

}  // namespace

// The seed paper's figures. Pulled tight round a bar they are called by their names all the way, a cow hitch and a
// prusik too, which with their ends joined are not linked with the bar.
TEST(Ties, BowlineAndHitchesAreNamedRoundABar) {
    for (const char* curve : {"p129", "p135", "p137", "p138"}) {
        const bench::lab::OnBar tied =
            bench::lab::hitch_on_bar(std::string(CARREL_SOURCE) + "/tests/data/curves", curve);
        EXPECT_EQ(tied.last, tied.expected);
        EXPECT_EQ(tied.other, 0) << tied.expected;
        EXPECT_EQ(tied.pass_throughs, 0) << tied.expected;
        EXPECT_GT(tied.drawn_out, 5) << tied.expected << " was not pulled tight";
    }
}
