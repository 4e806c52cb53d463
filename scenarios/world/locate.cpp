#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/world/world.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/knot/form.hpp"

namespace scenarios::world {

namespace {

// Shortest stretch of the thread, grown from whichever end, that still holds the whole knot: where the knot is.
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

// From a point to a tube's surface [m].
double off_surface(const VesselDef& tube, const Vec3& p) {
    const Vec3 half = 0.5 * tube.length * tube.axis.normalized();
    return std::sqrt(sim::geometry::closest_points(p, p, tube.centre - half, tube.centre + half).distance_squared) -
           0.5 * tube.diameter;
}

}  // namespace

// Its name may be of a moment ago, when there were fewer pieces.
sim::thread::Piece World::tied_piece() const {
    const auto pieces = thread_.pieces();
    return pieces[std::min(static_cast<std::size_t>(measures_.piece), pieces.size() - 1)];
}

std::vector<Vec3> World::curve_of(const sim::thread::Piece& piece) const {
    return {thread_.nodes().begin() + piece.first, thread_.nodes().begin() + piece.last + 1};
}

std::span<const double> World::rest_of(const sim::thread::Piece& piece) const {
    return thread_.rest_lengths().subspan(static_cast<std::size_t>(piece.first),
                                          static_cast<std::size_t>(piece.last - piece.first));
}

static std::vector<double> tails_mm(std::span<const double> rest, const Place& place) {
    return {length_mm(rest, 0, place.first), length_mm(rest, place.last, rest.size())};
}

void World::judge_ties() {
    measures_.ties.clear();
    for (const sim::thread::Piece& piece : thread_.pieces()) {
        const std::vector<Vec3> curve = curve_of(piece);
        sim::knot::Name knot = sim::knot::name_knot(curve);
        if (knot.factors.empty()) continue;
        const Place place = place_of(curve, knot.knot);
        measures_.ties.push_back({std::move(knot), tails_mm(rest_of(piece), place)});
    }
}

void World::locate_knot() {
    measures_.tail_mm = {0, 0};
    measures_.loop_mm = measures_.knot_mm = 0;
    measures_.off_tissue_mm = -1;
    measures_.around.clear();
    const sim::thread::Piece piece = tied_piece();
    if (measures_.hitched_to >= 0) locate_hitch(def_.vessels[static_cast<std::size_t>(measures_.hitched_to)], piece);
    if (measures_.knot.factors.empty()) return;
    const std::vector<Vec3> curve = curve_of(piece);
    const Place place = place_of(curve, measures_.knot.knot);
    measures_.tail_mm = tails_mm(rest_of(piece), place);
    measure_knot(curve, place.first, place.last);
}

// Tails are what lies before the thread comes to the vessel and after it has left it.
void World::locate_hitch(const VesselDef& vessel, const sim::thread::Piece& piece) {
    measures_.around.push_back(vessel.name);
    const std::vector<Vec3> nodes = curve_of(piece);
    const auto rest = rest_of(piece);
    const auto near = [&](const Vec3& p) { return off_surface(vessel, p) < 2 * def_.thread.diameter; };
    const auto first = std::find_if(nodes.begin(), nodes.end(), near);
    if (first == nodes.end()) return;
    const auto last = std::find_if(nodes.rbegin(), nodes.rend(), near);
    measures_.tail_mm = {length_mm(rest, 0, static_cast<std::size_t>(first - nodes.begin())),
                         length_mm(rest, static_cast<std::size_t>(nodes.rend() - last) - 1, nodes.size() - 1)};
}

void World::measure_knot(const std::vector<Vec3>& curve, std::size_t first, std::size_t last) {
    const auto from = curve.begin() + static_cast<std::ptrdiff_t>(first),
               to = curve.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    const sim::knot::Extent extent = sim::knot::extent({from, to});
    measures_.loop_mm = 1e3 * extent.loop();
    measures_.knot_mm = 1e3 * extent.knot();
    for (const VesselDef& vessel : def_.vessels) {
        if (turns_around(vessel, curve, first, last) == 0) continue;
        measures_.around.push_back(vessel.name);
        if (!vessel.mesh_file.empty()) continue;
        double along = 0, least = std::numeric_limits<double>::infinity();
        for (std::size_t i = first; i <= last; ++i) {
            if (i > first) along += (curve[i] - curve[i - 1]).norm();
            if (extent.holds(along)) least = std::min(least, off_surface(vessel, curve[i]));
        }
        measures_.off_tissue_mm = 1e3 * std::max(0.0, least - 0.5 * def_.thread.diameter);
    }
}

// Signed passages of the stretch [first, last] through the half plane that hangs from the vessel's axis: once round is
// +-1.
int World::turns_around(const VesselDef& vessel, const std::vector<Vec3>& curve, std::size_t first, std::size_t last) {
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

}  // namespace scenarios::world
