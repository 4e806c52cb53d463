#include "scenarios/world/jaws.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::world {

namespace {

// Barycentric weights of a point in a tetrahedron: none is below 0 within it.
std::array<double, 4> weights_in(const tissue::Tetrahedron& tet, std::span<const Vec3> nodes, const Vec3& p) {
    const double whole = tissue::volume(tet, nodes);
    std::array<double, 4> weights;
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<Vec3, 4> corner;
        for (std::size_t c = 0; c < 4; ++c) corner[c] = c == k ? p : nodes[static_cast<std::size_t>(tet[c])];
        weights[k] = tissue::volume({0, 1, 2, 3}, corner) / whole;
    }
    return weights;
}

// Tetrahedra that the jaws' middle plane goes through, between hinge and tip.
std::vector<int> tetrahedra_between(const tissue::Tissue& wall, const Tool& tool) {
    std::vector<int> between;
    for (std::size_t t = 0; t < wall.rest().tetrahedra.size(); ++t) {
        sim::geometry::Box box;
        for (const int node : wall.rest().tetrahedra[t])
            box.include(in_tool(tool.before, wall.nodes()[static_cast<std::size_t>(node)]));
        if (box.low.y() <= 0 && box.high.y() >= 0 && box.low.z() <= 0 && box.high.z() >= -tool.shape.jaw_length)
            between.push_back(static_cast<int>(t));
    }
    return between;
}

// Which of `near` is round `p`; -1 where `p` is in none.
int tetrahedron_at(const tissue::Tissue& wall, const std::vector<int>& near, const Vec3& p,
                   std::array<double, 4>& weights) {
    for (const int t : near) {
        weights = weights_in(wall.rest().tetrahedra[static_cast<std::size_t>(t)], wall.nodes(), p);
        if (*std::min_element(weights.begin(), weights.end()) >= 0) return t;
    }
    return -1;
}

// How far apart looks along the jaws are [m].
double look_of(const Tool& tool) {
    return 0.5 * tool.shape.jaw_radius;
}

// One look along the jaws, at `z` in the tool's frame: of each wall between them it takes the point nearest to their
// middle, for a vessel that is pinched flat lies there in two walls.
void look_for_walls(Tool& tool, const JawRoom& room, const SoftVessel& vessel, int number, const std::vector<int>& near,
                    double z) {
    const double look = look_of(tool), low = room.axis_x(room.minus, z), high = room.axis_x(room.plus, z);
    const int looks = std::max(1, static_cast<int>((high - low) / look));
    const tissue::Tissue& wall = vessel.tissue;
    const auto at_rest = [&](const tissue::MaterialPoint& point) {
        return tissue::position(point, wall.rest(), wall.rest().nodes);
    };
    const std::size_t first = tool.walls.size();
    Vec3 last = Vec3::Constant(1e300);  // where the look before was, at rest
    for (int k = 0; k < looks; ++k) {
        const Vec3 p(low + (k + 0.5) * (high - low) / looks, 0, z);
        WallGrip grip{number, {}, p};
        grip.at.tetrahedron =
            tetrahedron_at(wall, near, tool.before.pose.position + tool.before.pose.rotation * p, grip.at.weights);
        if (grip.at.tetrahedron < 0) continue;
        constexpr double other_wall = 4;  // in looks: no wall that is held is pressed to a quarter
        const bool same_wall = (at_rest(grip.at) - last).norm() < other_wall * look;
        last = at_rest(grip.at);
        if (!same_wall && tool.walls.size() == WallGrip::most) break;
        if (!same_wall)
            tool.walls.push_back(grip);
        else if (std::abs(p.x()) < std::abs(tool.walls.back().anchor.x()))
            tool.walls.back() = grip;
    }
    double middle = 0;
    for (std::size_t i = first; i < tool.walls.size(); ++i)
        middle += tool.walls[i].anchor.x() / static_cast<double>(tool.walls.size() - first);
    for (std::size_t i = first; i < tool.walls.size(); ++i) tool.walls[i].anchor.x() -= middle;
}

}  // namespace

// Closing jaws hold the part of a wall that is between them in their middle plane. It comes to lie flat between them,
// as a strand does.
void World::take_wall(Tool& tool, const JawRoom& room) {
    const auto vessels = walls_.vessels();
    for (std::size_t v = 0; v < vessels.size(); ++v) {
        const std::size_t had = tool.walls.size();
        const std::vector<int> near = tetrahedra_between(vessels[v].tissue, tool);
        for (double z = -0.5 * look_of(tool); z > -tool.shape.jaw_length; z -= look_of(tool))
            look_for_walls(tool, room, vessels[v], static_cast<int>(v), near, z);
        if (tool.walls.size() > had)
            log(EventKind::wall_grasp, tool.def.name + ", " + vessels[v].name,
                static_cast<double>(tool.walls.size() - had));
    }
}

// Jaws draw what they hold to where they are; each held point pulls at most with its share of the grip.
void SoftVessel::pull_by(const Tool& tool, int number) {
    // Twenty times as stiff as a wall is under a millimetre's pull, so that what is held lags by a twentieth of how far
    // the wall is drawn.
    constexpr double stiffness = 1000;  // of all points that a tool holds together [N/m]
    for (const WallGrip& grip : tool.walls) {
        if (grip.vessel != number) continue;
        const double share = 1.0 / static_cast<double>(tool.walls.size()), most = share * tool.shape.grip_force;
        const Vec3 wanted = tool.now.pose.position + tool.now.pose.rotation * grip.anchor;
        const Vec3 force = share * stiffness * (wanted - tissue.position(grip.at));
        forces.push_back({grip.at, most / std::max(most, force.norm()) * force, share * stiffness});
    }
}

}  // namespace scenarios::world
