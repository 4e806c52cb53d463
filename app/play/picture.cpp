#include "app/play/picture.hpp"

#include <algorithm>
#include <limits>

#include "sim/geometry/portable_math.hpp"

namespace app {

using scenarios::world::WorldDef;
using sim::geometry::Vec3;

namespace {

// What must be in every picture: a hand's width of field about the vessels, and all of every hand's jaw.
std::vector<Vec3> field_of(const WorldDef& world, const Snapshot& snapshot) {
    constexpr double across = 19e-3, along = 12e-3, margin = 2e-3;  // [m] as much to either side
    std::vector<Vec3> points;
    const auto add = [&](const Vec3& middle, double x, double y) {
        for (const double side : {-1.0, 1.0})
            for (const Vec3& off : {Vec3(x, 0, 0), Vec3(0, y, 0), Vec3(0, 0, y)}) points.push_back(middle + side * off);
    };
    if (world.vessels.empty()) add(Vec3::Zero(), across, along);
    for (const auto& vessel : world.vessels) add(vessel.centre, across, along);
    for (std::size_t i = 0; i < snapshot.tools.size(); ++i) {
        if (world.instruments[i].kind == instruments::Kind::approximator) continue;  // it stands aside
        const auto& [pose, jaw] = snapshot.tools[i];
        const auto parts = instruments::parts_at(instruments::shape_of(world.instruments[i].kind), pose, jaw);
        for (const int part : {instruments::jaw_plus, instruments::jaw_minus})
            for (const Vec3& end : {parts[part].a, parts[part].b}) add(end, margin, margin);
    }
    return points;
}

// From the vessel that is looked at: unit, or zero about its middle (a quarter of what is seen), where one way to look
// is as good as another.
Vec3 outwards(const Snapshot& snapshot) {
    const auto& [centre, radius] = *snapshot.close_up;
    double nearest = std::numeric_limits<double>::infinity();
    for (const assets::Mesh& mesh : snapshot.vessels)
        for (const Vec3& vertex : mesh.vertices) nearest = std::min(nearest, (vertex - centre).norm());
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const assets::Mesh& mesh : snapshot.vessels)
        for (const Vec3& vertex : mesh.vertices)
            if ((vertex - centre).norm() < nearest + 2 * radius) sum += vertex, ++count;
    const Vec3 way = count > 0 ? Vec3(centre - sum / count) : Vec3(Vec3::Zero());
    return way.norm() > radius / 4 ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
}

// A rigid tube has as many facets as the thread needs to slide on; to the eye fewer are as round.
void show_tubes(const WorldDef& world, std::vector<assets::Mesh>& vessels) {
    constexpr int around = 32, along = 6;
    std::size_t number = 0;
    for (const auto& vessel : world.vessels) {
        if (vessel.is_soft || number >= vessels.size()) continue;
        assets::Mesh& mesh = vessels[number++];
        if (!vessel.mesh_file.empty()) continue;
        mesh = assets::make_tube(vessel.diameter, vessel.wall, vessel.length, around, along);
        const auto turn = sim::geometry::rotation_between(Vec3::UnitX(), vessel.axis);
        for (Vec3& vertex : mesh.vertices) vertex = vessel.centre + turn * vertex;
    }
}

// The middle and the way out of a ring that an approximator's clamp draws about an end: its wire is an arm, then that.
draw::Continued ringed(std::size_t vessel, const std::vector<Vec3>& wire, const Vec3& inside) {
    const std::size_t count = wire.size() - 2;  // the last is the first again
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 1; k <= count; ++k) centre += wire[k] / static_cast<double>(count);
    const Vec3 normal = (wire[1] - centre).cross(wire[1 + count / 4] - centre).normalized();
    return {vessel, centre, normal.dot(centre - inside) < 0 ? Vec3(-normal) : normal};
}

Vec3 middle_of(const assets::Mesh& mesh) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& vertex : mesh.vertices) sum += vertex;
    return sum / static_cast<double>(std::max<std::size_t>(1, mesh.vertices.size()));
}

// Of tubes alone; where the body of a mesh goes on is not known. Those that do not give way are shown first.
std::vector<draw::Continued> continued_ends(const WorldDef& world, const Snapshot& snapshot) {
    std::vector<draw::Continued> ends;
    std::size_t number = 0, clamp = 0;
    for (const bool soft : {false, true})
        for (const auto& vessel : world.vessels) {
            if (vessel.is_soft != soft) continue;
            const std::size_t own = number++;
            const std::vector<Vec3>* wire = soft && vessel.held_by >= 0 ? &snapshot.clamps[clamp++] : nullptr;
            if (!vessel.mesh_file.empty() || own >= snapshot.vessels.size()) continue;
            if (wire) {
                ends.push_back(ringed(own, *wire, middle_of(snapshot.vessels[own])));
                continue;
            }
            const Vec3 along = vessel.axis.normalized(), half = vessel.length / 2 * along;
            if (vessel.start_held) ends.push_back({own, vessel.centre - half, -along});
            if (vessel.end_held) ends.push_back({own, vessel.centre + half, along});
        }
    return ends;
}

// Under the vessels, and under whatever a hand reaches for or holds below them.
double drape_under(const WorldDef& world, const Snapshot& snapshot) {
    constexpr double below_vessel = 9e-3, below_jaw = 4e-3;  // [m]
    double low = -below_vessel;
    for (const auto& vessel : world.vessels)
        low = std::min(low, vessel.centre.z() - vessel.diameter / 2 - below_vessel);
    for (std::size_t i = 0; i < snapshot.tools.size(); ++i)
        if (world.instruments[i].kind != instruments::Kind::approximator)
            low = std::min(low, snapshot.tools[i].pose.position.z() - below_jaw);
    return low;
}

}  // namespace

draw::Camera camera_of(const WorldDef& world, const Snapshot& snapshot, double aspect) {
    if (!snapshot.close_up) return draw::view_of(field_of(world, snapshot), aspect);
    return draw::close_view(snapshot.close_up->centre, snapshot.close_up->radius, outwards(snapshot));
}

draw::Picture picture_of(const WorldDef& world, const Snapshot& snapshot, const draw::Camera& camera, int width,
                         int height) {
    draw::Picture picture;
    picture.thread = snapshot.thread;
    picture.thread_radius = world.thread.diameter / 2;
    for (std::size_t i = 0; i < snapshot.tools.size(); ++i)
        picture.tools.push_back({world.instruments[i].kind, snapshot.tools[i].pose, snapshot.tools[i].jaw});
    picture.vessels = snapshot.vessels;
    show_tubes(world, picture.vessels);
    picture.needles = snapshot.needles;
    picture.wires = snapshot.clamps;
    picture.continued = continued_ends(world, snapshot);
    picture.drape = drape_under(world, snapshot);
    picture.needle_radius = world.needle.wire;
    picture.camera = camera;
    picture.width = width;
    picture.height = height;
    return picture;
}

}  // namespace app
