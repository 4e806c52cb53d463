#include <gtest/gtest.h>

#include <random>

#include "sim/knot/colouring.hpp"
#include "sim/knot/homfly.hpp"
#include "sim/knot/projection.hpp"
#include "sim/knot/table.hpp"
#include "tests/sim/knot/ropes.hpp"

using namespace sim::knot;

namespace {

const Diagram right_trefoil{{{{0, false}, {2, true}, {1, false}, {0, true}, {2, false}, {1, true}}}, {1, 1, 1}};

Diagram random_diagram(unsigned seed, int vertices, std::size_t strands) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(-1.0, 1.0);
    Polygons polygons(strands);
    for (auto& polygon : polygons)
        for (int i = 0; i < vertices; ++i) polygon.emplace_back(side(random), side(random), side(random));
    return project(polygons, Vec3(0, 0, 1), 1000).value();
}

std::optional<Polynomial> homfly_of(const Diagram& diagram) {
    Work plenty{100000000};
    return homfly(diagram, plenty);
}

}  // namespace

// Values worked out on paper: trefoil 2 v^2 - v^4 + z^2 v^2, its colouring vector from the presentation of its group.
TEST(Invariants, OfTheRightTrefoil) {
    EXPECT_EQ(homfly_of(right_trefoil), (Polynomial{{2, 0, 2}, {2, 2, 1}, {4, 0, -1}}));
    EXPECT_EQ(colouring_vector(right_trefoil, Group::psl27), (std::vector<int>{1, 7, 0, 0, 0, 0, 0}));
    EXPECT_EQ(colouring_vector(right_trefoil, Group::a5), (std::vector<int>{7, 0, 0}));
}

// The table holds each polynomial's knots: a line lost or read wrong would lose a type.
TEST(Table, HoldsAllTypesOfTenCrossings) {
    std::ptrdiff_t shared = 0;
    const auto nine = knots_with(product(listed_homfly({"4_1", false, 4}), listed_homfly({"5_2", false, 5})));
    EXPECT_EQ(nine.size(), 2u);  // 9_12 and 4_1#5_2
    for (const auto* k : nine) shared += k->crossings;
    EXPECT_EQ(shared, 18);
    EXPECT_EQ(knots_with({{0, 0, 1}}).size(), 1u);
    EXPECT_EQ(known_links().size(), 2 * 91u - 4u);
}

// Simplification must not change the link. Random diagrams have every kind of stretch that can be rerouted; a wrong
// face, sign or end shows as another polynomial.
TEST(Diagram, SimplificationKeepsThePolynomial) {
    int shortened = 0;
    for (unsigned seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        Diagram diagram = random_diagram(seed, 6 + static_cast<int>(seed % 4), 1 + seed % 3);
        if (diagram.crossings() > 18) continue;
        Diagram simple = diagram;
        remove_curls_and_bigons(simple);
        const int before = simple.crossings();
        simplify(simple);
        shortened += simple.crossings() < before;
        EXPECT_EQ(homfly_of(simple), homfly_of(diagram));
    }
    EXPECT_GT(shortened, 50);
}

// Cutting off summands: the polynomial of the whole is the product of theirs.
TEST(Diagram, SummandsMultiply) {
    const auto rope = bench::lab::tied({{1, true}, {2, false}, {1, true}});
    Diagram diagram = project({rope}, Vec3(0.1, 1, 0.2).normalized(), 1000).value();
    const auto whole = homfly_of(diagram);
    simplify(diagram);
    Polynomial all{{0, 0, 1}};
    const auto summands = cut_summands(diagram);
    EXPECT_GE(summands.size(), 3u);
    for (const auto& s : summands) all = product(all, homfly_of(s.diagram).value());
    EXPECT_EQ(all, whole);
}

// The bound on work is kept: a tangle far beyond it comes back empty.
TEST(Invariants, GiveUpOnTangles) {
    Work little{10000};
    EXPECT_FALSE(homfly(random_diagram(1, 40, 1), little));
}
