// Every limit, strength and size that a wall is judged and moved by, against a literal with its source, and every limit
// of a lapse from just inside and just outside.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "tissue/bite.hpp"
#include "tissue/join.hpp"
#include "tissue/lapse.hpp"
#include "tissue/leak.hpp"
#include "tissue/material.hpp"

namespace limits_of_lapses {

using namespace tissue;

constexpr double mm = 1e-3, degree = std::numbers::pi / 180;

// Eight stitches by hand round a rim of 8 mm, a bite of 1 mm in each end, none of them a lapse. Walls are 1 mm thick,
// the thread 0.1 mm.
Join clean() {
    Join join;
    join.diameter = 0.1 * mm, join.wall = 1 * mm, join.rim = 8 * mm;
    for (int k = 0; k < 8; ++k) {
        join.line.push_back({.length = 1 * mm});
        for (const int vessel : {0, 1}) {
            SewnBite bite;
            bite.vessel = vessel, bite.size = 1 * mm, bite.hole = 0.1 * mm, bite.thread = 0;
            join.bites.push_back(bite);
        }
        join.stitches.push_back({.bites = {2 * k, 2 * k + 1}, .arc = 0, .obliqueness = 0, .loop = 1});
    }
    for (auto& spacing : join.spacing) spacing.assign(8, 1 * mm);
    return join;
}

std::string committed(const Join& join) {
    std::string names;
    for (const Lapse& lapse : lapses(join))
        if (lapse.committed) names += lapse.name + std::string(" ");
    return names;
}

// What an expert would see of a join in which one thing is as large as `value` says, in the limit's own unit.
struct Limit {
    const char* lapse;
    double limit;
    std::function<void(Join&, double)> set;
    bool at_least = false;
};

const Limit table[] = {
    // Ghanem et al. 2016 name the ten lapses; the numbers are one reading of them and stand in LapseLimits.
    {"disruption of suture line ", 1, [](Join& j, double v) { j.line[0].gap = j.wall, j.line[0].length = v * mm; }},
    {"back-wall stitch ", 90, [](Join& j, double v) { j.stitches[3].arc = v * degree; }},
    {"back-wall stitch ", 90, [](Join& j, double v) { j.arc_of_pass = v * degree; }},
    {"oblique stitch ", 15, [](Join& j, double v) { j.stitches[3].obliqueness = v * degree; }},
    {"wide bite ", 3,
     [](Join& j, double v) {
         for (auto& bite : j.bites) bite.size = v * j.wall;
     }},
    {"wide bite ", 1.5, [](Join& j, double v) { j.bites[5].size = v * mm; }},
    {"unequal spacing ", 0.6,
     [](Join& j, double v) { j.spacing[1].assign(8, (8 - v) / 7 * mm), j.spacing[1][2] = v * mm; }, true},
    {"unequal spacing ", 1.5,
     [](Join& j, double v) { j.spacing[0].assign(8, (8 - v) / 7 * mm), j.spacing[0][2] = v * mm; }},
    {"unequal spacing ", 0.25,
     [](Join& j, double v) {
         for (std::size_t k = 0; k < 8; ++k) j.spacing[1][k] = (k % 2 ? 1 + v : 1 - v) * mm;
     }},
    {"tear ", 2, [](Join& j, double v) { j.bites[5].hole = v * j.diameter; }},
    {"strangulation ", 0.3, [](Join& j, double v) { j.bites[5].strain = v; }},
    {"strangulation ", 0.8, [](Join& j, double v) { j.stitches[3].loop = v; }, true},
    {"thread in lumen ", 1, [](Join& j, double v) { j.deepest_thread = v * j.diameter; }},
    {"overlap ", 1, [](Join& j, double v) { j.line[4].overlap = v * j.wall; }},
};

TEST(LapseLimits, CommitNothingJustInsideAndTheirLapseJustOutside) {
    EXPECT_EQ(committed(clean()), "");
    for (const Limit& limit : table) {
        SCOPED_TRACE(limit.lapse + std::to_string(limit.limit));
        for (const double share : {0.993, 1.007}) {
            Join join = clean();
            limit.set(join, share * limit.limit);
            EXPECT_EQ(committed(join), (share > 1) != limit.at_least ? limit.lapse : "") << share;
        }
        Join join = clean();
        limit.set(join, (limit.at_least ? 0.9 : 1.1) * limit.limit);
        for (const Lapse& lapse : lapses(join)) {
            if (!lapse.committed) continue;
            EXPECT_NEAR(lapse.value, (limit.at_least ? 0.9 : 1.1) * limit.limit, 1e-9);
            EXPECT_EQ(lapse.limit, limit.limit);
            EXPECT_EQ(lapse.at_least, limit.at_least);
        }
    }
}

// Counted as open is what is wider than a quarter of a wall.
TEST(LapseLimits, OpenTheLineWhereItGapesByAQuarterOfAWall) {
    for (const double gap : {0.249, 0.251}) {
        Join join = clean();
        for (LinePiece& piece : join.line) piece.gap = gap * join.wall;
        EXPECT_EQ(committed(join), gap > 0.25 ? "disruption of suture line " : "");
    }
}

// Where not one may be: a single bite through half a wall, a single hole that is torn.
TEST(LapseLimits, AllowNoPartialBiteAndNoTornHole) {
    Join partial = clean();
    partial.bites[5].partial = true;
    EXPECT_EQ(committed(partial), "partial-thickness stitch ");
    partial.bites[5].both_walls = true;
    EXPECT_EQ(committed(partial), "") << "that is a back-wall stitch, by its arc";
    Join torn = clean();
    torn.bites[5].torn = true;
    EXPECT_EQ(committed(torn), "tear ");
}

// What an instructor gets who changes none of them.
TEST(LapseLimits, AreThese) {
    const LapseLimits limits;
    EXPECT_EQ(limits.gap, 0.25);
    EXPECT_EQ(limits.open_spacings, 1);
    EXPECT_EQ(limits.arc, 90);
    EXPECT_EQ(limits.obliqueness, 15);
    EXPECT_EQ(limits.bite_walls, 3);
    EXPECT_EQ(limits.bite_medians, 1.5);
    EXPECT_EQ(limits.partial_bites, 0);
    EXPECT_EQ(limits.least_spacing, 0.6);
    EXPECT_EQ(limits.most_spacing, 1.5);
    EXPECT_EQ(limits.spacing_variation, 0.25);
    EXPECT_EQ(limits.hole_diameters, 2);
    EXPECT_EQ(limits.torn_holes, 0);
    EXPECT_EQ(limits.edge_strain, 0.3);
    EXPECT_EQ(limits.least_loop, 0.8);
    EXPECT_EQ(limits.depth_diameters, 1);
    EXPECT_EQ(limits.overlap_walls, 1);
}

// A bite of which no thread is left is neither wide nor strangled, and counts for no median.
TEST(LapseLimits, AreOfBitesThatHoldThread) {
    Join join = clean();
    join.bites[5].thread = -1, join.bites[5].size = 5 * mm, join.bites[5].strain = 0.9, join.bites[5].partial = true;
    EXPECT_EQ(committed(join), "");
}

// Of a vessel's wall: Young's modulus and density of arteries at small strain; times chosen by eye, as material.hpp
// says. What is nearly incompressible has a third of Young's modulus as its shear modulus.
TEST(Strengths, OfAWall) {
    const Material wall;
    EXPECT_EQ(wall.young, 0.1e6);
    EXPECT_EQ(wall.bulk_over_shear, 200);
    EXPECT_EQ(wall.density, 1060);
    EXPECT_EQ(wall.relaxation, 2.5e-3);
    EXPECT_EQ(wall.slowing, 25e-3);
    EXPECT_NEAR(wall.shear(), 0.1e6 / 3, 1e-9);
    EXPECT_NEAR(wall.bulk(), 200 * 0.1e6 / 3, 1e-6);
    EXPECT_NEAR(wall.viscosity(), 2 * 2.5e-3 * 0.1e6 / 3, 1e-9);
}

// Of a bite: mammary arteries 0.4 mm thick, bitten 2 mm from the edge, held 1.35 N.
TEST(Strengths, OfABite) {
    const BiteDef bite;
    EXPECT_EQ(bite.puncture, 3e-3);
    EXPECT_EQ(bite.friction, 1);
    EXPECT_EQ(bite.stiffness, 500);
    EXPECT_EQ(bite.tip_stiffness, 120);
    EXPECT_EQ(bite.grip, 1);
    EXPECT_EQ(bite.hole, 0.055e-3);
    EXPECT_EQ(bite.wall, 0.5e-3);
    EXPECT_NEAR(bite.retention * 0.4e-3 * 2e-3, 1.35, 1e-12);
}

// Blood at 100 mmHg, 13332 Pa; 0.6 is the discharge coefficient of a sharp edge.
TEST(Strengths, OfWhatLeaks) {
    const Fluid blood;
    EXPECT_EQ(blood.density, 1055);
    EXPECT_EQ(blood.viscosity, 3.5e-3);
    EXPECT_EQ(blood.pressure, 13332);
    EXPECT_EQ(discharge_coefficient, 0.6);
    EXPECT_NEAR(in_ml_per_min(1e-6), 60, 1e-12);
}

}  // namespace limits_of_lapses
