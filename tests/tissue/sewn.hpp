#pragma once
#include <cmath>
#include <numbers>
#include <string>

#include "tissue/join.hpp"
#include "tissue/lapse.hpp"
#include "tissue/tube.hpp"

// Vessels sewn by hand, to be judged.
namespace tissue::sewn {

using sim::geometry::Quat;

constexpr double pi = std::numbers::pi, degree = pi / 180, mm = 1e-3;
constexpr double diameter = 0.085 * mm, hole = 0.055 * mm;  // of 6-0 thread, and radius of what it runs in

inline Mesh turned_about(Mesh mesh) {
    for (Vec3& node : mesh.nodes) node = {-node.x(), -node.y(), node.z()};
    return mesh;
}

// Where a stitch goes through a wall: round the ring [degrees], how far from the cut [m].
struct Place {
    double angle, from_cut = 1 * mm;
};

// Two vessels of 4 mm end to end along x, vessel 0 where x < 0, and what was sewn by hand.
struct Operation {
    explicit Operation(const TubeDef& tube = {}) : def(tube) {}
    TubeDef def;
    std::array<Mesh, 2> rest{turned_about(make_tube(def)), make_tube(def)};
    std::array<Skin, 2> skin{Skin(rest[0]), Skin(rest[1])};
    std::array<std::vector<Bite>, 2> bites;
    struct Waypoint {
        int vessel, hole;  // no hole: -1
        Vec3 at = Vec3::Zero();
    };
    std::vector<std::vector<Waypoint>> led;

    // Counted from the middle of one of the tube's sixteen sides.
    Vec3 outwards(double angle) const {
        return {0, std::cos((angle + 11.25) * degree), std::sin((angle + 11.25) * degree)};
    }

    // On a side of a wall; in the cut halfway through.
    BiteEnd pierce(int vessel, const Place& place, Side side) {
        const auto v = static_cast<std::size_t>(vessel);
        const double radius = side == Side::outer   ? def.diameter / 2
                              : side == Side::inner ? def.diameter / 2 - def.wall
                                                    : (def.diameter - def.wall) / 2;
        const double along = (vessel == 0 ? -1 : 1) * (side == Side::cut ? 0 : place.from_cut);
        const Vec3 at = radius * outwards(place.angle) + along * Vec3::UnitX();
        const auto spot = skin[v].closest(at, at, 0.2 * mm);
        const Vec3 normal = skin[v].normal(spot.triangle);
        const int made = skin[v].pierce(skin[v].face(spot.triangle), spot.at, -normal, hole);
        EXPECT_EQ(skin[v].side_of_face(skin[v].face_of_hole(made)), side);
        return {made, skin[v].point_of_hole(made), side, 0};
    }
    Bite& bite(int vessel, const Place& place, Side entry, Side exit, int pass) {
        Bite made;
        made.state = BiteState::open;
        made.entry = pierce(vessel, place, entry), made.exit = pierce(vessel, place, exit);
        made.depth = def.wall, made.pass = pass, made.on_needle = false;
        auto& all = bites[static_cast<std::size_t>(vessel)];
        all.push_back(made);
        led.back().push_back({vessel, made.entry.hole}), led.back().push_back({vessel, made.exit.hole});
        return all.back();
    }
    void begin() { led.emplace_back(); }
    int next_pass() const { return static_cast<int>(led.size()); }
    // From outside through the first wall, and through the second one out.
    void stitch(const Place& first, const Place& second) {
        begin();
        bite(0, first, Side::outer, Side::inner, next_pass());
        bite(1, second, Side::inner, Side::outer, next_pass());
    }
    void stitches(int from = 0, double turned = 0) {
        for (int k = from; k < 8; ++k) stitch({45.0 * k}, {45.0 * k + turned});
    }

    template <class Moved>
    void move(const Moved& moved) {
        for (std::size_t v : {0, 1}) {
            std::vector<Vec3> nodes;
            for (const Vec3& p : rest[v].nodes) nodes.push_back(moved(static_cast<int>(v), p));
            skin[v].update(nodes);
        }
    }

    // Threads as they were led, through the holes' middles, with tails of two millimetres.
    std::vector<std::vector<Vec3>> threads() const {
        std::vector<std::vector<Vec3>> all;
        for (const auto& way : led) {
            std::vector<Vec3> line;
            for (const Waypoint& w : way)
                line.push_back(w.hole < 0 ? w.at : skin[static_cast<std::size_t>(w.vessel)].centre(w.hole));
            const auto tail = [&](const Vec3& from) {
                return Vec3(from + 2 * mm * Vec3(0, from.y(), from.z()).normalized());
            };
            line.insert(line.begin(), tail(line.front())), line.push_back(tail(line.back()));
            all.push_back(line);
        }
        return all;
    }
    SewnVessel vessel(std::size_t v) const { return {rest[v], skin[v], bites[v], Vec3::UnitX()}; }
    Join judge() const { return tissue::judge(vessel(0), vessel(1), threads(), diameter); }
};

// Which of the ten.
inline std::string committed(const Join& join, const LapseLimits& limits = {}) {
    std::string names;
    for (const Lapse& lapse : lapses(join, limits)) {
        if (lapse.committed) names += std::string(names.empty() ? "" : ", ") + lapse.name;
    }
    return names;
}

}  // namespace tissue::sewn
