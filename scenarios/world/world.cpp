#include "scenarios/world/world.hpp"

#include <bit>
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
    constexpr double beyond = 1.05;  // tools wait a hundredth below the most
    rod.most_strain = std::max(rod.most_strain, beyond * def.break_force / (def.young_modulus * section(def)));
    if (def.is_in_air) rod.halting_time = halting_time(def);
    if (def.weighs) rod.gravity = {0, 0, -g};
    return rod;
}

// The path may be longer or shorter than the thread: cut it, or go on straight.
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

static std::vector<SoftVessel> soft_vessels(const WorldDef& def) {
    std::vector<SoftVessel> vessels;
    for (const VesselDef& vessel : def.vessels)
        if (vessel.is_soft) vessels.emplace_back(vessel, def.needle.wire);
    return vessels;
}

static double thinnest_wall(const WorldDef& def) {
    double thinnest = 1e300;
    for (const VesselDef& vessel : def.vessels) thinnest = std::min(thinnest, vessel.wall);
    return thinnest;
}

World::World(const WorldDef& def, std::vector<sim::geometry::Triangle> surface, std::span<const ToolInput> start)
    : def_(def),
      thread_(make_thread(def)),
      vessels_(soft_vessels(def)),
      wall_contact_({}, thinnest_wall(def)),
      wall_(with_skins(surface, vessels_), def.thread.diameter / 2),
      targets_(wall_.tree().triangles()),
      strength_{def.thread.break_force} {
    if (!surface.empty()) tool_world_.add_surface(std::move(surface));
    for (std::size_t i = 0; i < def.instruments.size(); ++i) {
        const auto kind = def.instruments[i].kind;
        tool_world_.set_pose(tool_world_.add_tool(kind), start[i]);
        tools_.push_back(
            {def.instruments[i], instruments::shape_of(kind), start[i], start[i], start[i], {}, false, false, false});
        tools_.back().grasps.reserve(16);
        tools_.back().walls.reserve(256);  // two walls at each look along the longest jaws
    }
    for (SoftVessel& vessel : vessels_) clamp(vessel);
    for (const VesselDef& vessel : def.vessels) {  // beyond the thread at either end, wherever it lies
        const Vec3 half = (0.5 * vessel.length + def.thread.length) * vessel.axis.normalized();
        cores_.push_back({vessel.centre - half, vessel.centre, vessel.centre + half});
    }
    const std::size_t tools = tools_.size();
    if (!def.needle_code.empty()) needles_.push_back({0, def.needle, def.needle, {}, {}});
    const auto pieces = thread_.pieces();
    for (const SpareDef& spare : def.spares)
        needles_.push_back({pieces[needles_.size()].first, spare.needle, spare.needle, {}, {}});
    measures_.tail_mm.assign(2, 0);
    measures_.path_mm.assign(tools, 0);
    measures_.grasps.assign(tools, 0);
    measures_.lag_max_mm.assign(tools, {});
    const std::size_t on_needles = 2 * needles_.size();
    for (auto* of_nodes : {&held_, &hold_owners_}) of_nodes->reserve(16 * tools + on_needles);
    holds_.reserve(16 * tools + on_needles);
    capsules_.reserve(instruments::part_count * tools + instruments::needle_parts * needles_.size());
    swages_.reserve(needles_.size());
    events_.reserve(1024);
    gaps_.reserve(4096);
}

void World::log(EventKind kind, const std::string& what, double value) {
    events_.push_back({time_s(), kind, what, value});
}

std::uint64_t World::hash() const {
    std::uint64_t hash = thread_.hash();
    const auto add = [&](double value) { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u; };
    for (const Tool& tool : tools_) {
        for (const ToolInput* input : {&tool.now, &tool.asked}) {
            for (int c = 0; c < 3; ++c) add(input->pose.position[c]);
            for (int c = 0; c < 4; ++c) add(input->pose.rotation.coeffs()[c]);
        }
        add(tool.now.jaw);
        add(tool.closed);
        for (const Grasp& grasp : tool.grasps) {
            add(grasp.first);
            for (int k = 0; k < grasp.count; ++k)
                for (int c = 0; c < 3; ++c) add(grasp.anchor[static_cast<std::size_t>(k)][c]);
        }
    }
    const auto add_place = [&](const Vec3& place) {
        for (int c = 0; c < 3; ++c) add(place[c]);
    };
    for (const SoftVessel& vessel : vessels_) {
        for (const Vec3& node : vessel.tissue.nodes()) add_place(node);
        for (int t = 0; t < vessel.skin.size(); ++t)
            add_place(wall_.tree()[vessel.first + t].a);  // which may be behind the tissue
        for (const tissue::Bite& bite : vessel.bites.bites())
            add(static_cast<double>(bite.state) + 4 * bite.on_needle + 8 * bite.torn);
    }
    for (const Needle& needle : needles_) {
        for (const Vec3* of_needle : {&needle.now.centre, &needle.now.to_tail, &needle.now.onwards})
            add_place(*of_needle);
        for (const Holder* holder : {&needle.holder, &needle.next}) add(holder->tool);
        add(needle.bent);
    }
    for (const std::size_t needle : {taken_, in_use_})
        if (needle > 0) add(static_cast<double>(needle));
    for (const Tool& tool : tools_)
        for (const WallGrip& grip : tool.walls) add_place(grip.anchor);
    if (strength_.pulled_s > 0) add(strength_.pulled_s);
    for (const SoftVessel& vessel : vessels_) {
        for (const Vec3& pull : vessel.pulls) add_place(pull);
        for (const Vec3& pull : vessel.mean_pulls) add_place(pull);
        for (const sim::thread::Strength& strength : vessel.strengths)
            if (strength.pulled_s > 0) add(strength.pulled_s);
    }
    return hash;
}

}  // namespace scenarios::world
