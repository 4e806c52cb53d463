#include <gtest/gtest.h>

#include <random>

#include "scenarios/world/world.hpp"

namespace {

using instruments::ToolInput;
using scenarios::world::World;
using sim::geometry::Quat;
using sim::geometry::Vec3;

struct Seeded {
    std::mt19937 random;
    double number(double from, double to) { return from + (to - from) * random() / 4294967296.0; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v(number(-1, 1), number(-1, 1), number(-1, 1));
            if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
        }
    }
};

// Open jaws anywhere in space, and a straight thread of 30 mm that runs between them, across them within 60 degrees.
struct Scene {
    scenarios::world::WorldDef def;
    ToolInput tool;

    explicit Scene(Seeded& seeded) {
        def.instruments = {{"right", instruments::Kind::needle_holder}};
        const auto shape = instruments::shape_of(instruments::Kind::needle_holder);
        const auto jaw = instruments::parts_at(shape, {}, 0)[instruments::jaw_plus];
        const double share = seeded.number(0.3, 0.9);
        const Vec3 between(0, 0, (1 - share) * jaw.a.z() + share * jaw.b.z());
        const Vec3 across = Vec3(seeded.number(-0.5, 0.5), 1, seeded.number(-1, 1)).normalized();
        const Vec3 turn = seeded.direction() * seeded.number(0, 1);
        tool.pose.position = 0.02 * seeded.direction();
        tool.pose.rotation = Quat(1, turn.x(), turn.y(), turn.z()).normalized();
        tool.jaw = 1;
        const auto in_world = [&](const Vec3& p) -> Vec3 { return tool.pose.position + tool.pose.rotation * p; };
        def.thread.length = 30e-3;
        def.thread.links = 60;
        def.thread.start = {in_world(between - 15e-3 * across), in_world(between + 15e-3 * across)};
    }
};

TEST(Grasp, ClosingJawsHoldTheStrandBetweenThem) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        Seeded seeded{std::mt19937(seed)};
        Scene scene(seeded);
        World world(scene.def, {}, {&scene.tool, 1});
        for (int tick = 0; tick < 300; ++tick) {
            scene.tool.jaw = std::max(0.0, 1 - 0.005 * tick);
            world.tick({&scene.tool, 1});
        }
        EXPECT_EQ(world.tools()[0].grasps.size(), 1u) << "seed " << seed;
        EXPECT_EQ(world.measures().pass_throughs, 0u) << "seed " << seed;
    }
}

}  // namespace
