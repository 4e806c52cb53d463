#include "app/play/picture.hpp"

#include <algorithm>
#include <limits>

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
    picture.needles = snapshot.needles;
    picture.wires = snapshot.clamps;
    picture.needle_radius = world.needle.wire;
    picture.camera = camera;
    picture.width = width;
    picture.height = height;
    return picture;
}

}  // namespace app
