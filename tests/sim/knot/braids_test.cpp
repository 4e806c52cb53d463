#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/sim/knot/ropes.hpp"

using ropes::Rope;

namespace {

struct Braid {
    std::string knot;
    bool amphichiral = false;
    int strands = 0;
    std::vector<int> word;
};

std::vector<Braid> braids() {
    std::ifstream file(std::string(CARREL_SOURCE) + "/tests/data/braids.csv");
    std::vector<Braid> all;
    std::string line, text;
    std::getline(file, line);
    while (std::getline(file, line)) {
        Braid& braid = all.emplace_back();
        std::istringstream in(line);
        std::getline(in, braid.knot, ',');
        std::getline(in, text, ',');
        braid.amphichiral = text == "1";
        std::getline(in, text, ',');
        braid.strands = std::stoi(text);
        for (int letter; in >> letter;) braid.word.push_back(letter);
    }
    return all;
}

// One tour along strands that go up in y and return on the right, the outermost first. A positive letter has whoever
// goes right over whoever goes left.
Rope closure(const Braid& braid) {
    const int n = static_cast<int>(braid.word.size());
    Rope rope;
    int place = 0;
    do {
        for (int i = 0; i < n; ++i) {
            const int letter = braid.word[static_cast<std::size_t>(i)], left = std::abs(letter) - 1;
            rope.emplace_back(place, i, 0);
            if (place != left && place != left + 1) continue;
            const bool right = place == left;
            rope.emplace_back(left + 0.5, i + 0.5, right == (letter > 0) ? 0.5 : -0.5);
            place = right ? left + 1 : left;
        }
        const int out = 2 * braid.strands - place, beyond = braid.strands - place;
        rope.emplace_back(place, n, 0);
        rope.emplace_back(place, n + beyond, 0);
        rope.emplace_back(out, n + beyond, 0);
        rope.emplace_back(out, -beyond, 0);
        rope.emplace_back(place, -beyond, 0);
    } while (place != 0);
    return rope;
}

}  // namespace

// Every prime knot of the table from a drawing that has nothing to do with it, on its grid and in some attitude, and
// its mirror image.
TEST(Braids, EveryPrimeKnotToTenCrossingsIsNamedFromItsBraid) {
    std::mt19937 random(7);
    int right = 0;
    for (const Braid& braid : braids()) {
        SCOPED_TRACE(braid.knot);
        const Rope rope = closure(braid);
        const auto listed = sim::knot::name_knot(ropes::turned(rope, random), true);
        const auto mirror = sim::knot::name_knot(ropes::turned(ropes::mirrored(rope), random), true);
        EXPECT_EQ(listed.knot, braid.knot);
        EXPECT_EQ(sim::knot::name_knot(rope, true).knot, braid.knot);
        EXPECT_EQ(mirror.knot, braid.amphichiral ? braid.knot : "m" + braid.knot);
        EXPECT_TRUE(listed.certain && mirror.certain);
        right += listed.knot == braid.knot;
    }
    EXPECT_EQ(right, 249);
}
