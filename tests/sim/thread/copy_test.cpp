#include <gtest/gtest.h>

#include <random>
#include <set>

#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/hash.hpp"
#include "tests/sim/thread/scene.hpp"

// A copy of a thread goes on as the original does, bit for bit, wherever the two are parted: while a knot jams, while a
// substep is unfinished, while pieces sleep. Each scene is copied with its walls, so that the copy meets them at other
// addresses.
namespace copies {

using namespace scene;
using sim::geometry::Capsule;
using sim::geometry::Triangle;
using sim::geometry::TriangleTree;
using sim::thread::hash_of_all_carried;
using sim::thread::MovingCapsule;
using sim::thread::state_of;

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
        if (when.count(i)) {
            copied.emplace_back(i, scene);
            EXPECT_EQ(copied.back().second.thread.hash_of_all_carried(), scene.thread.hash_of_all_carried());
        }
        scene.step(i);
        hashes.push_back(scene.thread.hash_of_all_carried());
    }
    EXPECT_NE(hashes.front(), hashes.back());
    for (auto& [first, copy] : copied)
        for (int i = first; i < ticks; ++i) {
            copy.step(i);
            ASSERT_EQ(copy.thread.hash_of_all_carried(), hashes[static_cast<std::size_t>(i)])
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

// What a tick that stopped within a substep carries over is copied as well: rows, bounds, how far it has come.
TEST(Copy, OfAnUnfinishedSubstepGoesOnAlike) {
    auto mover = sim::thread::make_mover({}, overhand(120), {});
    const auto& state = std::get<sim::thread::ftl::Mover>(mover).state();
    const Vec3 away = (state.nodes.back() - state.nodes.front()).normalized();
    const auto pull = [&](sim::thread::Mover& one) {
        const auto& nodes = state_of(one).nodes;
        const Hold holds[] = {{0, nodes.front() - 0.1e-3 * away}, {120, nodes.back() + 0.1e-3 * away}};
        constexpr int owners[] = {-1, -1};
        sim::thread::tick(one, {holds, owners, {}});
    };
    int unfinished = 0;
    for (int i = 0; i < 400; ++i) {
        pull(mover);
        if (state.unfinished.step_control < 0 || ++unfinished % 10 != 1) continue;
        auto copy = mover, original = mover;
        for (int k = 0; k < 15; ++k) {
            pull(copy), pull(original);
            ASSERT_EQ(hash_of_all_carried(copy), hash_of_all_carried(original)) << "tick " << i << " and " << k;
        }
    }
    EXPECT_GT(unfinished, 20);
}

/// Changes one member alone, which is there to be changed, and expects another hash.
template <class Mover, class Change>
void expect_another_hash(const Mover& mover, const char* what, const Change& change) {
    sim::thread::Mover changed = mover;
    const auto before = hash_of_all_carried(changed);
    change(std::get<Mover>(changed).state());
    EXPECT_NE(hash_of_all_carried(changed), before) << what;
}

template <class Mover>
void expect_shared_members_count(const Mover& mover) {
    const auto expect = [&](const char* what, const auto& change) { expect_another_hash(mover, what, change); };
    expect("nodes", [](auto& s) { s.nodes[3].x() += 1e-9; });
    expect("rest_length", [](auto& s) { s.rest_length[3] *= 1.01; });
    expect("arc", [](auto& s) { s.arc[3] *= 1.01; });
    expect("longest_link", [](auto& s) { s.longest_link *= 2; });
    expect("tension", [](auto& s) { s.tension[3] += 1; });
    expect("surface_forces", [](auto& s) { s.surface_forces.push_back({0, Vec3::Zero(), Vec3::UnitZ(), 3}); });
    expect("progress", [](auto& s) { s.progress[0] += 0.1; });
    expect("bound", [](auto& s) { s.bound[3] *= 2; });
    expect("capsules", [](auto& s) { s.capsules.push_back({Vec3::Zero(), Vec3::UnitX(), 1}); });
    expect("rows", [](auto& s) { s.rows.at(0).start.x() += 1; });
    expect("contacts", [](auto& s) { s.contacts.at(0).place += 0.1; });
    expect("reach", [](auto& s) { s.reach *= 2; });
    expect("moved", [](auto& s) { s.moved += 1e-9; });
    expect("is_rest_due", [](auto& s) { s.is_rest_due = !s.is_rest_due; });
    expect("seen", [](auto& s) { s.seen.push_back(7); });
    expect("def", [](auto& s) { s.def.friction += 0.1; });
}

TEST(HashOfAllCarried, SeesEachMemberOfAThreadByFollowTheLeader) {
    Thread thread({}, overhand(120));
    sim::thread::Mover mover = sim::thread::make_mover({}, overhand(120), {});
    const auto& ftl = std::get<sim::thread::ftl::Mover>(mover);
    const Hold holds[] = {{0, thread.nodes().front()}, {120, thread.nodes().back() + Vec3(10e-6, 0, 0)}};
    constexpr int owners[] = {-1, -1};
    sim::thread::tick(mover, {holds, owners, {}});
    expect_shared_members_count(ftl);
    const auto expect = [&](const char* what, const auto& change) { expect_another_hash(ftl, what, change); };
    expect("last.drift", [](auto& s) { s.last.drift[3].x() += 1e-9; });
    expect("last.path", [](auto& s) { s.last.path += 1e-9; });
    expect("last.following", [](auto& s) { s.last.following[3] += 0.1; });
    expect("step_controls", [](auto& s) { s.step_controls.at(0).waits += 1; });
    expect("refused", [](auto& s) { s.step_controls.at(0).refused.push_back(Vec3::UnitX()); });
    expect("unfinished.step_control", [](auto& s) { s.unfinished.step_control = 0; });
    expect("unfinished.share", [](auto& s) { s.unfinished.share += 0.1; });
    expect("unfinished.tries", [](auto& s) { s.unfinished.tries += 1; });
    expect("unfinished.nodes", [](auto& s) { s.unfinished.nodes[3].x() += 1e-9; });
    expect("slides", [](auto& s) { s.slides = !s.slides; });
    expect("settled", [](auto& s) { s.settled = !s.settled; });
    expect("last.wraps", [](auto& s) { s.last.wraps[3].presses = true; });
    expect("on_steel", [](auto& s) { s.on_steel.push_back(0); });
    expect("pulled", [](auto& s) { s.pulled[3] += 1e-9; });
    expect("last.pulled", [](auto& s) { s.last.pulled[3] += 1e-9; });
    expect("carried", [](auto& s) { s.carried[3].x() += 1e-9; });
}

TEST(HashOfAllCarried, SeesEachMemberOfAnElasticThread) {
    sim::thread::Mover mover = sim::thread::make_mover(elastic(), overhand(120), {});
    const auto& one = std::get<sim::thread::elastic::Mover>(mover);
    sim::thread::tick(mover, {{}, {}, {}});
    expect_shared_members_count(one);
    const auto expect = [&](const char* what, const auto& change) { expect_another_hash(one, what, change); };
    expect("asleep", [](auto& s) { s.asleep[3] = 1; });
    expect("pressed", [](auto& s) { s.pressed.push_back(s.rows.at(0)); });
    expect("sleeping", [](auto& s) {
        s.sleeping.push_back({s.rows.at(0), {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}});
    });
    expect("watched", [](auto& s) { s.watched[3].x() += 1e-9; });
    expect("watched_ticks", [](auto& s) { s.watched_ticks += 1; });
    expect("rod", [](auto& s) { s.rod.split(3, 0.4); });
}

}  // namespace copies
