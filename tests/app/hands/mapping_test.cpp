#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "tests/app/hands/scene.hpp"

using namespace app::hands;

namespace {

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    Vec3 point(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
    Quat rotation() { return Quat(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)).normalized(); }
    // A camera 50 to 200 mm from a point near the origin, which it sees somewhere in its picture.
    Sight sight() {
        const Vec3 back = point(1).normalized(), target = point(0.02);
        return look_at(target + between(0.05, 0.2) * back, target, point(1), between(0.3, 1), between(300, 2000));
    }
    Settings settings() {
        constexpr std::array scales{0.25, 1.0 / 3, 0.5, 1.0, 2.0};
        Settings settings;
        settings.scale = scales[static_cast<std::size_t>(between(0, 4.999))];
        return settings;
    }

  private:
    std::mt19937 engine_;
};

bool same_bits(const ToolInput& a, const ToolInput& b) {
    const auto words = [](const ToolInput& input) {
        const auto& [p, q] = input.pose;
        return std::array{std::bit_cast<std::uint64_t>(p.x()), std::bit_cast<std::uint64_t>(p.y()),
                          std::bit_cast<std::uint64_t>(p.z()), std::bit_cast<std::uint64_t>(q.w()),
                          std::bit_cast<std::uint64_t>(q.x()), std::bit_cast<std::uint64_t>(q.y()),
                          std::bit_cast<std::uint64_t>(q.z()), std::bit_cast<std::uint64_t>(input.jaw)};
    };
    return words(a) == words(b);
}

// Instruments anywhere, as seen by any camera; the world stands still meanwhile.
struct Bench {
    explicit Bench(unsigned seed, const Settings& settings) : random(seed) {
        static const Scene still("square-knot");
        world = &still.world();
        for (int i = 0; i < 2; ++i) inputs.push_back({{random.point(0.02), random.rotation()}, random.between(0.5, 1)});
        inputs[1].pose.position.x() = -0.0;  // whose bits a sum with zero would change
        hands = std::make_unique<Hands>(settings, still.drill.world.instruments, inputs);
        taken.sight = random.sight();
    }
    void ask(int ticks) {
        for (int k = 0; k < ticks; ++k) {
            hands->tick(*world, taken, inputs);
            taken.events.clear();
        }
    }
    void post(std::variant<Motion, Wheel, Click, Press, Switch, LetGo> what) { taken.events.push_back({what, 0}); }
    void press(Action action, bool down = true) { post(Press{action, down}); }
    ToolInput& mouse() { return inputs[1]; }
    ToolInput& keys() { return inputs[0]; }

    Random random;
    const World* world;
    std::vector<ToolInput> inputs;
    std::unique_ptr<Hands> hands;
    Taken taken;
};

}  // namespace

TEST(Mapping, EngagingMovesNothing) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Bench bench(seed, Random(seed + 1000).settings());
        const std::vector<ToolInput> before = bench.inputs;
        const auto expect_still = [&](const char* when) {
            bench.ask(30);
            for (std::size_t i = 0; i < before.size(); ++i)
                EXPECT_TRUE(same_bits(bench.inputs[i], before[i])) << when << ", instrument " << i;
        };
        expect_still("as the session begins");
        bench.press(Action::free_pointer);
        for (int k = 0; k < 20; ++k) {
            bench.post(Motion{bench.random.between(-300, 300), bench.random.between(-300, 300)});
            bench.post(Wheel{bench.random.between(-9, 9), k % 2 == 0});
            bench.post(Click{k % 3 == 0 ? Button::left : Button::right, k % 2 == 0});
        }
        expect_still("while the pointer is free");
        bench.taken.sight = bench.random.sight();
        bench.press(Action::free_pointer);
        expect_still("as it engages");
        bench.press(Action::swap);
        expect_still("as hands are swapped");
        bench.press(Action::scale_up);
        expect_still("as the scale changes");
    }
}

// What was under way when the pointer was freed must not come as a jump when it engages.
TEST(Mapping, WhatTheMouseStillHadIsForgottenWhenItIsFreed) {
    Bench bench(7, {});
    bench.post(Motion{400, 0});
    bench.ask(3);
    bench.press(Action::free_pointer);
    bench.ask(1);
    const ToolInput freed = bench.mouse();
    bench.press(Action::free_pointer);
    bench.ask(50);
    EXPECT_TRUE(same_bits(bench.mouse(), freed));
}

TEST(Mapping, TheToolGoesWithThePointerOneToOne) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Settings settings = Random(seed + 1000).settings();
        Bench bench(seed, settings);
        const Sight sight = bench.taken.sight;
        const ToolInput start = bench.mouse();
        const Vec3 before = sight.project(start.pose.position);
        const double right = bench.random.between(-90, 90), down = bench.random.between(-90, 90);
        bench.post(Motion{right, down});
        bench.ask(400);
        const Vec3 way = sight.project(bench.mouse().pose.position) - before;
        EXPECT_NEAR(way.x(), settings.scale * right, 1e-4);
        EXPECT_NEAR(way.y(), settings.scale * -down, 1e-4);
        EXPECT_NEAR(way.z(), 0, 1e-9);
        EXPECT_EQ(bench.mouse().pose.rotation.coeffs(), start.pose.rotation.coeffs());
        // The wheel takes it away behind the same pixel.
        const Vec3 there = sight.project(bench.mouse().pose.position);
        const double to_eye = (sight.eye - bench.mouse().pose.position).norm();
        bench.post(Wheel{4});
        bench.ask(400);
        EXPECT_NEAR((sight.eye - bench.mouse().pose.position).norm() - to_eye, settings.scale * 2e-3, 1e-8);
        EXPECT_LT((sight.project(bench.mouse().pose.position) - there).head<2>().norm(), 1e-4);
    }
}

TEST(Mapping, KeysGoAsTheyAreSeenAtTheirRate) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const Settings settings = Random(seed + 1000).settings();
        for (const auto& [action, across, towards] :
             {std::tuple(Action::k_left, Vec3(-1, 0, 0), 0), std::tuple(Action::k_right, Vec3(1, 0, 0), 0),
              std::tuple(Action::k_up, Vec3(0, 1, 0), 0), std::tuple(Action::k_down, Vec3(0, -1, 0), 0),
              std::tuple(Action::k_away, Vec3(0, 0, 0), -1), std::tuple(Action::k_towards, Vec3(0, 0, 0), 1)}) {
            Bench bench(seed, settings);
            const Sight sight = bench.taken.sight;
            const Vec3 from = bench.keys().pose.position;
            bench.press(action);
            bench.ask(100);
            bench.press(action, false);
            bench.ask(50);
            // From 20 mm/s up by 80 mm/s^2 for 0.1 s, each tick by the rate as it begins.
            const double length = settings.scale * 1e-3 * (0.1 * 20 + 0.5 * 80 * 0.1 * 0.099);
            const Vec3 expected = sight.turned * across + towards * (sight.eye - from).normalized();
            EXPECT_LT((bench.keys().pose.position - from - length * expected).norm(), 1e-9) << row_of(action).name;
        }
    }
}

// The right button turns the tool about its jaw as a ball under the hand turns: what is nearest to the eye goes with
// the mouse. Seen from any side, at any scale.
TEST(Mapping, TurnsGoAsTheyAreSeenAndAreNotScaled) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const Settings settings = Random(seed + 1000).settings();
        for (const Vec3& turn : {Vec3(0, 1, 0), Vec3(1, 0, 0)}) {
            Bench bench(seed, settings);
            const Sight sight = bench.taken.sight;
            const ToolInput start = bench.mouse();
            bench.post(Click{Button::right, true});
            bench.post(Motion{40 * turn.y(), 40 * turn.x()});
            bench.ask(400);
            const Quat expected =
                Quat(Eigen::AngleAxisd(40 * settings.turn, sight.turned * turn)) * start.pose.rotation;
            EXPECT_LT(bench.mouse().pose.rotation.angularDistance(expected), 1e-6);
            EXPECT_EQ(bench.mouse().pose.position, start.pose.position);
            // The front of the ball, a millimetre towards the eye, goes right or down in the picture.
            const Vec3 front = 1e-3 * (sight.turned * Vec3::UnitZ());
            const Vec3 goes = sight.turned.conjugate() *
                              (bench.mouse().pose.rotation * (start.pose.rotation.conjugate() * front) - front);
            EXPECT_GT(goes.dot(Vec3(turn.y(), -turn.x(), 0)), 0);
        }
        Bench bench(seed, settings);
        const ToolInput start = bench.mouse();
        bench.post(Click{Button::right, true});
        bench.post(Wheel{3});
        bench.ask(400);
        const Quat rolled = start.pose.rotation * Quat(Eigen::AngleAxisd(3 * settings.roll, Vec3::UnitZ()));
        EXPECT_LT(bench.mouse().pose.rotation.angularDistance(rolled), 1e-6);
    }
}

// A step of the mouse, 8 ms of a hand's motion in one, must not become a jerk: no tick moves the tool by more than a
// twentieth of it.
TEST(Mapping, AStepOfTheMouseIsSmoothed) {
    Bench bench(3, {});
    const Sight sight = bench.taken.sight;
    const double start = sight.project(bench.mouse().pose.position).x();
    bench.post(Motion{100, 0});
    double last = start, most = 0, after_30_ms = 0;
    for (int tick = 0; tick < 60; ++tick) {
        bench.ask(1);
        const double now = sight.project(bench.mouse().pose.position).x();
        most = std::max(most, now - last);
        EXPECT_GE(now, last - 1e-9) << "no swinging back";
        last = now;
        if (tick == 29) after_30_ms = now;
    }
    EXPECT_LT(most, 5);
    EXPECT_GT(after_30_ms - start, 85);
    EXPECT_NEAR(last - start, 100, 1);
}

TEST(Mapping, JawsCloseAndStayOrAreHeld) {
    Bench bench(5, {});
    bench.post(Click{Button::left, true});
    bench.post(Click{Button::left, false});
    bench.ask(400);
    EXPECT_LT(bench.mouse().jaw, 0.25);
    bench.post(Click{Button::left, true});
    bench.ask(400);
    const double open = bench.mouse().jaw;
    EXPECT_GT(open, 0.4);
    bench.post(Wheel{-1, true});
    bench.ask(400);
    EXPECT_NEAR(bench.mouse().jaw, open - 0.1, 1e-9);

    Settings held;
    held.holds_jaw = true;
    Bench other(5, held);
    other.post(Click{Button::left, true});
    other.ask(400);
    EXPECT_LT(other.mouse().jaw, 0.25);
    other.post(Click{Button::left, false});
    other.ask(400);
    EXPECT_GT(other.mouse().jaw, 0.4);
}

TEST(Mapping, SettingsChooseHandsAndToggles) {
    Settings settings;
    settings.left_handed = true;
    settings.toggles = true;
    Bench bench(6, settings);
    bench.ask(1);
    EXPECT_EQ(bench.hands->view().mouse, 0);
    EXPECT_EQ(bench.hands->view().keys, 1);
    bench.press(Action::fine);
    bench.press(Action::fine, false);
    bench.ask(1);
    EXPECT_TRUE(bench.hands->view().is_fine);
    bench.press(Action::fine);
    bench.press(Action::instrument_2);
    bench.ask(1);
    EXPECT_FALSE(bench.hands->view().is_fine);
    EXPECT_EQ(bench.hands->view().mouse, 1);
    EXPECT_EQ(bench.hands->view().keys, 0);
}

// A window that loses the keyboard gets no more keys: without LetGo the hand would go on alone.
TEST(Mapping, LettingGoEndsWhatIsHeld) {
    Bench bench(8, {});
    bench.press(Action::k_left);
    bench.post(Motion{50, 50});
    bench.ask(5);
    bench.post(LetGo{});
    bench.ask(1);
    const auto still = bench.inputs;
    bench.ask(50);
    EXPECT_TRUE(same_bits(bench.keys(), still[0]));
    EXPECT_TRUE(same_bits(bench.mouse(), still[1]));
}

TEST(Mapping, AnExamHasNoAssists) {
    Settings settings;
    settings.assists = parse_assists("wrist,snap");
    settings.is_exam = true;
    Bench bench(9, settings);
    bench.post(Switch{Assist::steady, true});
    bench.ask(1);
    EXPECT_EQ(bench.hands->view().assists.names(), "");
}
