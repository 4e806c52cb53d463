#include <gtest/gtest.h>

#include <limits>

#include "tests/sim/thread/scene.hpp"

namespace {

using namespace scene;

std::vector<Vec3> nodes_of(const Thread& thread) {
    return {thread.nodes().begin(), thread.nodes().end()};
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

// A tight knot that creeps or trembles while nobody touches it would untie itself while the trainee thinks.
TEST(Rest, ATightKnotBetweenStillToolsStopsMoving) {
    Thread thread({}, overhand());
    Pull pull(thread);
    tighten(thread, pull, 0.1, 400);
    pull.left = thread.nodes().front();
    pull.right = thread.nodes().back();
    for (int i = 0; i < 100; ++i) pull.hold(thread);
    const auto settled = nodes_of(thread);
    for (int i = 0; i < 200; ++i) pull.hold(thread);
    EXPECT_EQ(farthest(settled, nodes_of(thread)), 0);
}

// Tools that ask for 5 % more thread than there is, wait, and let go. Stretch in between would be a thread of rubber; a
// tension that stays after letting go would score a pull nobody makes.
TEST(Rest, AnOverpulledThreadIsTautThenSlackAndNeverLong) {
    Thread thread({}, straight(100));
    Pull pull(thread);
    const double over = 0.05 * end_distance(thread) / 2;
    double worst = 0;
    const auto tick_at = [&](double out) {
        pull.left = Vec3(-out, 0, 0);
        pull.right = Vec3(100 * 2 * radius + out, 0, 0);
        worst = std::max(worst, pull.hold(thread).stretch_max);
    };
    const auto tension = [&] { return *std::max_element(thread.tension().begin(), thread.tension().end()); };
    for (int i = 1; i <= 50; ++i) tick_at(over * i / 50);
    for (int i = 0; i < 50; ++i) tick_at(over);
    EXPECT_GT(tension(), 0);
    for (int i = 50; i-- > 0;) tick_at(over * i / 50);
    for (int i = 0; i < 20; ++i) tick_at(-over);
    EXPECT_EQ(tension(), 0);
    EXPECT_LE(worst, 1e-3);
}

// One broken number from a device must not reach the thread: a single NaN would spread to every node within a tick.
TEST(Rest, ATickWithANumberThatIsNotFiniteIsNotTaken) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    Thread thread({}, overhand());
    Pull pull(thread);
    pull.by(thread, 0.1e-3);
    const auto hash = thread.hash();
    for (const double bad : {nan, infinite, -infinite}) {
        const Hold holds[] = {{0, Vec3(0, bad, 0)}};
        const int owners[] = {-1};
        const TickReport report = thread.tick({holds, owners, {}, nullptr});
        EXPECT_TRUE(report.not_finite);
        EXPECT_EQ(report.fraction, 0);
        const sim::geometry::Capsule good{Vec3(1, 0, 0), Vec3(1, 1, 0), 1e-3},
            start{Vec3(1, 0, bad), Vec3(1, 1, 0), 1e-3}, end{Vec3(1, 0, 0), Vec3(1, bad, 0), 1e-3};
        for (const auto& [from, to] : {std::pair(good, start), {good, end}, {start, good}, {end, good}}) {
            const sim::thread::MovingCapsule capsules[] = {{from, to, 0}};
            EXPECT_TRUE(thread.tick({{}, {}, capsules, nullptr}).not_finite);
        }
        EXPECT_EQ(thread.hash(), hash);
    }
    EXPECT_FALSE(pull.by(thread, 0.1e-3).not_finite);  // and it goes on afterwards
}

}  // namespace
