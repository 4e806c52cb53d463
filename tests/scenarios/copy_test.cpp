// A copy of a world goes on as the original does, bit for bit, at whatever tick of a drill it was taken.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <set>

#include "scenarios/drill/motion.hpp"
#include "scenarios/drill/score.hpp"
#include "scenarios/session/scene.hpp"
#include "scenarios/world/judge.hpp"
#include "tests/scenarios/world/for_tests.hpp"

namespace {

namespace fs = std::filesystem;
using scenarios::world::Event;
using scenarios::world::ForTests;
using scenarios::world::World;

// Ticks between two state hashes, and of a naming: one starts every 100 ticks and is fetched 20 later.
constexpr std::uint64_t look = 10, period = 100, in_flight = 20;

unsigned seed() {
    const char* given = std::getenv("CARREL_SEED");
    return given ? static_cast<unsigned>(std::atoi(given)) : 1;
}

/// A drill and the motion file that plays it.
struct Script {
    explicit Script(const fs::path& file) : drill(scenarios::drill::load_drill(file)), motion(motion_of(drill)) {}

    static scenarios::drill::Motion motion_of(const scenarios::drill::Drill& drill) {
        std::vector<std::string> names;
        for (const auto& instrument : drill.world.instruments) names.push_back(instrument.name);
        return scenarios::drill::load_motion(drill.motion, names);
    }
    std::uint64_t ticks() const {
        return static_cast<std::uint64_t>(
            std::ceil((motion.duration() + scenarios::drill::settling_s) / drill.world.tick_s));
    }
    std::vector<instruments::ToolInput> inputs(std::uint64_t tick) const {
        std::vector<instruments::ToolInput> inputs(drill.world.instruments.size());
        motion.at(static_cast<double>(tick) * drill.world.tick_s, inputs);
        return inputs;
    }
    World start() const {
        return scenarios::session::make_world(drill.world, scenarios::session::vessel_meshes(drill.world), inputs(0));
    }
    void tick(World& world) const { world.tick(inputs(world.ticks())); }

    scenarios::drill::Drill drill;
    scenarios::drill::Motion motion;
};

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

/// Plays a drill and copies it after these ticks and, if it has a needle, once more when that has been in a
/// wall for `in_a_wall` ticks. Copies lie untouched while the original goes on for `ahead` ticks after each, and is
/// gone before they are played: what they shared with it would be another's or nobody's then.
Copies copies_of(const Script& script, const std::set<std::uint64_t>& when, std::uint64_t in_a_wall,
                 std::uint64_t ahead) {
    World original = script.start();
    Copies copies;
    std::uint64_t last = *when.rbegin() + 1, ticks_in_a_wall = 0;
    const auto copy = [&] {
        copies.copied.push_back({original, std::min(script.ticks(), original.ticks() + ahead)});
        last = std::max(last, copies.copied.back().until);
    };
    const std::uint64_t last_for_needle = original.needles().empty() ? 0 : script.ticks();
    while (original.ticks() < last || (ticks_in_a_wall < in_a_wall && original.ticks() < last_for_needle)) {
        if (when.count(original.ticks())) copy();
        script.tick(original);
        if (is_in_a_wall(original) && ++ticks_in_a_wall == in_a_wall) copy();
        if (original.ticks() % look == 0) copies.hashes.push_back(original.hash());
        for (Copied& one : copies.copied)
            if (one.until == original.ticks())
                one.carried = original.hash_of_all_carried(),
                one.events.assign(original.events().begin(), original.events().end());
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

class Copy : public testing::TestWithParam<fs::path> {};

// Fifty-four moments of all drills: of those that take minutes within their first 20 s, of the others anywhere. Most
// are of the drills whose ticks cost least.
TEST_P(Copy, GoesOnAsTheOriginalFiveSecondsOn) {
    const Script script(GetParam());
    const bool is_long = script.motion.duration() > 60, has_needle = !script.drill.world.needle_code.empty();
    std::mt19937 random(seed());
    const std::size_t count = has_needle ? 2 : script.drill.world.thread.model == "elastic" ? 3 : 10;
    const auto when = moments(random, count, is_long ? 20'000 : script.ticks());
    const std::uint64_t in_a_wall = 1 + random() % 300;
    std::cout << "CARREL_SEED=" << seed() << ": copied after tick";
    for (const std::uint64_t tick : when) std::cout << ' ' << tick;
    if (has_needle) std::cout << " and after " << in_a_wall << " ticks in a wall";
    std::cout << std::endl;
    const Copies copies = copies_of(script, when, in_a_wall, 5'000);
    EXPECT_EQ(copies.copied.size(), when.size() + has_needle);
    EXPECT_GT(
        std::ranges::count_if(copies.copied, [](const Copied& one) { return ForTests::is_being_named(one.world); }), 0);
    for (const Copied& copied : copies.copied) expect_goes_on_alike(script, copied, copies.hashes);
}

std::vector<fs::path> drill_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(CARREL_SOURCE "/scenarios/drills"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.stem();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Drills, Copy, testing::ValuesIn(drill_files()), test_name);

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

INSTANTIATE_TEST_SUITE_P(Drills, WholeCopy, testing::ValuesIn(whole_drills()), test_name);

}  // namespace
