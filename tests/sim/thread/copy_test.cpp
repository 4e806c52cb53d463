#include <gtest/gtest.h>

#include <random>
#include <set>

#include "sim/geometry/triangle_tree.hpp"
#include "tests/sim/thread/scene.hpp"

// A copy of a thread goes on as the original does, bit for bit, wherever the two are parted: while a knot jams, while a
// substep is unfinished, while pieces sleep. Each scene is copied with its walls, so that the copy meets them at other
// addresses.
namespace copies {

using namespace scene;
using sim::geometry::Capsule;
using sim::geometry::Triangle;
using sim::geometry::TriangleTree;
using sim::thread::MovingCapsule;

/// Plays `ticks` ticks of a scene, copies it before some of them, and plays each copy to the end.
template <class Scene>
void expect_copies_go_on(const Scene& start, int ticks, unsigned seed) {
    constexpr std::size_t times = 8;
    std::mt19937 random(seed);
    std::set<int> when;
    while (when.size() < times) when.insert(static_cast<int>(random() % static_cast<unsigned>(ticks)));
    Scene scene = start;
    std::vector<std::pair<int, Scene>> copied;
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < ticks; ++i) {
        if (when.count(i)) copied.emplace_back(i, scene);
        scene.step(i);
        hashes.push_back(scene.thread.hash());
    }
    EXPECT_NE(hashes.front(), hashes.back());
    for (auto& [first, copy] : copied)
        for (int i = first; i < ticks; ++i) {
            copy.step(i);
            ASSERT_EQ(copy.thread.hash(), hashes[static_cast<std::size_t>(i)])
                << "copied before tick " << first << ", tick " << i;
        }
}

ThreadDef elastic() {
    ThreadDef def;
    def.elastic = {.axial_over_bending = 0, .gravity = Vec3(0, 0, -9.81)};
    return def;
}

/// An overhand drawn tight until it jams, let go, and drawn again.
struct Overhand {
    explicit Overhand(const ThreadDef& def) : thread(def, overhand(120)), pull(thread) {}

    void step(int i) { pull.by(thread, (i % 300 < 220 ? 0.1e-3 : -0.05e-3)); }

    Thread thread;
    Pull pull;
};

TEST(Copy, OfAKnotThatJamsGoesOnAlike) {
    expect_copies_go_on(Overhand({}), 700, 1);
}
TEST(Copy, OfAKnotWhoseLinksChangeGoesOnAlike) {
    struct Changing : Overhand {
        Changing() : Overhand({.shortest_link = radius}) {}
        void step(int i) {
            std::array<int, 2> held{pull.first, pull.last};
            if (thread.fit_links(held)) pull.first = held[0], pull.last = held[1];
            Overhand::step(i);
        }
    };
    expect_copies_go_on(Changing(), 500, 2);
}
TEST(Copy, OfAnElasticKnotGoesOnAlike) {
    expect_copies_go_on(Overhand(elastic()), 700, 3);
}

/// A thread held at both ends and drawn over a bar of steel that moves along it: part of it is wrapped.
struct Wrapped {
    explicit Wrapped(const ThreadDef& def)
        : thread(def, straight(160)), left(thread.nodes().front()), right(thread.nodes().back()) {}

    void step(int i) {
        const Vec3 down(0, 0, -40e-6), aside((i / 50) % 2 ? 20e-6 : -20e-6, 0, 0);
        if (i < 150) left += down + Vec3(30e-6, 0, 0), right += down - Vec3(30e-6, 0, 0);
        left += aside, right += aside;
        const Hold holds[] = {{0, left}, {160, right}};
        constexpr int owners[] = {-1, 0};
        const MovingCapsule capsules[] = {{bar, bar, 1}};
        thread.tick({holds, owners, capsules});
    }

    Thread thread;
    Vec3 left, right;
    Capsule bar{{80 * 2 * radius, -5e-3, -1e-3}, {80 * 2 * radius, 5e-3, -1e-3}, 0.8e-3};
};

TEST(Copy, OfAThreadWrappedOnSteelGoesOnAlike) {
    expect_copies_go_on(Wrapped({}), 400, 4);
    expect_copies_go_on(Wrapped(elastic()), 400, 5);
}

std::vector<Triangle> floor_at(double z) {
    constexpr double half = 20e-3;
    const Vec3 a(-half, -half, z), b(half, -half, z), c(half, half, z), d(-half, half, z);
    return {{a, b, c}, {a, c, d}};
}

/// Two pieces, of which one lies on a floor, asleep when elastic; the other is drawn over it and across the first.
struct Pieces {
    static constexpr int links = 30;

    explicit Pieces(const ThreadDef& def) : thread(def, both(), std::vector<int>{links}) {}

    static std::vector<Vec3> both() {
        std::vector<Vec3> nodes = straight(links);
        for (Vec3& p : nodes) p += Vec3(0, 0, 1.01 * radius);
        for (int i = 0; i <= links; ++i) nodes.emplace_back(links * radius, radius * (2 * i + 40), 3 * radius);
        return nodes;
    }
    void step(int i) {
        if (i > 250) hand += Vec3(0, -10e-6, i < 300 ? -1e-6 : 0);
        if (i == 200) floor.move(floor_at(height = -1e-6));
        const Hold hold{.node = links + 1, .target = hand, .wanted = hand};
        const int owner = 0;
        thread.tick({.holds = {&hold, 1},
                     .hold_owners = {&owner, 1},
                     .capsules = {},
                     .surface = &floor,
                     .surface_moved = i == 200 ? 1e-6 : 0});
    }

    Thread thread;
    TriangleTree floor{floor_at(0)};
    double height = 0;
    Vec3 hand = thread.nodes()[links + 1];
};

TEST(Copy, OfPiecesOnAFloorGoesOnAlike) {
    expect_copies_go_on(Pieces({}), 500, 6);
    expect_copies_go_on(Pieces(elastic()), 500, 7);
}

}  // namespace copies
