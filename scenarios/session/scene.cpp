#include "scenarios/session/scene.hpp"

#include <algorithm>
#include <cmath>

#include "scenarios/session/fault.hpp"
#include "scenarios/session/starts.hpp"
#include "sim/geometry/portable_math.hpp"
#include "sim/geometry/resample.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "tissue/wall.hpp"

namespace scenarios::session {

namespace {

// Facets so fine that the tube's surface is within a twentieth of the thread's thickness of round, whose sagitta is
// D (1 - cos(pi / n)) / 2 = pi^2 D / (4 n^2), and no finer: every facet near the thread costs a test.
int sides_of(double tube_diameter, double thread_diameter) {
    constexpr double pi = 3.14159265358979324;
    return std::max(12, static_cast<int>(std::ceil(pi / 2 * std::sqrt(20 * tube_diameter / thread_diameter))));
}

assets::Mesh mesh_of(const scenarios::world::VesselDef& vessel, double thread_diameter) {
    constexpr int along = 30;
    assets::Mesh mesh = vessel.mesh_file.empty() ? assets::make_tube(vessel.diameter, vessel.wall, vessel.length,
                                                                     sides_of(vessel.diameter, thread_diameter), along)
                                                 : assets::load_mesh(vessel.mesh_file);
    const auto turn = sim::geometry::rotation_between(sim::geometry::Vec3::UnitX(), vessel.axis);
    for (auto& vertex : mesh.vertices) vertex = vessel.centre + turn * vertex;
    return mesh;
}

// A drill is checked against its tubes when it is read; what a mesh looks like is known only here.
void check_start_is_clear(const scenarios::world::ThreadDef& thread, const std::vector<sim::geometry::Vec3>& start,
                          const std::string& pointer, const sim::geometry::TriangleTree& wall,
                          const std::string& mesh_file) {
    if (const int corner = first_nearer(start, wall, thread.diameter / 2); corner >= 0)
        throw InputFault(mesh_file + ": error: the thread starts in this wall, behind corner " +
                         std::to_string(corner) + " of the drill's " + pointer + ", expected to start clear of it");
    if (const int link = first_nearer(sim::geometry::resample(start, thread.links), wall, thread.diameter / 2);
        link >= 0)
        throw InputFault(mesh_file + ": error: of the drill's " + std::to_string(thread.links) + " links number " +
                         std::to_string(link) +
                         " starts in this wall, expected more of them at /thread/links, or a start farther from it");
}

void check_starts_are_clear(const scenarios::world::WorldDef& def, const std::string& mesh_file,
                            const assets::Mesh& mesh) {
    const sim::geometry::TriangleTree wall(mesh.soup());
    check_start_is_clear(def.thread, def.thread.start, "/thread/start_mm", wall, mesh_file);
    for (std::size_t i = 0; i < def.spares.size(); ++i)
        check_start_is_clear(def.thread, def.spares[i].start, "/thread/spares/" + std::to_string(i) + "/start_mm", wall,
                             mesh_file);
}

// What is no wall, or takes too long: a step is the slower the more cells there are.
void check_wall(const scenarios::world::VesselDef& vessel) {
    constexpr std::size_t most = 1000;  // triangles: 6000 tetrahedra, steps of one to two milliseconds
    const std::string at = vessel.mesh_file + ": error: ";
    if (vessel.triangles.size() > most)
        throw InputFault(at + "has " + std::to_string(vessel.triangles.size()) +
                         " triangles, of a wall that gives way at most " + std::to_string(most) + " are right");
    const tissue::Wall wall = tissue::make_wall(vessel.outside, vessel.triangles, {.thickness = vessel.wall});
    if (wall.problem) throw InputFault(at + *wall.problem);
    const bool is_cut = std::any_of(wall.mesh.faces.begin(), wall.mesh.faces.end(),
                                    [](const tissue::Face& face) { return face.side == tissue::Side::cut; });
    if (vessel.needs_cut && !is_cut)
        throw InputFault(at +
                         "it is closed, so that there is no cut to measure bites and join from, expected an open end, "
                         "or none of bite_mm, gap_mm, lumen, leak_mL_min and lapses in the drill's bands");
}

}  // namespace

scenarios::world::WorldDef with_walls(scenarios::world::WorldDef def) {
    for (auto& vessel : def.vessels) {
        if (!vessel.is_soft || vessel.mesh_file.empty()) continue;
        const assets::Mesh mesh = mesh_of(vessel, def.thread.diameter);
        vessel.outside = mesh.vertices;
        vessel.triangles = mesh.triangles;
        check_wall(vessel);
        check_starts_are_clear(def, vessel.mesh_file, mesh);
    }
    check_soft_starts(def);
    return def;
}

std::vector<assets::Mesh> vessel_meshes(const scenarios::world::WorldDef& def) {
    std::vector<assets::Mesh> meshes;
    for (const auto& vessel : def.vessels) {
        if (vessel.is_soft) continue;
        meshes.push_back(mesh_of(vessel, def.thread.diameter));
        if (!vessel.mesh_file.empty()) check_starts_are_clear(def, vessel.mesh_file, meshes.back());
    }
    return meshes;
}

scenarios::world::World make_world(const scenarios::world::WorldDef& def, const std::vector<assets::Mesh>& vessels,
                                   std::span<const instruments::ToolInput> start) {
    std::vector<sim::geometry::Triangle> surface;
    for (const assets::Mesh& mesh : vessels) {
        const auto soup = mesh.soup();
        surface.insert(surface.end(), soup.begin(), soup.end());
    }
    return {with_walls(def), std::move(surface), start};
}

}  // namespace scenarios::session
