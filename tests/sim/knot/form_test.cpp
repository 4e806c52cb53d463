#include "sim/knot/form.hpp"

#include <gtest/gtest.h>

#include "tests/bench/lab/capsized.hpp"
#include "tests/sim/knot/ropes.hpp"

using bench::lab::Pull;
using bench::lab::pulled;
using sim::knot::unevenness;

// The same square or granny knot lies flat when both tails are pulled, and capsizes round a strand that is pulled
// straight.
TEST(Form, KnotsPulledByOneStrandAreCapsized) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        const auto flat = sim::knot::name_knot(pulled(Pull::tails, seed)),
                   capsized = sim::knot::name_knot(pulled(Pull::one_strand, seed));
        EXPECT_TRUE(flat.flat);
        EXPECT_FALSE(capsized.flat);
        EXPECT_EQ(flat.throws.size(), 3u);
        EXPECT_EQ(capsized.throws.size(), 3u);
    }
}

// Nothing is seen from a side: attitude, size, mirror image and direction change only the last digits.
TEST(Form, IsTheSameFromAllSides) {
    for (const char* id : {"p103", "p109", "p123", "p125"}) {
        SCOPED_TRACE(id);
        const ropes::Rope rope = ropes::labelled(id).at(0).components[0].vertices;
        const double expected = unevenness(rope);
        std::mt19937 random(1);
        ropes::Rope small = rope;
        for (auto& p : small) p = 1e-3 * p + ropes::Vec3(1, 2, 3);
        for (const auto& same : {ropes::turned(rope, random), ropes::mirrored(rope), small})
            EXPECT_NEAR(unevenness(same), expected, 1e-9);
    }
}

TEST(Form, OfTheSmallestCurvesIsANumber) {
    EXPECT_EQ(unevenness({{0, 0, 0}, {1, 0, 0}}), 0);
    EXPECT_EQ(unevenness({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), 0);
    EXPECT_GE(unevenness({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}, {0.5, -1, 0.5}}), 0);
}
