// When ticks are due and how fast they went, told the time by the test.
#include "scenarios/session/pacer.hpp"

#include <gtest/gtest.h>

using scenarios::recording::is_comparable;
using scenarios::recording::PaceRow;
using scenarios::session::PaceMeter;
using scenarios::session::Pacer;

namespace {

constexpr double tick_s = 1e-3;

// Ticks that take `cost_s` each, for `wall_s` from `now_s` on; how many.
int ticks_in(Pacer& pacer, double& now_s, double wall_s, double cost_s) {
    int ticks = 0;
    for (const double end_s = now_s + wall_s; now_s < end_s;) {
        if (const double wait_s = pacer.wait_s(now_s); wait_s > 0) {
            now_s += wait_s;
            continue;
        }
        now_s += cost_s;
        pacer.add_tick();
        ++ticks;
    }
    return ticks;
}

}  // namespace

// A computer that is fast enough goes by the clock, at any pace, and gives nothing up.
TEST(Pacer, KeepsItsPaceWhereTicksAreFast) {
    for (const double pace : {1.0, 0.35, 0.125}) {
        Pacer pacer(tick_s);
        pacer.set_pace(pace);
        double now_s = 7;
        pacer.start(now_s);
        EXPECT_NEAR(ticks_in(pacer, now_s, 10, 0.3e-3), 10000 * pace, 2) << pace;
        EXPECT_EQ(pacer.dropped_s(), 0);
    }
}

// Where ticks take three times as long as they may, it makes a third of them without a wait; once they are fast again
// it makes up for 50 ms and for no more.
TEST(Pacer, DropsWhatItOwesBeyondFiftyMilliseconds) {
    Pacer pacer(tick_s);
    double now_s = 0;
    pacer.start(now_s);
    EXPECT_NEAR(ticks_in(pacer, now_s, 3, 3e-3), 1000, 1);
    EXPECT_NEAR(pacer.dropped_s(), 3 - 1 - 0.05, 0.01);
    EXPECT_NEAR(ticks_in(pacer, now_s, 1, 0.1e-3), 1050, 5);
    const double dropped_s = pacer.dropped_s();
    now_s += 60;
    pacer.start(now_s);
    EXPECT_NEAR(ticks_in(pacer, now_s, 1, 0.1e-3), 1000, 2) << "a pause owes nothing";
    EXPECT_EQ(pacer.dropped_s(), dropped_s);
}

// A row a second: the rate of that second without the pause in it, what was given up in it, and delays of it alone.
TEST(PaceMeter, TellsEachSecond) {
    PaceMeter meter(tick_s);
    double now_s = 100;
    meter.start(now_s);
    std::vector<PaceRow> rows;
    const auto tick = [&](double wall_s) {
        now_s += wall_s;
        if (const auto row = meter.add_tick(now_s, 0.001 * static_cast<double>(rows.size()))) rows.push_back(*row);
    };
    for (int i = 0; i < 500; ++i) tick(1e-3);
    EXPECT_NEAR(meter.rate(now_s), 1, 1e-9) << "before the first second is over";
    meter.halt(now_s);
    now_s += 30;
    meter.start(now_s);
    for (int k = 1; k <= 100; ++k) meter.add_used(1e-3 * k);
    while (rows.size() < 1) tick(1e-3);
    while (rows.size() < 2) tick(4e-3);
    meter.add_shown(0.07);
    for (int i = 0; i < 300; ++i) tick(2e-3);
    const auto last = meter.last_row(now_s, 0.002);
    ASSERT_TRUE(last);
    rows.push_back(*last);
    const double rates[] = {1, 0.25, 0.5};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(rows[i].rate, rates[i], 0.005) << i;
    EXPECT_NEAR(static_cast<double>(rows[0].tick), 1000, 2);
    EXPECT_NEAR(static_cast<double>(rows[1].tick), 1250, 3);
    EXPECT_NEAR(rows[2].wall_s, 2.6, 0.01);
    EXPECT_NEAR(rows[1].dropped_ms, 1, 1e-9);
    ASSERT_TRUE(rows[0].used && rows[2].shown);
    EXPECT_NEAR(rows[0].used->p50_ms, 51, 1e-9);
    EXPECT_NEAR(rows[0].used->p99_ms, 100, 1e-9);
    EXPECT_NEAR(rows[2].shown->p50_ms, 70, 1e-9);
    EXPECT_FALSE(rows[0].shown || rows[1].used || rows[2].used);
    EXPECT_FALSE(meter.last_row(now_s, 0.002)) << "nothing is left";
}

// One slow second in twenty is let pass; two are not, nor is a whole session that is a little too slow.
TEST(PaceMeter, AnAttemptThatIsTooSlowIsNotComparable) {
    const auto rows = [](int fast, int slow, double rate) {
        std::vector<PaceRow> all;
        for (int i = 0; i < fast + slow; ++i) all.push_back({.rate = i < slow ? rate : 1.0});
        return all;
    };
    EXPECT_TRUE(is_comparable({}, 1));
    EXPECT_TRUE(is_comparable(rows(39, 1, 0.3), 1));
    EXPECT_FALSE(is_comparable(rows(37, 3, 0.3), 1));
    EXPECT_FALSE(is_comparable(rows(0, 10, 0.94), 1));
    EXPECT_TRUE(is_comparable(rows(0, 10, 0.96), 1));
    EXPECT_TRUE(is_comparable(rows(0, 10, 0.34), 0.35)) << "what the drill declares is what counts";
    EXPECT_FALSE(is_comparable(rows(0, 10, 0.33), 0.35));
}
