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

/// A thread and how it is moved.
struct ThreadDef {
    std::string size = "6-0";                ///< USP size; a word for reports.
    std::string material = "polypropylene";  ///< A word for reports.
    std::string model = "ftl";               ///< What moves it: "ftl" or "elastic".
    double diameter = 0.085e-3;              ///< The middle of the USP range of 6-0 [m].
    double length = 0.150;                   ///< [m]
    double young_modulus = 2.8e9;            ///< Young's modulus along the thread [Pa].
    double bending_share = 1;                ///< How much of that modulus counts in bending, 0 to 1.
    double density = 905;                    ///< [kg/m^3]
    double yield_strain = 0;                 ///< Beyond it an elastic thread stays as it is bent; 0: never.
    bool weighs = false;                     ///< An elastic thread has weight, towards -z.
    bool stretches = true;                   ///< An elastic thread stretches by its material, else by next to nothing.
    bool swings = true;                      ///< An elastic thread has mass, else it is in balance in every tick.
    bool is_in_air = false;                  ///< Air halts an elastic thread, else what nobody holds flies on.
    double break_force = 1.96;               ///< The USP minimum average knot-pull of 6-0 [N].
    double friction = 0.15;                  ///< Coulomb coefficient, thread on thread and on vessels.
    double friction_tool = 0.15;             ///< Coulomb coefficient, thread on the smooth outside of a tool.
    int links = 300;                         ///< How many equal pieces it starts with, at least 1.
    double shortest_link = 0;                ///< Links are halved to this where they bend or touch [m]; 0: never.
    int contacts_per_tick = 0;               ///< As sim::thread::ThreadDef::contacts_per_tick.
    std::vector<Vec3> start;                 ///< Path at t = 0 [m]; resampled to equal links from its first point.
};

/// A vessel: a tube by numbers, or a mesh from a file.
struct VesselDef {
    std::string name = "vessel";   ///< As events and reports call it.
    double diameter = 4e-3;        ///< Outer, of a tube [m].
    double wall = 0.6e-3;          ///< Thickness [m].
    double length = 30e-3;         ///< Of a tube [m].
    Vec3 centre = Vec3::Zero();    ///< Middle of the tube, or the mesh's origin, in the world [m].
    Vec3 axis = Vec3::UnitX();     ///< Along the tube, from its start to its end; not zero.
    double cut_angle = 90;         ///< Of ends that are not held [degrees], 45 to 90.
    bool start_held = true;        ///< Its first end is clamped.
    bool end_held = true;          ///< Its last end is clamped.
    int held_by = -1;              ///< Number of the approximator whose clamps hold its ends; -1: they stay put.
    bool is_soft = false;          ///< Its wall gives way.
    double young_modulus = 0.1e6;  ///< Of a wall that gives way [Pa].
    double puncture_force = 0.05;  ///< A needle's tip goes through a wall that gives way at this [N].
    /// Straight passages of a needle through its walls before the scene begins, in which thread may lie: from, to [m].
    std::vector<std::array<Vec3, 2>> bitten;
    std::string mesh_file;      ///< If set, read instead of the tube's numbers (mm in the file).
    std::vector<Vec3> outside;  ///< Vertices from that file, of a wall that gives way, in the world [m].
    std::vector<std::array<int, 3>> triangles;  ///< Of `outside`; tissue::make_wall() makes a wall of them.
    bool needs_cut = false;                     ///< Bites or a join are measured from its cut.
};

/// An instrument and the hand that leads it.
struct InstrumentDef {
    std::string name;                                     ///< "left", "right", ... as in motion files.
    instruments::Kind kind = instruments::Kind::forceps;  ///< What it is.
    /// It gives way to elastic thread that pulls at it harder than this [N], as a hand does that feels it.
    double pull = std::numeric_limits<double>::infinity();
};

/// Another thread of the same kind, with a needle of its own.
struct SpareDef {
    sim::geometry::Arc needle;  ///< Where it is at t = 0; the thread starts at its tail.
    std::vector<Vec3> start;    ///< As ThreadDef::start.
};

/// A scene.
struct WorldDef {
    ThreadDef thread;                        ///< The thread that is used first.
    std::string needle_code;                 ///< Of the needle that its first node is swaged to; empty: none.
    sim::geometry::Arc needle;               ///< Where that needle is at t = 0; the thread starts at its tail.
    std::vector<SpareDef> spares;            ///< Lie ready for when the first is used up; only with a needle.
    std::vector<VesselDef> vessels;          ///< Any number.
    std::vector<InstrumentDef> instruments;  ///< Any number.
    double tick_s = 1e-3;                    ///< How long a tick is [s].
};

/// Time in which air halts a loose thread [s]: density * radius^2 * 4.4 / (4 viscosity), where 4.4 is the logarithm in
/// the drag of a slender body (Lamb) at some 20 mm/s; 0.10 s for 6-0, 0.01 s for 10-0.
inline double halting_time(const ThreadDef& def) {
    constexpr double viscosity = 1.8e-5, slender = 4.4;  // [Pa s]
    return slender * def.density * def.diameter * def.diameter / (16 * viscosity);
}

/// Length of a thread's first link [m]: that of the others, halved until its far node, straight behind a needle's tail,
/// is off the needle's circle by half the thread's radius at most, so that it comes through the hole that the needle
/// made.
inline double first_link(const WorldDef& def) {
    double link = def.thread.length / def.thread.links;
    while (!def.needle_code.empty() && link * link > def.needle.radius * def.thread.diameter / 2) link /= 2;
    return link;
}

}  // namespace scenarios::world
