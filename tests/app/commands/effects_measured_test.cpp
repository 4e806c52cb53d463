#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "app/commands/effects.hpp"
#include "scenarios/world/world.hpp"
#include "tests/bench/lab/plastic_set.hpp"

// What `carrel explain` predicts, against small drills with the effect on and off: right to within a factor of 3, as
// estimates are.
namespace {

using instruments::ToolInput;
using scenarios::drill::Drill;
using scenarios::world::World;
using sim::geometry::Quat;
using sim::geometry::Vec3;

// A straight thread along x that a tool holds at its first millimetre, and maybe another at its last.
Drill drill(double length_mm, const std::string& effects, const std::string& model = "elastic", bool two = false) {
    const std::string length = std::to_string(length_mm);
    return scenarios::drill::parse_drill(
        R"({"carrel_drill": 1, "title": "Held", "time_limit_s": 60, "thread": {"model": ")" + model +
            R"(", "length_mm": )" + length + R"(, "links": 50, "start_mm": [[0, 0, 0], [)" + length +
            R"(, 0, 0]]}, "instruments": [{"name": "left", "kind": "needle_holder"})" +
            (two ? R"(, {"name": "right", "kind": "needle_holder"})" : "") + R"(], "effects": )" + effects + "}",
        "held.json", "");
}

double predicted(const std::string& effect, const Drill& drill) {
    for (const app::Effect& e : app::effects_of(drill))
        if (e.name == effect) return e.predicted;
    ADD_FAILURE() << effect;
    return 0;
}

struct Scene {
    explicit Scene(const Drill& drill) : world(drill.world, {}, start(drill)), tools(start(drill)) {}

    // Jaws shut across the thread 1 mm from its ends, on it from the first tick.
    static std::vector<ToolInput> start(const Drill& drill) {
        constexpr double in = 1e-3, down_the_jaws = 2e-3, shut = 0.2;
        Eigen::Matrix3d down;
        down << 0, 1, 0, 1, 0, 0, 0, 0, -1;
        std::vector<ToolInput> tools;
        for (const double x : {in, drill.world.thread.length - in})
            if (tools.size() < drill.world.instruments.size())
                tools.push_back({{Vec3(x, 0, -down_the_jaws), Quat(down)}, shut});
        return tools;
    }

    void tick(int times = 1) {
        for (int i = 0; i < times; ++i) world.tick(tools);
    }
    int first_free() const { return world.tools()[0].grasps.at(0).first + world.tools()[0].grasps[0].count() - 1; }
    Vec3 at(int node) const { return world.thread()[static_cast<std::size_t>(node)]; }
    Vec3 tip() const { return world.thread().back(); }

    World world;
    std::vector<ToolInput> tools;
};

// Height that a tail held level loses, over its length.
double sag(double length_mm, bool gravity) {
    Scene scene(drill(length_mm, gravity ? R"({"gravity": true})" : "{}"));
    scene.tick(2000);
    return -scene.tip().z() / (length_mm * 1e-3);
}

void expect_as_predicted(double measured, double predicted) {
    constexpr double factor = 3;
    testing::Test::RecordProperty("measured_where_predicted_" + std::to_string(predicted), std::to_string(measured));
    EXPECT_GT(measured, predicted / factor);
    EXPECT_LT(measured, predicted * factor);
}

}  // namespace

TEST(EffectsMeasured, Gravity) {
    for (const double length_mm : {20, 40, 150})
        expect_as_predicted(sag(length_mm, true) - sag(length_mm, false), predicted("gravity", drill(length_mm, "{}")));
}

// Drawn round the jaws by another tool: how far its middle passes by the corner that a thread without stiffness makes
// there.
static double rounding_mm(const std::string& model) {
    constexpr double length_mm = 22, handling_N = 0.02;
    Scene scene(drill(length_mm, "{}", model, true));
    const Vec3 centre = scene.tools[0].pose.position, out = scene.tools[1].pose.position - centre;
    constexpr int turning = 2000;
    for (int t = 1; t <= turning; ++t) {
        const double angle = 0.5 * std::numbers::pi * t / turning;
        scene.tools[1].pose.position = centre + 0.9 * out.norm() * Vec3(std::cos(angle), std::sin(angle), 0);
        scene.tick();
    }
    for (int t = 0; t < 10000 && scene.world.tension_now() < handling_N; ++t) {
        scene.tools[1].pose.position.y() += 1e-6;
        scene.tick();
    }
    const int middle = static_cast<int>(scene.world.thread().size()) / 2;
    const Vec3 along = (scene.at(middle + 2) - scene.at(middle - 2)).normalized(),
               by = scene.at(scene.first_free()) - scene.at(middle);
    return 1e3 * (by - by.dot(along) * along).norm();
}

TEST(EffectsMeasured, Bending) {
    expect_as_predicted(rounding_mm("elastic") - rounding_mm("ftl"), predicted("bending", drill(22, "{}")));
}

// Two tools draw it until it pulls with 20 mN.
static double strain(const std::string& effects) {
    constexpr double handling_N = 0.02;
    Scene scene(drill(30, effects, "elastic", true));
    scene.tick(10);
    const double before = scene.tools[1].pose.position.x();
    while (scene.world.tension_now() < handling_N) scene.tools[1].pose.position.x() += 1e-7, scene.tick();
    return (scene.tools[1].pose.position.x() - before) /
           (scene.tools[1].pose.position.x() - scene.tools[0].pose.position.x());
}

TEST(EffectsMeasured, Extension) {
    expect_as_predicted(strain("{}") - strain(R"({"extension": false})"), predicted("extension", drill(30, "{}")));
}

// How far the tip of a tail is left behind by a hand that goes up and down at 2 Hz, over how far it goes.
static double lag(const std::string& effects) {
    constexpr double length_mm = 50, way = 1e-3, per_second = 2;
    Scene scene(drill(length_mm, effects));
    const Vec3 start = scene.tools[0].pose.position, tip = scene.tip();
    double most = 0;
    for (int t = 1; t <= 4000; ++t) {
        const double up = way * (1 - std::cos(2 * std::numbers::pi * per_second * t * 1e-3));
        scene.tools[0].pose.position = start + up * Vec3::UnitZ();
        scene.tick();
        if (t > 3000) most = std::max(most, std::abs(scene.tip().z() - tip.z() - up));
    }
    return most / way;
}

TEST(EffectsMeasured, Inertia) {
    expect_as_predicted(lag("{}") - lag(R"({"inertia": false})"), predicted("inertia", drill(50, "{}")));
}

// How far a thread that was led along itself goes on in a second once it is let go of [mm].
static double flies_on(const std::string& effects) {
    constexpr double speed = 20e-3;
    Scene scene(drill(50, effects));
    const auto lead = [&](int ticks) {
        for (int t = 0; t < ticks; ++t) {
            scene.tools[0].pose.position -= 1e-3 * speed * Vec3::UnitX();
            scene.tick();
        }
    };
    lead(1000);
    scene.tools[0].jaw = 1;
    scene.tick(100);  // they open
    const double before = scene.tip().x();
    scene.tick(1000);
    return 1e3 * (before - scene.tip().x());
}

TEST(EffectsMeasured, Air) {
    expect_as_predicted(flies_on("{}") - flies_on(R"({"air": true})"), predicted("air", drill(50, "{}")));
}

// Laid about a strand of its own and let go of.
TEST(EffectsMeasured, PlasticSet) {
    using bench::lab::springback;
    expect_as_predicted(springback(1, bench::lab::polypropylene_yield).found - springback(1, 0).found,
                        predicted("plastic_set", drill(30, "{}")));
}
