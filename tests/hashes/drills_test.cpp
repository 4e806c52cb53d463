// The shipped drills, each played once: its state hashes are those of the table, and copies of its world go on as it
// does itself, bit for bit, at whatever tick they were taken.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <set>

#include "scenarios/drill/score.hpp"
#include "scenarios/session/script.hpp"
#include "scenarios/world/judge.hpp"
#include "tests/hashes/table.hpp"
#include "tests/scenarios/world/for_tests.hpp"

namespace hashes {

namespace fs = std::filesystem;
using scenarios::session::Script;
using scenarios::world::Event;
using scenarios::world::ForTests;
using scenarios::world::World;

// Ticks between two state hashes, and of a naming: one starts every 100 ticks and is fetched 20 later.
constexpr std::uint64_t look = 10, period = 100, in_flight = 20;

unsigned seed() {
    const char* given = std::getenv("CARREL_SEED");
    return given ? static_cast<unsigned>(std::atoi(given)) : 1;
}

/// A copy, the tick to which it is played, and what the original came to then.
struct Copied {
    World world;
    std::uint64_t until;
    std::uint64_t carried = 0;
    std::vector<Event> events{};
};

bool is_in_a_wall(const World& world) {
    return std::any_of(world.vessels().begin(), world.vessels().end(),
                       [](const auto& vessel) { return vessel.bites.holes_on_needle() > 0; });
}

/// Copies of a drill, and the state hashes that the original then had.
struct Copies {
    std::vector<Copied> copied{};
    std::vector<std::uint64_t> hashes{};  // after tick `look`, twice that, and so on
};

/// When a drill is copied [ticks]: at these and, if it has a needle, once when that has been in a wall for so many.
struct Moments {
    std::set<std::uint64_t> ticks;
    std::uint64_t in_a_wall;
};

/// Seconds of a drill whose hashes the table has: the first 20, or 60 with CARREL_LONG_HASHES set.
std::uint64_t seconds_of_table(const Script& script) {
    return static_cast<std::uint64_t>(
        std::min(std::getenv("CARREL_LONG_HASHES") ? 60.0 : 20.0, script.motion.duration()));
}

/// Plays a drill against the table's hashes, as far as these go, and copies it on the way. Copies lie untouched while
/// the original goes on for `ahead` ticks after each, and is gone before they are played: what they shared with it
/// would be another's or nobody's then.
Copies play(const Script& script, const std::string& name, const Moments& when, std::uint64_t ahead) {
    World original = script.start();
    Copies copies;
    std::uint64_t last = 1000 * seconds_of_table(script), ticks_in_a_wall = 0;
    const auto copy = [&] {
        copies.copied.push_back({original, std::min(script.ticks(), original.ticks() + ahead)});
        last = std::max(last, copies.copied.back().until);
    };
    const std::uint64_t last_for_needle = original.needles().empty() ? 0 : script.ticks();
    while (original.ticks() < last || original.ticks() <= *when.ticks.rbegin() ||
           (ticks_in_a_wall < when.in_a_wall && original.ticks() < last_for_needle)) {
        if (when.ticks.count(original.ticks())) copy();
        script.tick(original);
        if (is_in_a_wall(original) && ++ticks_in_a_wall == when.in_a_wall) copy();
        if (original.ticks() % look == 0) copies.hashes.push_back(original.hash());
        if (original.ticks() % 1000 == 0 && original.ticks() / 1000 <= seconds_of_table(script))
            expect_hash("drill", name, std::to_string(original.ticks() / 1000), copies.hashes.back());
        for (Copied& one : copies.copied)
            if (one.until == original.ticks())
                one.carried = original.hash_of_all_carried(),
                one.events.assign(original.events().begin(), original.events().end());
        if (testing::Test::HasFatalFailure()) break;
    }
    return copies;
}

void expect_goes_on_alike(const Script& script, Copied copied, const std::vector<std::uint64_t>& hashes) {
    World& copy = copied.world;
    SCOPED_TRACE("copied after tick " + std::to_string(copy.ticks()));
    while (copy.ticks() < copied.until) {
        script.tick(copy);
        if (copy.ticks() % look == 0) {
            ASSERT_EQ(copy.hash(), hashes[copy.ticks() / look - 1]) << "at tick " << copy.ticks();
        }
    }
    EXPECT_EQ(copy.hash_of_all_carried(), copied.carried);
    EXPECT_TRUE(std::equal(copy.events().begin(), copy.events().end(), copied.events.begin(), copied.events.end()));
}

/// Random ticks before `end`, one of them while a naming is in flight.
std::set<std::uint64_t> moments(std::mt19937& random, std::size_t count, std::uint64_t end) {
    const std::uint64_t naming = random() % (end / period) * period + 1 + random() % (in_flight - 1);
    std::set<std::uint64_t> when{naming};
    while (when.size() < count) when.insert(random() % end);
    return when;
}

class DrillHashes : public testing::TestWithParam<fs::path> {};

// Sixty-four moments of all drills: of those that take minutes within their first 20 s, of the others anywhere. Most
// are of the drills whose ticks cost least.
TEST_P(DrillHashes, AreThoseOfTheTableAndOfCopies) {
    const Script script(GetParam());
    const bool is_long = script.motion.duration() > 60, has_needle = !script.drill.world.needle_code.empty();
    std::mt19937 random(seed());
    const std::size_t count = has_needle ? 1 : script.drill.world.thread.model == "elastic" ? 6 : 9;
    const Moments when{moments(random, count, is_long ? 20'000 : script.ticks()), 1 + random() % 300};
    std::cout << "CARREL_SEED=" << seed() << ": copied after tick";
    for (const std::uint64_t tick : when.ticks) std::cout << ' ' << tick;
    if (has_needle) std::cout << " and after " << when.in_a_wall << " ticks in a wall";
    std::cout << std::endl;
    const Copies copies = play(script, GetParam().stem(), when, 5'000);
    if (HasFatalFailure()) return;
    EXPECT_EQ(copies.copied.size(), count + has_needle);
    EXPECT_GT(
        std::ranges::count_if(copies.copied, [](const Copied& one) { return ForTests::is_being_named(one.world); }), 0);
    for (const Copied& copied : copies.copied) expect_goes_on_alike(script, copied, copies.hashes);
}

INSTANTIATE_TEST_SUITE_P(Shipped, DrillHashes, testing::ValuesIn(drill_files()), test_name);

class WholeCopy : public testing::TestWithParam<fs::path> {};

std::vector<scenarios::drill::ScoreItem> scores_of(const Script& script, World& world) {
    world.name_knot_now();
    return scenarios::drill::score(script.drill, scenarios::world::judge(world));
}

// Copied once, and both played to the end side by side.
TEST_P(WholeCopy, ComesToTheSameScores) {
    const Script script(GetParam());
    std::mt19937 random(seed());
    const std::uint64_t when = *moments(random, 1, script.ticks()).begin();
    std::cout << "CARREL_SEED=" << seed() << ": copied after tick " << when << std::endl;
    World original = script.start();
    while (original.ticks() < when) script.tick(original);
    World copy = original;
    while (original.ticks() < script.ticks()) {
        script.tick(original), script.tick(copy);
        if (original.ticks() % look == 0) {
            ASSERT_EQ(original.hash(), copy.hash()) << "at tick " << original.ticks();
        }
    }
    EXPECT_EQ(original.hash_of_all_carried(), copy.hash_of_all_carried());
    EXPECT_EQ(scores_of(script, original), scores_of(script, copy));
    EXPECT_TRUE(std::ranges::equal(original.events(), copy.events()));
}

// Two drills, or with CARREL_LONG set all of them, which takes hours.
std::vector<fs::path> whole_drills() {
    const fs::path drills = CARREL_SOURCE "/scenarios/drills";
    if (std::getenv("CARREL_LONG")) return drill_files();
    return {drills / "square-knot.json", drills / "assisted-square-knot.json"};
}

INSTANTIATE_TEST_SUITE_P(Shipped, WholeCopy, testing::ValuesIn(whole_drills()), test_name);

}  // namespace hashes
