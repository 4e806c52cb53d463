#include "scenarios/world/locate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "scenarios/world/world.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/knot/form.hpp"

namespace scenarios::world {

namespace {

// Where a knot is: the shortest stretch of the thread that still holds the whole knot, cut shorter from either end.
struct Place {
    std::size_t first, last;  ///< Nodes.
};

Place place_of(const std::vector<Vec3>& nodes, const std::string& knot) {
    const auto still_knotted = [&](std::size_t first, std::size_t last) {
        return sim::knot::name_knot(std::vector<Vec3>(nodes.begin() + static_cast<std::ptrdiff_t>(first),
                                                      nodes.begin() + static_cast<std::ptrdiff_t>(last) + 1))
                   .knot == knot;
    };
    Place place{0, nodes.size() - 1};
    for (std::size_t step = nodes.size() / 2; step > 0; step /= 2) {
        while (place.first + step + 1 < place.last && still_knotted(place.first + step, place.last))
            place.first += step;
        while (place.last > place.first + step + 1 && still_knotted(place.first, place.last - step)) place.last -= step;
    }
    return place;
}

double length_mm(std::span<const double> rest, std::size_t first, std::size_t last) {
    double length = 0;
    for (std::size_t k = first; k < last; ++k) length += rest[k];
    return 1e3 * length;
}

// How far a point is off a tube's surface [m].
double off_surface(const VesselDef& tube, const Vec3& p) {
    const Vec3 half = 0.5 * tube.length * tube.axis.normalized();
    return std::sqrt(sim::geometry::closest_points(p, p, tube.centre - half, tube.centre + half).distance_squared) -
           0.5 * tube.diameter;
}

// How often the stretch [first, last] of a curve goes round a vessel: its signed passages through the half plane that
// hangs from the vessel's axis, once round is 1 or -1.
int turns_around(const VesselDef& vessel, const std::vector<Vec3>& curve, std::size_t first, std::size_t last) {
    const Vec3 axis = vessel.axis.normalized();
    const Vec3 across = axis.cross(std::abs(axis.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX()).normalized();
    const Vec3 up = across.cross(axis);
    int turns = 0;
    for (std::size_t i = first; i < last; ++i) {
        const Vec3 a = curve[i] - vessel.centre, b = curve[i + 1] - vessel.centre;
        const double ya = a.dot(across), yb = b.dot(across);
        if ((ya < 0) == (yb < 0)) continue;
        const double height = a.dot(up) + ya / (ya - yb) * (b - a).dot(up);
        if (height < 0) turns += yb > ya ? 1 : -1;
    }
    return turns;
}

// Tails are what lies before the thread comes to the vessel and after it has left it.
std::vector<double> tails_of_hitch(const World& world, const VesselDef& vessel, const sim::thread::Piece& piece) {
    const std::vector<Vec3> nodes = world.curve_of(piece);
    const auto rest = world.rest_of(piece);
    const auto near = [&](const Vec3& p) { return off_surface(vessel, p) < 2 * world.def().thread.diameter; };
    const auto first = std::find_if(nodes.begin(), nodes.end(), near);
    if (first == nodes.end()) return {0, 0};
    const auto last = std::find_if(nodes.rbegin(), nodes.rend(), near);
    return {length_mm(rest, 0, static_cast<std::size_t>(first - nodes.begin())),
            length_mm(rest, static_cast<std::size_t>(nodes.rend() - last) - 1, nodes.size() - 1)};
}

// How far the knot's own strands, between nodes `first` and `last`, are off a tube [mm].
double off_tissue_mm(const VesselDef& tube, const std::vector<Vec3>& curve, const Place& place,
                     const sim::knot::Extent& extent, double diameter) {
    double along = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t i = place.first; i <= place.last; ++i) {
        if (i > place.first) along += (curve[i] - curve[i - 1]).norm();
        if (extent.holds(along)) least = std::min(least, off_surface(tube, curve[i]));
    }
    return 1e3 * std::max(0.0, least - 0.5 * diameter);
}

void measure_knot(const WorldDef& def, const std::vector<Vec3>& curve, const Place& place, KnotPlace& found) {
    const auto from = curve.begin() + static_cast<std::ptrdiff_t>(place.first),
               to = curve.begin() + static_cast<std::ptrdiff_t>(place.last) + 1;
    const sim::knot::Extent extent = sim::knot::extent({from, to});
    found.loop_mm = 1e3 * extent.loop();
    found.knot_mm = 1e3 * extent.knot();
    for (const VesselDef& vessel : def.vessels) {
        if (turns_around(vessel, curve, place.first, place.last) == 0) continue;
        found.around.push_back(vessel.name);
        if (vessel.mesh_file.empty())
            found.off_tissue_mm = off_tissue_mm(vessel, curve, place, extent, def.thread.diameter);
    }
}

std::vector<double> tails_mm(std::span<const double> rest, const Place& place) {
    return {length_mm(rest, 0, place.first), length_mm(rest, place.last, rest.size())};
}

}  // namespace

std::vector<double> tails_of(const std::vector<Vec3>& curve, std::span<const double> rest, const std::string& knot) {
    assert(curve.size() == rest.size() + 1 && "a node at either end of each link");
    return tails_mm(rest, place_of(curve, knot));
}

KnotPlace locate_knot(const World& world) {
    KnotPlace found;
    found.tail_mm = {0, 0};
    const sim::thread::Piece piece = world.tied_piece();
    const Measures& measures = world.measures();
    if (measures.hitched_to >= 0) {
        const VesselDef& vessel = world.def().vessels[static_cast<std::size_t>(measures.hitched_to)];
        found.around.push_back(vessel.name);
        found.tail_mm = tails_of_hitch(world, vessel, piece);
    }
    if (measures.knot.factors.empty()) return found;
    const std::vector<Vec3> curve = world.curve_of(piece);
    const Place place = place_of(curve, measures.knot.knot);
    found.tail_mm = tails_mm(world.rest_of(piece), place);
    measure_knot(world.def(), curve, place, found);
    return found;
}

}  // namespace scenarios::world
