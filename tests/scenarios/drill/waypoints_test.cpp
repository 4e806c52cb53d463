// What a person writes of hands becomes what they do.
#include "scenarios/drill/waypoints.hpp"

#include <gtest/gtest.h>

#include "scenarios/drill/file.hpp"

namespace {

using namespace scenarios::drill;
using instruments::ToolInput;
using sim::geometry::Vec3;

constexpr double mm = 1e-3;
const std::string one_hand = "tool hand pointing 0 1 0 opening 0 0 1\nstart hand 3 0 5 jaw 0\n";

// Of the one tool, at a time [s].
ToolInput at(const std::string& steps, double time) {
    const Waypoints read = parse_waypoints(one_hand + steps, "w");
    ToolInput input;
    read.motion.at(time, {&input, 1});
    return input;
}

// What is wrong with a file, if anything is.
std::string said_of(const std::string& text) {
    try {
        parse_waypoints(text, "w");
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

// And with what the one tool does.
std::string said(const std::string& steps) {
    return said_of(one_hand + steps);
}

// A needle goes through one hole only if its holder turns about the needle's own axis, place and attitude alike.
TEST(Waypoints, ATurnGoesRoundAnAxis) {
    const Vec3 centre(0, 0, 5 * mm);
    for (double time = 0; time <= 2; time += 0.05) {
        const ToolInput hand = at("turn hand 90 about 0 -1 0 through 0 0 5 in 2\n", time);
        const Vec3 arm = hand.pose.position - centre;
        EXPECT_NEAR(arm.norm(), 3 * mm, 1e-3 * 3 * mm) << time;  // pieces of 5 degrees
        EXPECT_LT((hand.pose.rotation * Vec3::UnitZ() - Vec3::UnitY()).norm(),
                  1e-12);  // along the axis still; rounding
        EXPECT_NEAR((hand.pose.rotation * Vec3::UnitX()).dot(arm.normalized()), 0,
                    1e-3);  // opens across the arm, as it did
    }
    const ToolInput turned = at("turn hand 90 about 0 -1 0 through 0 0 5 in 2\n", 2);
    EXPECT_LT((turned.pose.position - Vec3(0, 0, 8 * mm)).norm(), 1e-9 * mm);
}

TEST(Waypoints, AMirrorTurnsTheOtherWayRound) {
    const Vec3 plain = at("turn hand 30 about 1 0 1 through 0 4 5 in 1\n", 1).pose.position;
    const Vec3 mirrored = at("mirror y\nturn hand 30 about 1 0 1 through 0 4 5 in 1\n", 1).pose.position;
    EXPECT_LT((mirrored - Vec3(plain.x(), -plain.y(), plain.z())).norm(), 1e-9 * mm);
    EXPECT_GT(std::abs(plain.y()), 0.1 * mm);
}

// The same steps, seen from a place turned by a quarter: what they do is moved and turned as a whole.
TEST(Waypoints, AFrameMovesAndTurnsWhatFollows) {
    const std::string steps =
        "tool hand pointing 1 0 -1 opening 0 1 0\ngo hand 1 2 3\nturn hand 40 about 1 0 2 through 0 4 5 in 1\n";
    const ToolInput plain = at("speed 2000\n" + steps, 9),
                    framed = at("speed 2000\nframe 7 0 2 turned 90 about 0 0 1\n" + steps, 9);
    const sim::geometry::Quat quarter(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitZ()));
    EXPECT_LT((framed.pose.position - (Vec3(7, 0, 2) * mm + quarter * plain.pose.position)).norm(), 1e-9 * mm);
    EXPECT_LT(framed.pose.rotation.angularDistance(quarter * plain.pose.rotation), 1e-9);
    const ToolInput back = at("frame 7 0 2 turned 90 about 0 0 1\nframe 0 0 0\nspeed 2000\n" + steps, 9);
    EXPECT_LT((back.pose.position - plain.pose.position).norm(), 1e-9 * mm);
}

// Steps that were named are as good as those written out, wherever they are played.
TEST(Waypoints, NamedStepsArePlayedInAFrame) {
    const std::string inner =
        "frame 1 0 0 turned 90 about 1 0 0\ngo hand 3 2 0\nturn hand 30 about 0 0 1 through 0 1 0 in 1\nmirror y\ngo "
        "hand 3 2 0\n";
    const std::string played =
        "steps bite\n" + inner + "end\nspeed 10\nframe 0 0 4 turned 90 about 0 0 1\nplay bite\ngo hand 1 2 3\n";
    // The outer frame has x along y, y along -x; the inner's y is up there, its z along x.
    const std::string places = "speed 10\ngo hand 0 4 6\n";
    EXPECT_LT((at(played, 0.5).pose.position - at(places, 0.5).pose.position).norm(), 1e-9 * mm);
    EXPECT_LT((at(played, 60).pose.position - Vec3(-2 * mm, 1 * mm, 7 * mm)).norm(), 1e-9 * mm)
        << "the frame from before is back, and nothing is mirrored";
    const std::string twice = "speed 10\nsteps out\ngo hand 30 0 0\ngo hand 0 0 0\nend\nplay out\nplay out\n";
    EXPECT_NEAR(at(twice, 3.583095 + 3 + 3).pose.position.x(), at(twice, 3.583095 + 3 - 3).pose.position.x(), 1e-5);
}

TEST(Waypoints, SaysWhatIsWrongWithNamedSteps) {
    EXPECT_EQ(said("play bite\n"), "w:3: error: no steps are called \"bite\", expected `steps bite` before");
    EXPECT_EQ(said("steps bite\nwait 1\n"), "w:4: error: `steps bite` has no `end`");
    EXPECT_EQ(said("end\n"), "w:3: error: `end` of nothing, expected `steps` before it");
    EXPECT_EQ(said("steps a\nsteps b\nend\n"), "w:4: error: `steps` within `steps a`, expected `end` first");
    EXPECT_EQ(said("steps a\nend\nsteps a\nend\n"), "w:5: error: `steps a` a second time, expected another name");
    EXPECT_EQ(said("steps a\nplay a\nend\nplay a\n"), "w:4: error: `play` within steps, expected no such line");
    EXPECT_EQ(said("steps a\nwait 1\nend\n"), "w:4: error: `steps a` are never played, expected `play a` after them");
    std::string plays = "steps a\nwait 1\nwait 1\nwait 1\nend\n";
    for (int i = 0; i < 40000; ++i) plays += "play a\n";
    EXPECT_EQ(said(plays), "w:25007: error: the 100000th step with all that is played, expected fewer");
    EXPECT_EQ(said("steps a\nwait x\nend\nplay a\n").substr(0, 4), "w:4:")
        << "the line that is wrong, not the one that plays it";
}

TEST(Waypoints, SaysWhatWouldMoveNothingOrTooFar) {
    EXPECT_EQ(said("go\n"), "w:3: error: `go` moves nothing, expected a tool and its place");
    EXPECT_EQ(said("tool hnd pointing 0 0 1 opening 1 0 0\n").substr(0, 35), "w:3: error: no tool is called \"hnd\"");
    EXPECT_EQ(said_of("tool hnd pointing 0 0 1 opening 1 0 0\nstart hand 0 0 0 jaw 1\nwait 1\n"),
              "w:1: error: no tool is called \"hnd\", expected one of: hand");
    EXPECT_EQ(said("frame 900 0 0\ngo hand 900 0 0\n"),
              "w:4: error: that is 1800 0 0 mm seen from outside all frames, expected -1000 to 1000 each");
    EXPECT_EQ(said("frame 0 0 0 turned 90 about 1e-300 0 0\n"),
              "w:3: error: the axis has no direction, expected one component other than 0");
}

TEST(Waypoints, SaysWhatIsWrongWithATurn) {
    EXPECT_EQ(said("turn hand 30 about 0 0 0 through 0 0 0 in 1\n"),
              "w:3: error: the axis has no direction, expected one component other than 0");
    EXPECT_EQ(said("frame 0 0 0 turned 90 about 0 0 0\n"),
              "w:3: error: the axis has no direction, expected one component other than 0");
    EXPECT_EQ(said("frame 0 0\n"), "w:3: error: expected origin in mm at the end of the line");
    EXPECT_EQ(said("turn hand 30 around 0 0 1 through 0 0 0 in 1\n"),
              "w:3: error: expected \"about\", found \"around\"");
    EXPECT_EQ(said("turn hand 30 about 0 0 1 through 0 0 0 in 0\n"),
              "w:3: error: seconds: expected a number from 0.001 to 600, found \"0\"");
    EXPECT_EQ(said("turn hand 30 about 0 0 1 through 0 0 0\n"), "w:3: error: expected \"in\" at the end of the line");
}

}  // namespace
