// Whatever a world carries from tick to tick is in its copies and in its hashes.
#include <gtest/gtest.h>

#include <optional>

#include "tests/scenarios/world/for_tests.hpp"
#include "tests/scenarios/world/scene.hpp"

namespace carrying {

using namespace scene;
using scenarios::world::ForTests;
using scenarios::world::SoftVessel;

/// Two needles with their threads, a vessel with a bite, and a tool that has thread and wall in its jaws.
Scene full_scene() {
    Scene scene;
    scene.def.needle_code = "BV-1";
    scene.def.needle.centre = {0, 0, 20 * mm};
    const auto& needle = scene.def.needle;
    scene.lay({needle.tail(), needle.tail() - 30 * mm * needle.tangent(0)}, 100);
    const Vec3 aside(0, 0, 20 * mm);
    scene.def.spares = {{needle, scene.def.thread.start}};
    scene.def.spares[0].needle.centre += aside;
    for (Vec3& corner : scene.def.spares[0].start) corner += aside;
    auto vessel = end_at(0, 6 * mm);
    vessel.bitten = {{Vec3(-1.5 * mm, 0, 2.5 * mm), Vec3(-1.5 * mm, 0, 1 * mm)}};
    scene.def.vessels = {vessel};
    scene.add("right", Kind::needle_holder, {across(needle.at(2 * mm), needle.tangent(2 * mm), Vec3::UnitZ()), 1});
    scene.add("left", Kind::forceps, {{{0, -60 * mm, 0}, Quat::Identity()}, 1});
    return scene;
}

World full_world() {
    const Scene scene = full_scene();
    World world = scene.world();
    scene.play(world, 60);
    auto& tool = ForTests::tools(world)[1];
    tool.grasps.push_back({40, {Vec3(0, 0, -1 * mm)}});
    tool.walls.push_back({0, {}, Vec3(0, 0, -1 * mm)});
    return world;
}

using HashOf = std::uint64_t (World::*)() const;

/// Changes one member alone and expects another hash.
template <class Change>
void expect_another(HashOf hash, const World& world, const char* what, const Change& change) {
    World changed = world;
    change(changed);
    EXPECT_NE((changed.*hash)(), (world.*hash)()) << what;
}

std::vector<Vec3> moved_nodes(const SoftVessel& vessel) {
    std::vector<Vec3> nodes(vessel.tissue.nodes().begin(), vessel.tissue.nodes().end());
    for (Vec3& node : nodes) node.x() += 1e-9;
    return nodes;
}

// What a recording holds against a replay.
void expect_state_counts(HashOf hash, const World& world) {
    const auto expect = [&](const char* what, const auto& change) { expect_another(hash, world, what, change); };
    expect("thread", [](World& w) { ForTests::thread(w).cut(50, 0.5, {}); });
    const auto expect_tool = [&](const char* what, const auto& change) {
        expect(what, [&](World& w) { change(ForTests::tools(w)[1]); });
    };
    expect_tool("Tool::now, position", [](auto& tool) { tool.now.pose.position.x() += 1e-9; });
    expect_tool("Tool::now, rotation", [](auto& tool) { tool.now.pose.rotation.x() += 1e-9; });
    expect_tool("Tool::now, jaw", [](auto& tool) { tool.now.jaw -= 1e-9; });
    expect_tool("Tool::asked, position", [](auto& tool) { tool.asked.pose.position.z() += 1e-9; });
    expect_tool("Tool::asked, rotation", [](auto& tool) { tool.asked.pose.rotation.z() += 1e-9; });
    expect_tool("Tool::closed", [](auto& tool) { tool.closed = !tool.closed; });
    expect_tool("Grasp::first", [](auto& tool) { ++tool.grasps[0].first; });
    expect_tool("Grasp::anchor", [](auto& tool) { tool.grasps[0].anchor[0].y() += 1e-9; });
    expect_tool("WallGrip::anchor", [](auto& tool) { tool.walls[0].anchor.y() += 1e-9; });
    const auto expect_needle = [&](const char* what, const auto& change) {
        expect(what, [&](World& w) { change(ForTests::needles(w)[1]); });
    };
    expect_needle("Needle::now, centre", [](auto& needle) { needle.now.centre.x() += 1e-9; });
    expect_needle("Needle::now, to_tail", [](auto& needle) { needle.now.to_tail.x() += 1e-9; });
    expect_needle("Needle::now, onwards", [](auto& needle) { needle.now.onwards.x() += 1e-9; });
    expect_needle("Needle::holder", [](auto& needle) { needle.holder.tool = 1; });
    expect_needle("Needle::next", [](auto& needle) { needle.next.tool = 1; });
    expect_needle("Needle::bent", [](auto& needle) { needle.bent = true; });
    expect("taken", [](World& w) { ForTests::taken(w) = 1; });
    expect("in_use", [](World& w) { ForTests::in_use(w) = 1; });
    expect("strength", [](World& w) { ForTests::strength(w).pulled_s = 1e-3; });
    const auto expect_vessel = [&](const char* what, const auto& change) {
        expect(what, [&](World& w) { change(ForTests::vessels(w)[0]); });
    };
    expect_vessel("SoftVessel::tissue", [](auto& vessel) { vessel.tissue.place(moved_nodes(vessel)); });
    expect_vessel("SoftVessel::bites", [](auto& vessel) {
        tissue::Skin slit = vessel.skin;
        vessel.bites.pull(0, 1e3, slit);
    });
    expect_vessel("SoftVessel::pulls", [](auto& vessel) { vessel.pulls.at(0).x() += 1e-9; });
    expect_vessel("SoftVessel::mean_pulls", [](auto& vessel) { vessel.mean_pulls.at(0).x() += 1e-9; });
    expect_vessel("SoftVessel::strengths", [](auto& vessel) { vessel.strengths.at(0).pulled_s = 1e-3; });
    expect("shown", [](World& w) {
        auto targets = ForTests::shown(w).tree().triangles();
        for (auto& triangle : targets) triangle.a.x() += 1e-6, triangle.b.x() += 1e-6, triangle.c.x() += 1e-6;
        ForTests::shown(w).follow(targets, std::vector<double>(targets.size(), 1), {});
    });
}

TEST(StateHash, SeesEachMemberThatProvesAReplay) {
    expect_state_counts(&World::hash, full_world());
}

void expect_rest_of_tools_counts(const World& world) {
    const auto expect = [&](const char* what, const auto& change) {
        expect_another(&World::hash_of_all_carried, world, what, [&](World& w) { change(ForTests::tools(w)[1]); });
    };
    expect("Tool::before", [](auto& tool) { tool.before.jaw -= 1e-9; });
    expect("Tool::asked, jaw", [](auto& tool) { tool.asked.jaw -= 1e-9; });
    expect("Tool::stopped", [](auto& tool) { tool.stopped = !tool.stopped; });
    expect("Tool::slipping", [](auto& tool) { tool.slipping = !tool.slipping; });
    expect("Tool::held_up", [](auto& tool) { tool.held_up = !tool.held_up; });
    expect("Tool::crosses", [](auto& tool) { tool.crosses = 0; });
    expect("Grasp::count", [](auto& tool) { tool.grasps[0].anchor.clear(); });
    expect("WallGrip::vessel", [](auto& tool) { tool.walls[0].vessel = 1; });
    expect("WallGrip::at", [](auto& tool) { tool.walls[0].at.weights[2] += 1e-9; });
}

void expect_rest_of_needles_counts(const World& world) {
    const auto expect = [&](const char* what, const auto& change) {
        expect_another(&World::hash_of_all_carried, world, what, [&](World& w) { change(ForTests::needles(w)[1]); });
    };
    expect("Needle::node", [](auto& needle) { ++needle.node; });
    expect("Needle::before", [](auto& needle) { needle.before.centre.x() += 1e-9; });
    expect("Holder::seen", [](auto& needle) { needle.holder.seen.centre.x() += 1e-9; });
    expect("Holder::along", [](auto& needle) { needle.next.along += 1e-9; });
}

void expect_rest_of_walls_counts(const World& world) {
    const auto expect = [&](const char* what, const auto& change) {
        expect_another(&World::hash_of_all_carried, world, what, change);
    };
    const auto expect_vessel = [&](const char* what, const auto& change) {
        expect(what, [&](World& w) { change(ForTests::vessels(w)[0]); });
    };
    expect_vessel("Tissue's velocity", [](auto& vessel) { vessel.tissue.step({}, 1e-9); });
    expect_vessel("SoftVessel::skin", [](auto& vessel) { vessel.skin.update(moved_nodes(vessel)); });
    expect_vessel("Skin's wires", [](auto& vessel) {
        const tissue::Skin::Wire wire{0, Vec3::Zero(), Vec3::UnitZ()};
        vessel.skin.set_wires({&wire, 1});
    });
    expect_vessel("Bites' needle", [](auto& vessel) {
        const scenarios::world::Arc arc{.centre = {0, 0, 50 * mm}};
        vessel.bites.press(&arc, vessel.skin);
    });
    expect_vessel("SoftVessel::clamps", [](auto& vessel) { vessel.clamps.at(0).target.x() += 1e-9; });
    expect_vessel("SoftVessel::side", [](auto& vessel) { vessel.side *= -1; });
    expect_vessel("SoftVessel::to_jaw", [](auto& vessel) { vessel.to_jaw.translation().x() += 1e-9; });
    expect_vessel("SoftVessel::carried", [](auto& vessel) { vessel.carried.translation().x() += 1e-9; });
    expect_vessel("SoftVessel::forces", [](auto& vessel) { vessel.forces.push_back({{}, Vec3::UnitX()}); });
    expect_vessel("SoftVessel::presses", [](auto& vessel) { vessel.presses.push_back({{}, -1, 1, Vec3::UnitX(), 0}); });
    expect_vessel("SoftVessel::strengths, force", [](auto& vessel) { vessel.strengths.at(0).force /= 2; });
    expect_vessel("SoftVessel::bitten_s", [](auto& vessel) { vessel.bitten_s.push_back(1); });
    expect_vessel("SoftVessel::first", [](auto& vessel) { ++vessel.first; });
    expect("Walls::targets", [](World& w) { ForTests::targets(w).at(0).b.x() += 1e-9; });
    expect("Walls::is_new", [](World& w) { ForTests::is_new(w) = !ForTests::is_new(w); });
    expect("Walls::moved", [](World& w) { ForTests::moved(w) += 1e-9; });
}

void expect_measures_count(const World& world) {
    const auto expect = [&](const char* what, const auto& change) {
        expect_another(&World::hash_of_all_carried, world, what, [&](World& w) { change(ForTests::measures(w)); });
    };
    expect("knot", [](auto& measures) { measures.knot.knot = "3_1"; });
    expect("surgical", [](auto& measures) { measures.knot.surgical = "square"; });
    expect("throws", [](auto& measures) { measures.knot.throws = "1=1"; });
    expect("factors", [](auto& measures) { measures.knot.factors.push_back({"3_1", true, 3}); });
    expect("throw_list", [](auto& measures) { measures.knot.throw_list.push_back({2, false}); });
    expect("certain", [](auto& measures) { measures.knot.certain = !measures.knot.certain; });
    expect("hitched_to", [](auto& measures) { measures.hitched_to = 1; });
    expect("piece", [](auto& measures) { measures.piece = 1; });
    expect("knot_since_s", [](auto& measures) { measures.knot_since_s += 1; });
    expect("needle_deg", [](auto& measures) { measures.needle_deg = {{89, 1}}; });
    expect("duration_s", [](auto& measures) { measures.duration_s += 1; });
    expect("path_mm", [](auto& measures) { measures.path_mm[1] += 1e-9; });
    expect("grasps", [](auto& measures) { ++measures.grasps[1]; });
    expect("tension_max_N", [](auto& measures) { measures.tension_max_N.value += 1e-9; });
    expect("tension_max_N, at", [](auto& measures) { measures.tension_max_N.at_s += 1e-3; });
    expect("lag_max_mm", [](auto& measures) { measures.lag_max_mm[1].value += 1e-9; });
    expect("pass_throughs", [](auto& measures) { ++measures.pass_throughs; });
    expect("first_pass_through_s", [](auto& measures) { measures.first_pass_through_s += 1; });
    expect("broke_s", [](auto& measures) { measures.broke_s = 1; });
    expect("walls_crossed", [](auto& measures) { ++measures.walls_crossed; });
    expect("first_crossed_s", [](auto& measures) { measures.first_crossed_s = 1; });
}

void expect_rest_of_world_counts(const World& world) {
    const auto expect = [&](const char* what, const auto& change) {
        expect_another(&World::hash_of_all_carried, world, what, change);
    };
    expect("tool_world", [](World& w) { ForTests::tool_world(w).set_pose(1, {}); });
    expect("strength, force", [](World& w) { ForTests::strength(w).force /= 2; });
    expect("events", [](World& w) { ForTests::events(w).push_back({0, scenarios::world::EventKind::slip, "right"}); });
    expect("Worst::stretch", [](World& w) { ForTests::worst(w).stretch += 1e-9; });
    expect("Worst::separation", [](World& w) { ForTests::worst(w).separation /= 2; });
    expect("Worst::step_over_bound", [](World& w) { ForTests::worst(w).step_over_bound += 1e-9; });
    expect("Worst::contacts", [](World& w) { ++ForTests::worst(w).contacts; });
    expect("ticks", [](World& w) { ++ForTests::ticks(w); });
    expect("substeps", [](World& w) { ++ForTests::substeps(w); });
    expect("tension_now", [](World& w) { ForTests::tension_now(w) += 1e-9; });
    expect("stretch_now", [](World& w) { ForTests::stretch_now(w) += 1e-9; });
    expect("KnotWatch::moved", [](World& w) { ForTests::is_moved(w) = !ForTests::is_moved(w); });
    expect("KnotWatch::named", [](World& w) { ForTests::named(w).push_back({{Vec3::Zero()}, {}}); });
    expect("KnotWatch::naming", [](World& w) {
        const bool moved = ForTests::is_moved(w);
        ForTests::knot_watch(w).start(w.curves());
        ForTests::is_moved(w) = moved;
    });
}

TEST(HashOfAllCarried, SeesEachMemberOfAWorld) {
    const World world = full_world();
    expect_state_counts(&World::hash_of_all_carried, world);
    expect_rest_of_tools_counts(world);
    expect_rest_of_needles_counts(world);
    expect_rest_of_walls_counts(world);
    expect_measures_count(world);
    expect_rest_of_world_counts(world);
}

// A needle takes hold of, thread falls slack, a naming starts: both copies, one made, one assigned, do the same.
TEST(WorldCopy, GoesOnAsTheOriginalThatIsGone) {
    Scene scene = full_scene();
    scene.tools[0].jaw = 0;
    const auto play = [&](World& world) {
        std::vector<std::uint64_t> hashes;
        for (int t = 0; t < 150; ++t) {
            auto tools = scene.tools;
            tools[0].pose.position.y() += 0.02 * mm * t;
            world.tick(tools);
            hashes.push_back(world.hash());
        }
        hashes.push_back(world.hash_of_all_carried());
        return hashes;
    };
    std::optional<World> original = scene.world();
    scene.play(*original, 105);
    ASSERT_TRUE(ForTests::is_being_named(*original));
    World copy = *original, assigned = full_world();
    assigned = *original;
    const auto hashes = play(*original);
    original.reset();
    EXPECT_EQ(play(copy), hashes);
    EXPECT_EQ(play(assigned), hashes);
}

}  // namespace carrying
