#pragma once
#include "scenarios/world/world.hpp"

namespace scenarios::world {

/// Opens what a world keeps to itself, so that a test can look at one member or change it alone.
struct ForTests {
    static sim::thread::Thread& thread(World& world) { return world.thread_; }
    static instruments::ToolWorld& tool_world(World& world) { return world.tool_world_; }
    static std::vector<Tool>& tools(World& world) { return world.tools_; }
    static std::vector<Needle>& needles(World& world) { return world.needles_; }
    static std::size_t& taken(World& world) { return world.taken_; }
    static std::size_t& in_use(World& world) { return world.in_use_; }
    static sim::thread::Strength& strength(World& world) { return world.strength_; }
    static std::vector<Event>& events(World& world) { return world.events_; }
    static Measures& measures(World& world) { return world.measures_; }
    static Worst& worst(World& world) { return world.worst_; }
    static std::uint64_t& ticks(World& world) { return world.ticks_; }
    static std::uint64_t& substeps(World& world) { return world.substeps_; }
    static double& tension_now(World& world) { return world.tension_now_; }
    static double& stretch_now(World& world) { return world.stretch_now_; }

    static std::vector<SoftVessel>& vessels(World& world) { return world.walls_.vessels_; }
    static MovingWall& shown(World& world) { return world.walls_.shown_; }
    static std::vector<Triangle>& targets(World& world) { return world.walls_.targets_; }
    static bool& is_new(World& world) { return world.walls_.is_new_; }
    static double& moved(World& world) { return world.walls_.moved_; }

    static KnotWatch& knot_watch(World& world) { return world.knot_watch_; }
    static bool is_being_named(const World& world) { return world.knot_watch_.naming_.valid(); }
    static bool& is_moved(World& world) { return world.knot_watch_.moved_; }
    static std::vector<NamedPiece>& named(World& world) { return world.knot_watch_.named_; }
};

}  // namespace scenarios::world
