#include "tests/bench/lab/wall_watch.hpp"

#include <algorithm>

namespace bench::lab {

using scenarios::world::SoftVessel;
using scenarios::world::World;

namespace {

double thinnest(const World& world) {
    double wall = 1;
    for (const auto& vessel : world.def().vessels) wall = std::min(wall, vessel.wall);
    return wall;
}

double smallest_share(const SoftVessel& vessel, const std::vector<double>& volumes) {
    const auto& tetrahedra = vessel.tissue.rest().tetrahedra;
    double least = 1e300;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        least = std::min(least, tissue::volume(tetrahedra[t], vessel.tissue.nodes()) / volumes[t]);
    return least;
}

double off_rest(const SoftVessel& vessel) {
    const auto now = vessel.tissue.nodes(), rest = std::span<const Vec3>(vessel.tissue.rest().nodes);
    double most = 0;
    for (std::size_t n = 0; n < now.size(); ++n) most = std::max(most, (now[n] - rest[n]).norm());
    return most;
}

// Where along the thread it is in a hole: where a link goes through the hole's plane near what the wire left open; -1
// where none does.
double place_in(const World& world, const tissue::Skin& skin, int hole) {
    constexpr double aside = 2;  // radii: a thread that draws the wall along is ahead of it
    const Vec3 centre = skin.centre(hole), up = skin.normal_of_hole(hole);
    const auto nodes = world.thread();
    const auto rest = world.thread_state().rest_lengths();
    double before = 0;
    for (std::size_t k = 0; k < rest.size(); before += rest[k++]) {
        const double a = up.dot(nodes[k] - centre), b = up.dot(nodes[k + 1] - centre);
        if ((a < 0) == (b < 0) || world.thread_state().is_cut(static_cast<int>(k))) continue;
        const double share = a / (a - b);
        if ((nodes[k] + share * (nodes[k + 1] - nodes[k]) - centre).norm() < aside * skin.radius(hole))
            return before + share * rest[k];
    }
    return -1;
}

std::vector<Threaded> threaded(const World& world) {
    std::vector<Threaded> found;
    for (std::size_t v = 0; v < world.vessels().size(); ++v)
        for (int hole = 0; hole < world.vessels()[v].skin.holes(); ++hole)
            if (const double along = place_in(world, world.vessels()[v].skin, hole); along >= 0)
                found.push_back({static_cast<int>(v), hole, along});
    std::sort(found.begin(), found.end(), [](const Threaded& a, const Threaded& b) { return a.along < b.along; });
    return found;
}

// Of links whose middle is in a wall.
double thread_in(const World& world, const SoftVessel& vessel) {
    const auto nodes = world.thread();
    double sum = 0;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
        if (!world.thread_state().is_cut(static_cast<int>(k)) &&
            tissue::is_in_wall(vessel.tissue.rest().tetrahedra, vessel.tissue.nodes(), (nodes[k] + nodes[k + 1]) / 2))
            sum += (nodes[k + 1] - nodes[k]).norm();
    return sum;
}

}  // namespace

WallWatch::WallWatch(const World& world) : contact_({}, thinnest(world)), forces_(world.vessels().size()) {
    for (const SoftVessel& vessel : world.vessels()) {
        auto& volumes = volumes_.emplace_back();
        for (const auto& tet : vessel.tissue.rest().tetrahedra)
            volumes.push_back(tissue::volume(tet, vessel.tissue.rest().nodes));
    }
}

void WallWatch::look(const World& world, Frame& frame) {
    const auto vessels = world.vessels();
    for (std::size_t v = 0; v < vessels.size(); ++v) {
        frame.smallest_tetrahedron = std::min(frame.smallest_tetrahedron, smallest_share(vessels[v], volumes_[v]));
        frame.off_rest.push_back(off_rest(vessels[v]));
    }
    if (!world.needles().empty()) {
        const auto& needle = world.needle_in_use();
        frame.needle_tip = needle.now.tip();
        frame.off_needle = (world.thread()[static_cast<std::size_t>(needle.node)] - needle.now.tail()).norm();
    }
    constexpr int every = 10;
    if (looks_++ % every != every - 1) return;
    for (auto& forces : forces_) forces.clear();
    for (std::size_t a = 0; a < vessels.size(); ++a) {
        const tissue::Mesh& rest = vessels[a].tissue.rest();
        contact_.press(rest, vessels[a].skin, forces_[a], vessels[a].carried);
        frame.wall_contacts += contact_.contacts();
        for (std::size_t b = a + 1; b < vessels.size(); ++b) {
            contact_.press(rest, vessels[a].skin, forces_[a], vessels[b].tissue.rest(), vessels[b].skin, forces_[b]);
            frame.wall_contacts += contact_.contacts();
        }
    }
    frame.threaded = threaded(world);
}

void WallWatch::conclude(const World& world, Trace& trace) const {
    trace.events.assign(world.events().begin(), world.events().end());
    trace.threaded = threaded(world);
    for (const SoftVessel& vessel : world.vessels()) {
        trace.bites.insert(trace.bites.end(), vessel.bites.bites().begin(), vessel.bites.bites().end());
        trace.in_walls += thread_in(world, vessel);
    }
}

}  // namespace bench::lab
