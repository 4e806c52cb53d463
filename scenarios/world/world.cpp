#include "scenarios/world/world.hpp"

#include <cassert>
#include <cmath>

#include "sim/geometry/resample.hpp"

namespace scenarios::world {

static double section(const ThreadDef& def) {
    constexpr double quarter_pi = 0.78539816339744831;
    return quarter_pi * def.diameter * def.diameter;  // [m^2]
}

static sim::thread::RodDef elastic(const ThreadDef& def) {
    constexpr double g = 9.81;
    sim::thread::RodDef rod{.young = def.young_modulus,
                            .bending_share = def.bending_share,
                            .density = def.density,
                            .keeps_shape = true,
                            .quasi_static = !def.swings,
                            .yield_strain = def.yield_strain};
    if (def.stretches) rod.axial_over_bending = 0;
    constexpr double beyond = 1.05;  // tools wait a hundredth below the largest strain
    rod.most_strain = std::max(rod.most_strain, beyond * def.break_force / (def.young_modulus * section(def)));
    if (def.is_in_air) rod.halting_time = halting_time(def);
    if (def.weighs) rod.gravity = {0, 0, -g};
    return rod;
}

// Nodes along the path; a path that is longer than the thread is cut short, a shorter one goes on straight.
static std::vector<Vec3> nodes_on(const std::vector<Vec3>& start, const WorldDef& world) {
    std::vector<Vec3> path{start.front()};
    double left = world.thread.length;
    for (std::size_t i = 1; i < start.size() && left > 0; ++i) {
        const Vec3 piece = start[i] - start[i - 1];
        const double length = piece.norm();
        const bool last = i + 1 == start.size();
        path.push_back(length > left || last ? Vec3(start[i - 1] + left / length * piece) : start[i]);
        left -= length;
    }
    auto nodes = sim::geometry::resample(path, world.thread.links);
    const int shares =
        static_cast<int>(std::lround(world.thread.length / world.thread.links / first_link(world)));  // a power of two
    const auto fine = sim::geometry::resample(path, shares * world.thread.links);
    for (int share = shares / 2; share > 0; share /= 2)
        nodes.insert(nodes.begin() + 1, fine[static_cast<std::size_t>(share)]);
    return nodes;
}

static sim::thread::Thread make_thread(const WorldDef& world) {
    const ThreadDef& def = world.thread;
    assert(world.tick_s > 0 && def.links > 0 && !def.start.empty() && "a thread that lies somewhere");
    sim::thread::ThreadDef thread{def.diameter / 2,  def.friction,
                                  def.friction_tool, def.young_modulus * section(def),
                                  def.shortest_link, def.contacts_per_tick};
    if (def.model == "elastic") thread.elastic = elastic(def);
    std::vector<Vec3> nodes = nodes_on(def.start, world);
    std::vector<int> cuts;
    for (const SpareDef& spare : world.spares) {
        cuts.push_back(static_cast<int>(nodes.size()) - 1);
        const auto more = nodes_on(spare.start, world);
        nodes.insert(nodes.end(), more.begin(), more.end());
    }
    return {thread, nodes, cuts};
}

static std::vector<Tool> make_tools(const WorldDef& def, std::span<const ToolInput> start) {
    std::vector<Tool> tools;
    for (std::size_t i = 0; i < def.instruments.size(); ++i) {
        Tool& tool = tools.emplace_back();
        tool.def = def.instruments[i];
        tool.shape = instruments::shape_of(tool.def.kind);
        tool.asked = tool.before = tool.now = start[i];
        tool.grasps.reserve(16);
        tool.walls.reserve(WallGrip::most);
    }
    return tools;
}

static std::vector<Needle> make_needles(const WorldDef& def, const std::vector<sim::thread::Piece>& pieces) {
    std::vector<Needle> needles;
    if (!def.needle_code.empty()) needles.push_back({0, def.needle, def.needle, {}, {}});
    for (const SpareDef& spare : def.spares)
        needles.push_back({pieces[needles.size()].first, spare.needle, spare.needle, {}, {}});
    return needles;
}

World::World(const WorldDef& def, std::vector<sim::geometry::Triangle> surface, std::span<const ToolInput> start)
    : def_(def),
      thread_(make_thread(def)),
      walls_(def, surface),
      tools_(make_tools(def, start)),
      needles_(make_needles(def, thread_.pieces())),
      strength_{def.thread.break_force},
      knot_watch_(def) {
    assert(start.size() == def.instruments.size() && "a place for each instrument");
    if (!surface.empty()) tool_world_.add_surface(std::move(surface));
    for (std::size_t i = 0; i < tools_.size(); ++i)
        tool_world_.set_pose(tool_world_.add_tool(tools_[i].def.kind), start[i]);
    walls_.clamp(tools_);
    measures_.tail_mm.assign(2, 0);
    measures_.path_mm.assign(tools_.size(), 0);
    measures_.grasps.assign(tools_.size(), 0);
    measures_.lag_max_mm.assign(tools_.size(), {});
    reserve();
}

void World::reserve() {
    const std::size_t held = thread_.nodes().size() + 2 * needles_.size();
    for (auto* of_nodes : {&held_, &hold_owners_}) of_nodes->reserve(held);
    holds_.reserve(held);
    capsules_.reserve(instruments::part_count * tools_.size() + instruments::needle_parts * needles_.size());
    swages_.reserve(needles_.size());
    near_.reserve(static_cast<std::size_t>(walls_.tree().size()));
    events_.reserve(1024);
}

void World::log(EventKind kind, const std::string& what, double value) {
    events_.push_back({time_s(), kind, what, value});
}

}  // namespace scenarios::world
