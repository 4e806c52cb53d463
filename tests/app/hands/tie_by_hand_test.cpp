#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/app/hands/late_post.hpp"
#include "tests/app/hands/plans.hpp"
#include "tests/app/hands/scene.hpp"

// Can the drills be played with nothing but a mouse and a keyboard? Somebody who sees the instruments and the thread
// plays them by events of devices alone; her hand points beside each goal by up to 3 pixels and each event comes up to
// 40 ms late.
using namespace app::hands;

namespace {

Seen look(const Scene& scene) {
    Seen seen;
    seen.t_s = scene.world().time_s();
    seen.tools = scene.inputs;
    seen.thread.assign(scene.world().thread().begin(), scene.world().thread().end());
    seen.along = {0};
    for (const double rest : scene.world().thread_state().rest_lengths())
        seen.along.push_back(seen.along.back() + rest);
    seen.tension_N = scene.world().tension_now();
    for (const auto& tool : scene.world().tools()) seen.strands.push_back(static_cast<int>(tool.grasps.size()));
    seen.sight = scene.taken.sight;
    return seen;
}

// From the front and above, in a window of 1280 by 720.
Sight field(const Vec3& middle, double distance) {
    return look_at(middle + distance * Vec3(0, -0.78, 0.62).normalized(), middle, Vec3::UnitZ(), 0.524, 720);
}

struct Play {
    std::string drill, assists;
    Sight sight;
    Skill skill;
    std::vector<Goal> (*plan)(const Scene& scene);
};

const Play square{"square-knot", "wrist,snap,pull-both", field({-4e-3, 0, 18e-3}, 0.17), {}, [](const Scene& scene) {
                      return square_knot(scene.motion, true);
                  }};
const Play square_unassisted{"square-knot", "", field({-4e-3, 0, 18e-3}, 0.17), {}, [](const Scene& scene) {
                                 return square_knot(scene.motion, false);
                             }};
const Play bite{"single-bite",
                "needle-wheel,snap",
                field({0, 0, 4e-3}, 0.08),
                {.speed = 12e-3, .lead = 2e-3, .keys_near = 1.2e-3},
                [](const Scene&) { return single_bite(); }};

void show(const Scene& scene, std::size_t goal) {
    std::printf("%7.3f s goal %2zu:", scene.world().time_s(), goal);
    for (const ToolInput& tool : scene.inputs)
        std::printf("  %6.1f %6.1f %6.1f mm", 1e3 * tool.pose.position.x(), 1e3 * tool.pose.position.y(),
                    1e3 * tool.pose.position.z());
    std::printf("  %.2f N %s\n", scene.world().tension_now(), scene.world().measures().knot.called().c_str());
    std::fflush(stdout);
}

// SHOW=1 in the environment prints each goal as it is reached.
scenarios::drill::Result played(const Play& play, unsigned seed) {
    constexpr double late_s = 0.04, limit_s = 180;
    static const bool shows = std::getenv("SHOW") != nullptr;
    Settings settings;
    settings.assists = parse_assists(play.assists);
    Scene scene(play.drill, settings);
    scene.taken.sight = play.sight;
    Player player(play.plan(scene), 1, 0, play.skill, seed);
    LatePost post(late_s, seed);
    const auto period = static_cast<std::uint64_t>(Player::period_s / scene.world().def().tick_s);
    double rests_s = 0;
    while (scene.world().time_s() < limit_s && rests_s < scenarios::drill::settling_s) {
        const double now_s = scene.world().time_s();
        if (scene.world().ticks() % period == 0) {
            const std::size_t goal = player.goal();
            post.send(player.play(look(scene)), now_s);
            if (shows && player.goal() != goal) show(scene, goal);
        }
        post.deliver(now_s, scene.taken.events);
        scene.tick();
        if (player.is_done()) rests_s += scene.world().def().tick_s;
    }
    const auto result = scene.session.finish();
    if (shows)
        for (const auto& event : result.events)
            std::printf("  %7.3f s %s %s %.3f\n", event.t_s, event.name(), event.what.c_str(), event.value);
    return result;
}

void expect_passed(const Play& play, unsigned seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const auto result = played(play, seed);
    EXPECT_TRUE(result.passed);
    std::printf("  seed %u: %s, %.1f s", seed, result.passed ? "passed" : "not passed", result.duration_s);
    for (const auto& item : result.items) {
        if (!item.passed) std::printf(", %s %s", item.name.c_str(), item.value.c_str());
        EXPECT_TRUE(item.passed) << item.name << " is " << item.value << ", expected " << item.band;
    }
    std::printf("\n");
    std::fflush(stdout);
}

// One seed; SEEDS=8-12 in the environment plays these instead.
void expect_all_passed(const Play& play) {
    unsigned first = 1, last = 1;
    if (const char* seeds = std::getenv("SEEDS")) std::sscanf(seeds, "%u-%u", &first, &last);
    for (unsigned seed = first; seed <= last; ++seed) expect_passed(play, seed);
}

}  // namespace

TEST(TieByHand, SquareKnotWithAssists) {
    expect_all_passed(square);
}
TEST(TieByHand, SquareKnotWithoutAssists) {
    expect_all_passed(square_unassisted);
}
TEST(SewByHand, SingleBiteByTheNeedleWheel) {
    expect_all_passed(bite);
}
