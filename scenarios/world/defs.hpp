#pragma once
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "instruments/tool.hpp"
#include "sim/geometry/arc.hpp"

// What a scene is made of, as plain values in SI. scenarios/drill fills these from a file; tests fill them by hand.
namespace scenarios::world {

using sim::geometry::Vec3;

struct ThreadDef {
    std::string size = "6-0";  ///< USP.
    std::string material = "polypropylene";
    std::string model = "ftl";     ///< What moves it: "ftl" or "elastic".
    double diameter = 0.085e-3;    ///< [m] middle of the USP range of 6-0.
    double length = 0.150;         ///< [m]
    double young_modulus = 2.8e9;  ///< [Pa] along the thread,
    double bending_share = 1;      ///< and what of it counts in bending.
    double density = 905;          ///< [kg/m^3]
    double yield_strain = 0;       ///< Beyond it an elastic thread stays as it is bent; 0: never.
    bool weighs = false;           ///< An elastic thread has weight, towards -z;
    bool stretches = true;         ///< stretches by its material, or else by next to nothing;
    bool swings = true;            ///< has mass, or else is in balance in every tick;
    bool is_in_air = false;        ///< is halted by it, or else what nobody holds flies on.
    double break_force = 1.96;     ///< [N] USP minimum average knot-pull.
    double friction = 0.15;        ///< Coulomb, thread on thread and on vessel.
    double friction_tool = 0.15;   ///< Coulomb, thread on the smooth outside of a tool.
    int links = 300;
    double shortest_link = 0;   ///< [m] that links are halved to where they bend or touch; 0: they stay as they are.
    int contacts_per_tick = 0;  ///< As sim::thread::ThreadDef.
    std::vector<Vec3> start;    ///< Path of the thread at t = 0 [m]; resampled to equal links from its first point.
};

struct VesselDef {
    std::string name = "vessel";
    double diameter = 4e-3, wall = 0.6e-3, length = 30e-3;  ///< Tube by numbers [m]; outer diameter.
    Vec3 centre = Vec3::Zero(), axis = Vec3::UnitX();
    double cut_angle = 90;  ///< Of ends that are not held [degrees], 45 to 90.
    bool start_held = true, end_held = true;
    int held_by = -1;              ///< Number of the approximator whose clamps hold them; -1: they stay where they are.
    bool is_soft = false;          ///< Its wall gives way, with
    double young_modulus = 0.1e6;  ///< [Pa], and
    double puncture_force = 0.05;  ///< a needle's tip goes through at this [N].
    std::vector<std::array<Vec3, 2>> bitten;  ///< From, to [m]: straight ways of a needle through its walls before the
                                              ///< scene, in which thread may lie.
    std::string mesh_file;                    ///< If set, read instead of the numbers (mm in the file).
    std::vector<Vec3>
        outside;  ///< Of a wall that gives way and is no tube, from that file: vertices in the world [m] ...
    std::vector<std::array<int, 3>> triangles;  ///< ... and triangles, of which tissue::make_wall() makes a wall.
    bool needs_cut = false;                     ///< Bites or a join are measured from its cut.
};

struct InstrumentDef {
    std::string name;  ///< "left", "right", ... as in motion files.
    instruments::Kind kind = instruments::Kind::forceps;
    double pull = std::numeric_limits<double>::infinity();  ///< It gives way to elastic thread that pulls at it harder
                                                            ///< [N]: a hand feels that.
};

/// Another thread of the same kind, with a needle of its own.
struct SpareDef {
    sim::geometry::Arc needle;  ///< Where it is at t = 0;
    std::vector<Vec3> start;    ///< as ThreadDef::start.
};

struct WorldDef {
    ThreadDef thread;
    std::string needle_code;       ///< Of the needle that the thread's first node is swaged to; empty: none.
    sim::geometry::Arc needle;     ///< Where it is at t = 0; the thread starts at its tail.
    std::vector<SpareDef> spares;  ///< They lie ready, for when the first is used up; of a thread with a needle.
    std::vector<VesselDef> vessels;
    std::vector<InstrumentDef> instruments;
    double tick_s = 1e-3;
};

/// In which air halts a loose thread [s]: density * radius^2 * 4.4 / (4 viscosity), where 4.4 is the logarithm in the
/// drag of a slender body (Lamb) at some 20 mm/s; 0.10 s of 6-0, 0.01 s of 10-0.
inline double halting_time(const ThreadDef& def) {
    constexpr double viscosity = 1.8e-5, slender = 4.4;  // [Pa s]
    return slender * def.density * def.diameter * def.diameter / (16 * viscosity);
}

/// Length of a thread's first link [m]: of a link, halved until its far node, straight behind a needle's tail, is off
/// the needle's circle by half the thread's radius at most; what a needle leads comes through the hole that it made.
inline double first_link(const WorldDef& def) {
    double link = def.thread.length / def.thread.links;
    while (!def.needle_code.empty() && link * link > def.needle.radius * def.thread.diameter / 2) link /= 2;
    return link;
}

}  // namespace scenarios::world
