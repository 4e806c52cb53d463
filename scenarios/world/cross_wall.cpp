#include "scenarios/world/world.hpp"
#include "sim/geometry/closest_points.hpp"

// Tools that are led through walls. A wall that a tool presses on moves out of its way, so that the skin stays a radius
// off the tool's middle line. Where that line meets the skin the wall could give way no further.
namespace scenarios::world {

namespace {

int vessel_of(int triangle, std::span<const SoftVessel> vessels) {
    int number = 0;
    for (std::size_t i = 0; i < vessels.size(); ++i)
        if (vessels[i].first <= triangle) number = static_cast<int>(i);
    return number;
}

bool meets(const sim::geometry::Capsule& part, int triangle, const sim::geometry::TriangleTree& skin) {
    if (skin.plane_gap(triangle, part.a, part.b) > 0) return false;
    constexpr double rounding = 1e-6;  // of the radius
    const double least = rounding * part.radius;
    return sim::geometry::closest_points(part.a, part.b, skin[triangle]).distance_squared < least * least;
}

}  // namespace

// Which vessel's wall the tool is led through; -1: none.
int World::wall_crossed_by(const Tool& tool) {
    for (const auto& part : instruments::parts_at(tool.shape, tool.now.pose, tool.now.jaw)) {
        sim::geometry::Box box;
        box.include(part.a), box.include(part.b);
        near_.clear();
        walls_.tree().near(box, near_);
        for (const int triangle : near_)
            if (triangle >= walls_.soft_from() && meets(part, triangle, walls_.tree()))
                return vessel_of(triangle, vessels());
    }
    return -1;
}

// Jaws that hold a wall have it between them, and may be on both its sides.
void World::watch_tools_in_walls() {
    if (vessels().empty()) return;
    for (Tool& tool : tools_) {
        const bool holds = !tool.walls.empty() || tool.def.kind == instruments::Kind::approximator;
        const int before = tool.crosses;
        tool.crosses = holds ? -1 : wall_crossed_by(tool);
        if (tool.crosses < 0 || before >= 0) continue;
        if (measures_.walls_crossed++ == 0) measures_.first_crossed_s = time_s();
        log(EventKind::wall_crossed, tool.def.name + ", " + vessels()[static_cast<std::size_t>(tool.crosses)].name, 0);
    }
}

}  // namespace scenarios::world
