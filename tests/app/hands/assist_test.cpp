#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/fault.hpp"
#include "tests/app/hands/scene.hpp"

using namespace app::hands;
using scenarios::world::EventKind;

namespace {

Settings with(const std::string& names) {
    Settings settings;
    settings.assists = parse_assists(names);
    return settings;
}

// The knot drill with the right instrument's open tips at a place beside the tail, which lies along y at x = -14 mm,
// z = 3 mm.
struct AtTheTail : Scene {
    AtTheTail(const Settings& settings, const Vec3& bite, double roll = 0) : Scene("square-knot", settings) {
        const Quat turned = inputs[1].pose.rotation * Quat(Eigen::AngleAxisd(roll, Vec3::UnitZ()));
        lead(1, {{bite + bite_depth * (turned * Vec3::UnitZ()), turned}, 0.7}, settings);
    }
    // Brings an instrument somewhere, without a jump, and gives it new hands there.
    void lead(std::size_t i, const ToolInput& to, const Settings& settings) {
        const ToolInput from = inputs[i];
        constexpr int ticks = 600;
        for (int k = 1; k <= ticks; ++k) {
            const double share = static_cast<double>(k) / ticks;
            inputs[i] = {instruments::between(from.pose, to.pose, share), from.jaw + share * (to.jaw - from.jaw)};
            session.tick(inputs);
        }
        hands = std::make_unique<Hands>(settings, drill.world.instruments, inputs);
    }
    void ticks(int count) {
        for (int k = 0; k < count; ++k) tick();
    }
    void click() { post(Click{Button::left, true}), post(Click{Button::left, false}); }
    void press(Action action) { post(Press{action, true}), post(Press{action, false}); }
    const scenarios::world::Tool& right() const { return world().tools()[1]; }
};

const Vec3 tail(-14e-3, -17e-3, 3e-3);

double off_square(const Quat& rotation, const Vec3& along) {
    return std::acos(std::min(1.0, std::abs((rotation * Vec3::UnitY()).dot(along))));
}

}  // namespace

TEST(Assists, AreNamedAsInTheTable) {
    EXPECT_EQ(parse_assists("snap,wrist").names(), "wrist,snap");
    EXPECT_EQ(parse_assists("").names(), "");
    EXPECT_THROW(parse_assists("snap,wirst"), app::InputFault);
    for (const AssistRow& row : assist_rows) EXPECT_EQ(name_of(row.assist), std::string(row.name));
}

TEST(Assists, EachSwitchIsAMark) {
    Scene scene("square-knot");
    std::vector<std::string> marks;
    scene.hands = std::make_unique<Hands>(
        Settings(), scene.drill.world.instruments, scene.inputs,
        [&](const std::string& kind, const std::string& text) { marks.push_back(kind + ": " + text); });
    scene.post(Switch{Assist::snap, true});
    scene.post(Switch{Assist::snap, true});
    scene.post(Switch{Assist::snap, false});
    scene.post(Switch{Assist::pull_both, true});
    scene.ask();
    EXPECT_EQ(marks, (std::vector<std::string>{"assist: snap on", "assist: snap off", "assist: pull-both on"}));
    EXPECT_EQ(scene.hands->view().assists.names(), "pull-both");
    scene.post(Switch{Assist::slow_motion, true});
    scene.ask();
    EXPECT_EQ(scene.hands->view().pace, 0.5);
}

// From 2 mm beside the tail in any direction the jaws come to take it; without the assist they close on nothing.
TEST(Assists, SnapTakesWhatIsLit) {
    for (const auto& [names, beside] :
         {std::pair("snap", Vec3(2.2e-3, 0, 0.5e-3)), std::pair("snap", Vec3(1e-3, 0, -1.8e-3)),
          std::pair("snap", Vec3(1e-3, 0, 2e-3)), std::pair("", Vec3(2.2e-3, 0, 0.5e-3))}) {
        SCOPED_TRACE(::testing::Message() << names << " from " << 1e3 * beside.transpose() << " mm");
        const bool takes = std::string(names) == "snap";
        AtTheTail scene(with(names), tail + beside);
        scene.tick();
        EXPECT_EQ(scene.hands->view().lit.has_value(), takes);
        EXPECT_GT(scene.hands->view().gap[1], 1e-3);
        scene.click();
        Vec3 last = scene.inputs[1].pose.position;
        double fastest = 0;
        for (int k = 0; k < 1300 && scene.right().grasps.empty(); ++k) {
            scene.tick();
            fastest = std::max(fastest, (scene.inputs[1].pose.position - last).norm() / 1e-3);
            last = scene.inputs[1].pose.position;
        }
        EXPECT_EQ(!scene.right().grasps.empty(), takes);
        EXPECT_LE(fastest, 20.001e-3) << "glides too fast";
    }
}

// Farther than 3 mm nothing is lit, and jaws close where they are.
TEST(Assists, SnapLeavesWhatIsFar) {
    AtTheTail scene(with("snap"), tail + Vec3(3.5e-3, 0, 0));
    scene.tick();
    EXPECT_FALSE(scene.hands->view().lit);
    const Vec3 before = scene.inputs[1].pose.position;
    scene.click();
    scene.ticks(500);
    EXPECT_EQ(scene.inputs[1].pose.position, before);
    EXPECT_EQ(scene.inputs[1].jaw, 0);
}

TEST(Assists, WristRollsOpenJawsSquareToTheStrandNearby) {
    constexpr double askew = 0.9;
    AtTheTail scene(with("wrist"), tail + Vec3(1e-3, 0, 0.5e-3), askew);
    const Quat before = scene.inputs[1].pose.rotation;
    const Vec3 place = scene.inputs[1].pose.position;
    EXPECT_GT(off_square(before, Vec3::UnitY()), 0.7);
    scene.ticks(1000);
    EXPECT_LT(off_square(scene.inputs[1].pose.rotation, Vec3::UnitY()), 0.25) << "the tail itself may have moved";
    EXPECT_EQ(scene.inputs[1].pose.position, place);
    EXPECT_LT((scene.inputs[1].pose.rotation * Vec3::UnitZ() - before * Vec3::UnitZ()).norm(), 1e-6) << "it swings";
    // Away from it the instrument is as it was in the picture again.
    scene.post(Wheel{-30});
    scene.ticks(1500);
    EXPECT_LT(scene.inputs[1].pose.rotation.angularDistance(before), 1e-3);
}

TEST(Assists, WristGoesWithTheCamera) {
    Scene scene("square-knot", with("wrist"));
    scene.ask();
    const Quat in_picture = scene.taken.sight.turned.conjugate() * scene.inputs[1].pose.rotation;
    scene.taken.sight = look_at({0.09, -0.02, 0.1}, {0, 0, 0.01}, Vec3::UnitZ(), 0.5, 700);
    for (int k = 0; k < 2000; ++k) scene.ask();
    EXPECT_LT((scene.taken.sight.turned.conjugate() * scene.inputs[1].pose.rotation).angularDistance(in_picture), 1e-6);
}

// With both hands on one strand they stop as it carries the tension set, in the mean of 100 ms: in single ticks the
// estimate of `ftl` jumps to twice that.
TEST(Assists, PullBothStopsAtTheTensionSet) {
    Settings settings = with("snap,pull-both");
    settings.pull_stop_N = 0.4;
    AtTheTail scene(settings, tail + Vec3(1e-3, 0, 0.5e-3));
    scene.click();
    scene.press(Action::k_jaw);
    scene.ticks(700);
    ASSERT_FALSE(scene.right().grasps.empty());
    ASSERT_FALSE(scene.world().tools()[0].grasps.empty());
    scene.post(Press{Action::pull_both, true});
    scene.post(Wheel{3});
    double most = 0, mean = 0;
    Vec3 last = Vec3::Zero();
    for (int k = 0; k < 2000; ++k) {
        scene.tick();
        mean += (scene.world().tension_now() - mean) / 100;
        most = std::max(most, mean);
        if (k == 1700) last = scene.inputs[0].pose.position;
    }
    EXPECT_GT(mean, 0.6 * settings.pull_stop_N);
    EXPECT_LT(most, 1.15 * settings.pull_stop_N);
    EXPECT_LT((scene.inputs[0].pose.position - last).norm(), 0.3e-3) << "it goes on";
    scene.post(Press{Action::pull_both, false});
    scene.tick();
    EXPECT_FALSE(scene.hands->view().pulls);
}

TEST(Assists, RetakeTakesTheStrandNearerTheKnot) {
    AtTheTail scene(with("snap,retake"), tail + Vec3(1e-3, 0, 0.5e-3));
    scene.click();
    scene.ticks(900);
    ASSERT_EQ(scene.right().grasps.size(), 1u);
    const double before = along_thread(scene.world(), scene.right().grasps[0].middle());
    scene.press(Action::retake);
    scene.ticks(3500);
    ASSERT_EQ(scene.right().grasps.size(), 1u);
    const double after = along_thread(scene.world(), scene.right().grasps[0].middle());
    EXPECT_NEAR(after - before, Retake::by, 1.5e-3);
}

// The wheel drives the needle along its own circle: its centre stays, its tip goes by the angle.
TEST(Assists, TheNeedleWheelTurnsTheNeedleAboutItsCircle) {
    const Settings settings = with("needle-wheel");
    Scene scene("single-bite", settings);
    for (int k = 0; k < 5; ++k) scene.tick();
    const auto before = scene.world().needle();
    scene.post(Press{Action::needle, true});
    scene.post(Press{Action::needle, false});
    scene.post(Wheel{2});
    for (int k = 0; k < 200; ++k) scene.tick();
    const auto after = scene.world().needle();
    EXPECT_TRUE(scene.hands->view().turns_needle);
    EXPECT_LT((after.centre - before.centre).norm(), 1e-8);
    const double angle = 2 * settings.needle;
    EXPECT_LT((after.tail() - before.at(before.radius * angle)).norm(), 2e-6) << "towards its tip";
}

// A hand that trembles by 20 pixels ten times a second, with and without: a low pass of 80 ms leaves a fifth of it.
TEST(Assists, SteadyTakesTremblingOut) {
    const auto tremble = [](const Settings& settings) {
        Scene scene("square-knot", settings);
        double low = 1, high = -1;
        for (int k = 0; k < 1000; ++k) {
            if (k % 50 == 0) scene.post(Motion{k % 100 == 0 ? 20.0 : -20.0, 0});
            scene.ask();
            if (k < 500) continue;
            low = std::min(low, scene.inputs[1].pose.position.x());
            high = std::max(high, scene.inputs[1].pose.position.x());
        }
        return high - low;
    };
    EXPECT_LT(tremble(with("steady")), 0.45 * tremble({}));
    // As it is switched off, nothing jumps.
    Scene scene("square-knot", with("steady"));
    scene.post(Motion{50, 0});
    for (int k = 0; k < 30; ++k) scene.ask();
    const Vec3 before = scene.inputs[1].pose.position;
    scene.post(Switch{Assist::steady, false});
    scene.ask();
    EXPECT_LT((scene.inputs[1].pose.position - before).norm(), 0.2e-3);
}
