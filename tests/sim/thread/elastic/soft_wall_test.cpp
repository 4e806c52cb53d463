// Thread and walls that give way are moved in turn: what presses between them must come to rest all the same.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"

namespace soft_wall {

using sim::geometry::Triangle;
using sim::geometry::TriangleTree;
using sim::thread::Hold;
using sim::thread::RodDef;
using sim::thread::Thread;
using sim::thread::Vec3;

constexpr double radius = 0.0425e-3, far = 0.1;  // [m]
constexpr double wall_compliance = 1e-3;         // [m/N]: what the strand takes a wall for at each place

std::vector<Vec3> strand(int links, double link) {
    std::vector<Vec3> points;
    for (int i = 0; i <= links; ++i) points.emplace_back(link * i, 0, 0);
    return points;
}

// Every other link halved, as where a thread bends.
std::vector<Vec3> unequal_strand() {
    std::vector<Vec3> points{{0, 0, 0}};
    for (const double link : {0.5e-3, 0.25e-3, 0.25e-3, 0.5e-3, 0.25e-3, 0.25e-3, 0.5e-3})
        points.emplace_back(points.back().x() + link, 0, 0);
    return points;
}

// A strand squeezed by two walls on springs, as one is between the lips of a bite. A wall is what `shape` makes of how
// far it is up, all triangles of it.
struct Vice {
    using Wall = std::vector<Triangle>;
    struct Def {
        std::vector<Vec3> line;
        Wall (*shape)(double z, double size);
        double size;             ///< Of what shape is made of [m].
        double spring, squeeze;  ///< Of a wall [N/m], [N].
        bool is_free;            ///< The strand's last end.
    };

    explicit Vice(const Def& given) : def(given), walls(both()) {}

    Wall both() const {
        Wall all = def.shape(out[0], def.size), lower = def.shape(-out[1], def.size);
        all.insert(all.end(), lower.begin(), lower.end());
        return all;
    }

    // What the strand presses each wall with, up above and down below [N].
    std::array<double, 2> tick() {
        const std::array holds{Hold{0, def.line.front()}, Hold{static_cast<int>(def.line.size()) - 1, def.line.back()}};
        const std::array owners{-1, -1};
        const std::size_t held = def.is_free ? 1 : 2, half = static_cast<std::size_t>(walls.size()) / 2;
        thread.tick({.holds = std::span(holds).first(held),
                     .hold_owners = std::span(owners).first(held),
                     .capsules = {},
                     .surface = &walls,
                     .surface_moved = moved,
                     .sheathed = {},
                     .soft_from = 0,
                     .soft_compliance = wall_compliance});
        std::array<double, 2> pushed{}, deeper{}, places{};
        for (const auto& force : thread.surface_forces()) {
            const std::size_t k = static_cast<std::size_t>(force.triangle) / half;
            const double push = std::abs(force.force.z());
            pushed[k] += push, deeper[k] += push * (k == 0 ? 1 : -1) * force.deeper.z(), ++places[k];
        }
        moved = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            if (pushed[k] > 0) deeper[k] /= pushed[k];
            // Implicitly, against its spring and what it takes the strand for, from where that is; nearer by no more
            // than it may.
            const double reckoned = std::max(5000.0, places[k] / wall_compliance);  // [N/m]
            const double way = (pushed[k] + reckoned * deeper[k] - def.squeeze - def.spring * (out[k] - radius)) /
                               (def.spring + reckoned);
            const double goes = std::max(way, -0.45 * std::max(0.0, out[k] - 0.6 * radius));
            out[k] += goes, moved = std::max(moved, std::abs(goes));
        }
        walls.move(both());
        return pushed;
    }

    Def def;
    std::array<double, 2> out{1.2 * radius, 1.2 * radius};  ///< Of each wall from the middle [m].
    double moved = 0;
    TriangleTree walls;
    Thread thread{{.radius = radius, .friction = 0.2, .elastic = RodDef{.keeps_shape = true}}, def.line};
};

// Across the strand's middle.
Vice::Wall edge(double z, double) {
    return {{{0.75e-3, -far, z}, {0.75e-3, far, z}, {0.75e-3, 0, z + std::copysign(far, z)}}};
}

// Along it, of strips.
Vice::Wall plate(double z, double strip) {
    constexpr double from = -1e-3, to = 3.5e-3, side = 1e-3;
    const int strips = std::max(1, static_cast<int>((to - from) / strip));
    Vice::Wall wall;
    for (int i = 0; i < strips; ++i) {
        const double a = from + i * (to - from) / strips, b = from + (i + 1) * (to - from) / strips;
        wall.push_back({{a, -side, z}, {b, -side, z}, {b, side, z}});
        wall.push_back({{a, -side, z}, {b, side, z}, {a, side, z}});
    }
    return wall;
}

// By the springs' law, whatever they are. Were the edges taken for rigid by the strand, which is 2 N a um stiff to
// them, it would be thrown to and fro between them, and pressed with up to 65 times as much.
TEST(SoftWalls, PressAStrandBetweenThemWithWhatTheyAreDrawnBy) {
    for (const double spring : {100, 1000})
        for (const double squeeze : {0.01, 0.05, 0.2}) {
            Vice vice({strand(3, 0.5e-3), edge, 0, spring, squeeze, false});
            for (int t = 0; t < 200; ++t) vice.tick();
            for (int t = 0; t < 100; ++t)
                for (const double pushed : vice.tick())
                    EXPECT_NEAR(pushed, squeeze, 1e-3 * squeeze) << spring << " N/m";
            for (const double out : vice.out)
                EXPECT_NEAR(out, radius, 1e-3 * radius) << spring << " N/m";  // the contact's own 0.1 um at 0.2 N
        }
}

// However fine walls and strand are, with an end free or both held. Shown the nearest place of each link alone, which
// goes from end to end of it, it tumbled by up to 0.3 mm a tick; and 23 places that each take the wall for 1000 N/m,
// where that takes them for 5000 in all, throw it to and fro.
TEST(SoftWalls, LeaveAStrandStillThatLiesFlatBetweenThem) {
    constexpr double still = 0.02 * 2 * radius;  // a tick; a free end slides along what holds it by friction alone
    for (const auto& line : {strand(22, 0.1e-3), strand(9, 0.25e-3), strand(5, 0.5e-3), unequal_strand()})
        for (const double strip : {far, 0.3e-3})
            for (const double squeeze : {0.01, 0.2})
                for (const bool is_free : {true, false}) {
                    SCOPED_TRACE(std::to_string(line.size() - 1) + " links, strips of " + std::to_string(strip) +
                                 " m, " + std::to_string(squeeze) + " N" + (is_free ? ", free" : ""));
                    Vice vice({line, plate, strip, 500, squeeze, is_free});
                    for (int t = 0; t < 300; ++t) vice.tick();
                    for (int t = 0; t < 50; ++t) {
                        const std::vector<Vec3> before(vice.thread.nodes().begin(), vice.thread.nodes().end());
                        for (const double pushed : vice.tick()) ASSERT_NEAR(pushed, squeeze, 1e-3 * squeeze);
                        for (std::size_t i = 0; i < before.size(); ++i)
                            ASSERT_LT((vice.thread.nodes()[i] - before[i]).norm(), still);
                    }
                }
}

}  // namespace soft_wall
