#include <gtest/gtest.h>

#include "app/play/output.hpp"

// The table on a terminal says of each item what it came to, when, and whether that was asked for.
TEST(ScoreTable, HasALineForEachItem) {
    scenarios::drill::Result result;
    result.drill_title = "Square knot";
    result.items = {{"knot", "Knot", "granny", "", "square", false, 21.5, "The second throw went the same way round."},
                    {"tail_short", "Shorter tail", "6.1", "mm", "3 to 8", true, 24, ""},
                    {"path_left", "Path length, left tool", "402", "mm", "", true, 131, ""}};
    result.links = 141, result.stretch_max = 0.0125, result.stretch_settled = 0.0034, result.pass_throughs = 2;
    result.tick_us = {41, 63, 120};
    EXPECT_EQ(app::score_table(result),
              "Square knot: not passed\n"
              "  MISS Knot                                         granny     square           at  21.50 s\n"
              "       The second throw went the same way round.\n"
              "  ok   Shorter tail                                    6.1 mm  3 to 8           at  24.00 s\n"
              "  -    Path length, left tool                          402 mm                   at 131.00 s\n"
              "  thread: 141 links, stretch at most 1.250 %, at rest 0.340 %, pass-throughs 2; tick p50 41 us, "
              "p99 63 us\n");
    result.passed = true;
    EXPECT_TRUE(app::score_table(result).starts_with("Square knot: passed\n"));
    result.finished = false;
    EXPECT_TRUE(app::score_table(result).starts_with("Square knot: broken off, not finished\n"));
}

// What to work on stands first, as in the report and the window.
TEST(ScoreTable, IsInTheOrderOfWhatMatters) {
    scenarios::drill::Result result;
    result.items = {{"path", "Path", "402", "mm", "", true, 131, ""},
                    {"tail", "Tail", "6.1", "mm", "3 to 8", true, 24, ""},
                    {"time", "Time", "131.0", "s", "at most 120", false, 131, "It took too long."}};
    const std::string table = app::score_table(result);
    EXPECT_LT(table.find("MISS Time"), table.find("ok   Tail"));
    EXPECT_LT(table.find("ok   Tail"), table.find("-    Path"));
}
