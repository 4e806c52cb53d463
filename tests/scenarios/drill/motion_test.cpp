#include "scenarios/drill/motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scenarios/drill/drill.hpp"

namespace motions {

using namespace scenarios::drill;
using instruments::ToolInput;

const std::string header = "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw\n";
const std::vector<std::string> both = {"left", "right"};

Motion motion(const std::string& rows) {
    return parse_motion(header + rows, "m.csv", both);
}

std::string message(const std::string& text) {
    try {
        parse_motion(text, "m.csv", both);
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

std::array<ToolInput, 2> at(const Motion& m, double t) {
    std::array<ToolInput, 2> tools;
    m.at(t, tools);
    return tools;
}

// A turn of 90 degrees about z with the jaw closing, while the other tool stays.
const std::string quarter_turn =
    "1,left,0,0,0,1,0,0,0,1\n"
    "0,right,5,6,7,1,0,0,0,0.5\n"
    "3,left,10,20,40,0.7071067811865476,0,0,0.7071067811865476,0\n";

// Tools move on straight lines and turn at constant rate; a wrong blend ties another knot than the author drew.
TEST(Motion, PositionAndJawAreLinearAndRotationTurnsAtConstantRate) {
    const Motion m = motion(quarter_turn);
    for (const double u : {0.0, 0.25, 0.5, 0.9, 1.0}) {
        SCOPED_TRACE(u);
        const auto tool = at(m, 1 + 2 * u)[0];
        EXPECT_LT((tool.pose.position - u * sim::geometry::Vec3(0.01, 0.02, 0.04)).norm(), 1e-17);
        EXPECT_NEAR(tool.jaw, 1 - u, 1e-15);
        const double half = u * M_PI / 4;
        EXPECT_NEAR(tool.pose.rotation.w(), std::cos(half), 1e-14);
        EXPECT_NEAR(tool.pose.rotation.z(), std::sin(half), 1e-14);
    }
    EXPECT_EQ(at(m, 2)[1].pose.position, sim::geometry::Vec3(0.005, 0.006, 0.007));
}

// Before its first row and after its last a tool waits there; extrapolation would throw it out of the scene.
TEST(Motion, SaysWhatADrillThatEndsEarlierLoses) {
    const Motion motion({{{0, {}}, {2.505, {}}}, {{1, {}}}});
    EXPECT_EQ(motion.cut_short_at(3.01), "");
    for (const auto& [limit, shown] : {std::pair(2.0, "2"), {2.51, "2.51"}})
        EXPECT_EQ(motion.cut_short_at(limit),
                  "/time_limit_s: " + std::string(shown) +
                      " s end the drill before its motion, which takes 2.51 s and 0.5 s of rest");
}

TEST(Motion, HoldsItsEnds) {
    const Motion m = motion(quarter_turn);
    EXPECT_EQ(at(m, -1)[0].pose.position, at(m, 1)[0].pose.position);
    EXPECT_EQ(at(m, 99)[0].pose.position, sim::geometry::Vec3(0.01, 0.02, 0.04));
    EXPECT_EQ(m.duration(), 3);
}

// q and -q are one rotation: a tracker that flips sign between rows must not spin the tool by 360 degrees.
TEST(Motion, SignOfQuaternionsDoesNotMatter) {
    std::string flipped = quarter_turn;
    const std::string from = "0.7071067811865476,0,0,0.7071067811865476";
    flipped.replace(flipped.find(from), from.size(), "-0.7071067811865476,0,0,-0.7071067811865476");
    const Motion a = motion(quarter_turn), b = motion(flipped);
    for (double t = 1; t <= 3; t += 0.125)
        EXPECT_NEAR(std::abs(at(a, t)[0].pose.rotation.dot(at(b, t)[0].pose.rotation)), 1, 1e-15) << t;
}

// Hand-written quaternions have three digits; unnormalised they would scale the tool.
TEST(Motion, QuaternionsAreNormalised) {
    const auto q = at(motion("0,left,0,0,0,0.71,0,0,0.71,0\n0,right,0,0,0,1,0,0,0,1\n"), 0)[0].pose.rotation;
    EXPECT_NEAR(q.norm(), 1, 1e-15);
    EXPECT_NEAR(q.w(), std::sqrt(0.5), 1e-15);
}

// What motion_text saves must play the same motion: rows of both tools, every digit.
TEST(Motion, WrittenMotionReadsBack) {
    const Motion a = motion(quarter_turn), b = parse_motion(motion_text(a, both), "again", both);
    for (double t = 0; t <= 4; t += 0.1)
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_LT((at(a, t)[i].pose.position - at(b, t)[i].pose.position).norm(), 1e-17);
            EXPECT_LT(at(a, t)[i].pose.rotation.angularDistance(at(b, t)[i].pose.rotation),
                      1e-7);  // acos near 1 keeps half the digits
            EXPECT_EQ(at(a, t)[i].jaw, at(b, t)[i].jaw);
        }
}

// The message is the interface: line, column, name of the column, what is wrong and what would be right.
TEST(Motion, SaysWhatIsWrongWordForWord) {
    const std::string right = "0,right,0,0,0,1,0,0,0,1\n";
    const std::pair<std::string, std::string> cases[] = {
        {"", "m.csv:1: error: expected the header t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw, found \"\""},
        {"t_s,instrument,x_cm,y_cm,z_cm,qw,qx,qy,qz,jaw\n",
         "m.csv:1: error: expected the header t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw, found "
         "\"t_s,instrument,x_cm,y_cm,z_cm,qw,qx,qy,qz,jaw\""},
        {header + right, "m.csv: error: has no row of the instrument \"left\", expected at least one"},
        {header + right + "0,left,0,0,0,1,0,0,0\n", "m.csv:3: error: expected 10 columns, found 9"},
        {header + right + "0,left,0,0,0,1,0,0,0,1,2\n", "m.csv:3: error: expected 10 columns, found 11"},
        {header + right + "0,lefty,0,0,0,1,0,0,0,1\n",
         "m.csv:3:3: error: instrument: the drill has no instrument \"lefty\", it has \"left\", \"right\""},
        {header + right + "0,left,0,nan,0,1,0,0,0,1\n",
         "m.csv:3:10: error: y_mm: expected -1000 to 1000 mm, found \"nan\""},
        {header + right + "0,left,0,0,inf,1,0,0,0,1\n",
         "m.csv:3:12: error: z_mm: expected -1000 to 1000 mm, found \"inf\""},
        {header + right + "0,left,0,1e9,0,1,0,0,0,1\n",
         "m.csv:3:10: error: y_mm: expected -1000 to 1000 mm, found \"1e9\""},
        {header + right + "0,left,0,5mm,0,1,0,0,0,1\n", "m.csv:3:10: error: y_mm: expected a number, found \"5mm\""},
        {header + right + "0,left,0,0,0,0,0,0,0,1\n",
         "m.csv:3:14: error: qw: qw,qx,qy,qz has length 0, expected a unit quaternion"},
        {header + right + "0,left,0,0,0,1,0,0,0,1.5\n", "m.csv:3:22: error: jaw: expected 0 to 1, found \"1.5\""},
        {header + right + "1,left,0,0,0,1,0,0,0,1\n1,left,0,0,0,1,0,0,0,1\n",
         "m.csv:4:1: error: t_s: expected a time after 1 s, the row before of \"left\", found \"1\""},
        {header + right + "-1,left,0,0,0,1,0,0,0,1\n", "m.csv:3:1: error: t_s: expected 0 to 7200 s, found \"-1\""},
    };
    for (const auto& [text, expected] : cases) EXPECT_EQ(message(text), expected);
}

// As spreadsheets and trackers write them: names in quotes, columns of their own behind ours.
TEST(Motion, ReadsCellsInQuotesAndFurtherColumns) {
    const Motion plain = motion(quarter_turn);
    std::string quoted = quarter_turn;
    for (const std::string name : {"left", "right"})
        for (std::size_t at = 0; (at = quoted.find("," + name + ",", at)) != std::string::npos; at += 2)
            quoted.replace(at, name.size() + 2, ", \"" + name + "\" ,");
    EXPECT_EQ(motion_text(motion(quoted), both), motion_text(plain, both));
    std::string wide = header + quarter_turn;
    for (std::size_t at = 0; (at = wide.find('\n', at)) != std::string::npos; at += 11)
        wide.insert(at, at < header.size() ? ",frame,who" : ",7,\"A, B\"");
    EXPECT_EQ(motion_text(parse_motion(wide, "m.csv", both), both), motion_text(plain, both));
    std::string names = "\"t_s\",\"instrument\",x_mm,y_mm,z_mm,qw,qx,qy,qz,\"jaw\"\r\n";
    EXPECT_EQ(motion_text(parse_motion(names + quarter_turn, "m.csv", both), both), motion_text(plain, both));
    EXPECT_EQ(message(header.substr(0, header.size() - 1) + ",frame\n0,left,0,0,0,1,0,0,0,1\n"),
              "m.csv:2: error: expected 11 columns as in the header, found 10");
    EXPECT_EQ(message(header + "0,\"left,0,0,0,1,0,0,0,1\n"),
              "m.csv:2: error: expected a closing '\"' after the one in this line");
    EXPECT_EQ(message(header + "0,\"left\"x,0,0,0,1,0,0,0,1\n"),
              "m.csv:2: error: expected ',' behind a cell in quotes");
}

// 100 rows a second of a tool that goes along x at 20 mm/s, from row to row but for those left out.
Motion tracked(int from, int to, double step_s = 0.01) {
    std::vector<MotionKey> keys;
    for (int i = 0; i < 400; ++i) {
        if (i > from && i < to) continue;
        keys.push_back({step_s * i, {}});
        keys.back().input.pose.position.x() = 0.02 * step_s * i;
    }
    return Motion({keys, {{0, {}}}});
}

// A tracker that lost sight of its tool for a second and a half: the tool goes straight where its hand did not.
TEST(Motion, TellsWhereADeviceLeftOutRows) {
    EXPECT_EQ(
        tracked(200, 350).gaps(both),
        std::vector<std::string>{"\"left\" has no row between 2 and 3.5 s, where others are 0.01 s apart, and goes "
                                 "straight over the gap, by 30 mm"});
    EXPECT_EQ(tracked(10, 20, 0.1).gaps(both).size(), 1u) << "ten rows a second, a second left out";
    EXPECT_EQ(tracked(200, 220).gaps(both).size(), 0u) << "0.2 s: a hand does little in it";
    EXPECT_EQ(tracked(0, 0).gaps(both).size(), 0u);
    std::vector<MotionKey> still(400);  // what stands still is often written when it moves again
    for (std::size_t i = 0; i < still.size(); ++i) still[i].t_s = 0.01 * static_cast<double>(i) + (i > 200 ? 1.5 : 0);
    EXPECT_EQ(Motion({still}).gaps(std::vector<std::string>{"left"}).size(), 0u);
    for (const char* drill : {"square-knot", "granny-knot", "surgeons-knot", "single-bite", "stay-sutures"}) {
        const Drill read = load_drill(std::string(CARREL_SOURCE) + "/scenarios/drills/" + drill + ".json");
        const auto names = instrument_names(read);
        EXPECT_EQ(load_motion(read.motion, names).gaps(names), std::vector<std::string>()) << drill << ": by hand";
    }
}

}  // namespace motions
