// E18: many strands through the walls of one vessel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/scenarios/world/scene.hpp"

namespace passing {

using namespace scene;

constexpr double tick = 1e-3;

// A vessel that ends at x = 0, held at its other end, and a thread whose two ends needle holders hold where it is laid.
struct Ending : Scene {
    explicit Ending(const char* model) {
        def.vessels.push_back(end_at(0, 6 * mm));
        def.vessels[0].young_modulus = 1e6;
        def.thread.model = model;
        def.thread.shortest_link = def.thread.diameter;
    }
    void lay_by(const std::vector<Vec3>& path, double link) {
        lay(path, 1);
        def.thread.links = static_cast<int>(std::lround(def.thread.length / link));
    }
    // Jaws across a strand along `way`, pointing along `points`.
    void hold(const char* name, const Vec3& at, const Vec3& way, const Vec3& points) {
        add(name, Kind::needle_holder, {across(at, way, points), 0.6});
    }
};

double length(const World& world) {
    double sum = 0;
    for (std::size_t k = 1; k < world.thread().size(); ++k) sum += (world.thread()[k] - world.thread()[k - 1]).norm();
    return sum;
}

// Places along the thread [m] where it comes within a radius of a hole's middle; what is nearer to each other than a
// millimetre is one strand.
std::vector<double> strands_in(const World& world, int hole) {
    const auto& skin = world.vessels()[0].skin;
    std::vector<double> found;
    double along = 0, last = -1;
    for (std::size_t k = 1; k < world.thread().size(); ++k) {
        const Vec3 &a = world.thread()[k - 1], &b = world.thread()[k];
        constexpr int looks = 8;
        for (int i = 0; i < looks; ++i) {
            const double share = (i + 0.5) / looks, place = along + share * (b - a).norm();
            if ((a + share * (b - a) - skin.centre(hole)).norm() > skin.radius(hole)) continue;
            if (last < 0 || place - last > 1 * mm) found.push_back(place);
            last = place;
        }
        along += (b - a).norm();
    }
    return found;
}

class Passes : public testing::TestWithParam<const char*> {};

// Down through one hole and up again beside itself. Each strand is drawn, one this way and one that, so that the loop
// below gets shorter.
TEST_P(Passes, TwoStrandsGoThroughOneHole) {
    Ending scene(GetParam());
    const double x = -1.5 * mm, apart = 0.05 * mm, high = 2.9 * mm, deep = -1.2 * mm;
    scene.def.vessels[0].bitten = {{Vec3(x, 0, 2.5 * mm), Vec3(x, 0, 1 * mm)}};
    scene.lay_by({{-14 * mm, -apart, high},
                  {x, -apart, high},
                  {x, -apart, deep},
                  {x, apart, deep},
                  {x, apart, high},
                  {12 * mm, apart, high}},
                 0.1 * mm);
    scene.hold("left", {-8 * mm, -apart, high}, Vec3::UnitX(), Vec3::UnitY());
    scene.hold("right", {6 * mm, apart, high}, Vec3::UnitX(), -Vec3::UnitY());
    World world = scene.world();
    const double at_first = length(world);
    const auto below = [&] {
        const auto out = strands_in(world, 1);
        return out.empty() ? 0 : out.back() - out.front();
    };  // of the thread [m]
    const double loop = below();
    double stopped = 0;
    for (int t = 0; t < 700; ++t) {
        if (t == 500) stopped = below();
        if (t == 1)
            for (ToolInput& tool : scene.tools) tool.jaw = 0;
        if (t >= 50 && t < 250) scene.tools[0].pose.position.x() -= 5 * mm * tick;
        if (t >= 250 && t < 450) scene.tools[1].pose.position.x() += 5 * mm * tick;
        world.tick(scene.tools);
    }
    for (const auto& tool : world.tools()) ASSERT_EQ(tool.grasps.size(), 1u);
    EXPECT_EQ(world.measures().pass_throughs, 0u);
    EXPECT_NEAR(length(world), at_first, 1e-3 * at_first);
    double lowest = high;
    for (const Vec3& node : world.thread()) lowest = std::min(lowest, node.z());
    if (std::string(GetParam()) ==
        "elastic") {  // by Follow-The-Leader both jam in so narrow a hole, and the tools wait
        EXPECT_GT(lowest, deep + 0.7 * mm)
            << "half of what both were drawn, but for how far they lift before they are taut";
        EXPECT_LT(below(), loop - 1.8 * mm)
            << "all that was drawn comes out of the loop, and as much more as strands so slack (2 mN) bow";
        EXPECT_NEAR(below(), stopped, 0.05 * mm) << "hands at rest draw nothing";
    }
    const auto into = strands_in(world, 0), out = strands_in(world, 1);
    ASSERT_EQ(into.size(), 2u);
    ASSERT_EQ(out.size(), 2u);
    EXPECT_TRUE(into[0] < out[0] && out[0] < out[1] && out[1] < into[1]);
}

// A running suture without a second vessel: in from outside, out over the cut, twenty times round.
TEST_P(Passes, TwentyGoThroughOneRing) {
    Ending scene(GetParam());
    constexpr int passes = 20;
    std::vector<Vec3> path;
    const auto at = [](double angle, double x, double r) {
        const auto turn = sim::geometry::portable_sin_cos(angle);
        return Vec3(x, r * turn.sin, r * turn.cos);
    };
    constexpr double step = 2 * 3.14159265358979 / passes;
    path.push_back(at(0.5 * step, -1.2 * mm, 14 * mm));
    for (int i = 0; i < passes; ++i) {
        const double angle = (i + 0.5) * step;
        scene.def.vessels[0].bitten.push_back({at(angle, -1.2 * mm, 2.4 * mm), at(angle, -1.2 * mm, 1.1 * mm)});
        for (const auto& [x, r] : {std::pair(-1.2, 2.4), {-1.2, 1.1}, {0.5, 1.1}})
            path.push_back(at(angle, x * mm, r * mm));
        if (i + 1 < passes) path.push_back(at(angle + 0.5 * step, 0.5 * mm, 2.4 * mm));
    }
    path.push_back(at((passes - 0.5) * step, 14 * mm, 1.1 * mm));
    scene.lay_by(path, 0.15 * mm);
    scene.hold("right", at((passes - 0.5) * step, 8 * mm, 1.1 * mm), Vec3::UnitX(), -Vec3::UnitY());
    scene.hold("left", at(0.5 * step, -1.2 * mm, 8 * mm), at(0.5 * step, 0, 1), Vec3::UnitX());
    World world = scene.world();
    ASSERT_EQ(world.vessels()[0].bites.bites().size(), static_cast<std::size_t>(passes));
    const double at_first = length(world);
    const int last_hole = world.vessels()[0].bites.bites().back().exit.hole;
    const double left_at_first = at_first - strands_in(world, last_hole).at(0);
    for (int t = 0; t < 500; ++t) {
        if (t == 1) scene.tools[0].jaw = 0;
        if (t >= 50 && t < 350) scene.tools[0].pose.position.x() += 10 * mm * tick;
        world.tick(scene.tools);
    }
    ASSERT_EQ(world.tools()[0].grasps.size(), 1u);
    EXPECT_EQ(world.measures().pass_throughs, 0u);
    EXPECT_NEAR(length(world), at_first, 1e-3 * at_first);
    double before = 0;
    for (const tissue::Bite& bite : world.vessels()[0].bites.bites())
        for (const int hole : {bite.entry.hole, bite.exit.hole}) {
            const auto strands = strands_in(world, hole);
            ASSERT_EQ(strands.size(), 1u) << hole;
            EXPECT_LT(before, strands[0]) << hole;
            before = strands[0];
        }
    EXPECT_GT(length(world) - before - left_at_first, 2 * mm)
        << "of 3 mm that the hand went; the first turns are drawn tight first";
}

INSTANTIATE_TEST_SUITE_P(Models, Passes, testing::Values("ftl", "elastic"),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace passing
