#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/thread/thread.hpp"
#include "tests/bench/lab/row.hpp"

// A hard case: a scene in which simulators of thread fail, what would go wrong for a user if ours did, and conditions
// that tell. Scenes are files (tests/hard_cases/*.json), shared by tests, `carrel bench stability` and the viewer.
namespace bench::lab {

using sim::geometry::Capsule;
using sim::geometry::Vec3;

/// How far something has gone and turned at one time.
struct WayKey {
    double t = 0;            ///< [s]
    Vec3 by = Vec3::Zero();  ///< [m]
    double turn = 0;         ///< [rad] about Way::axis.
};

/// Linear between its keys, still before and after them.
struct Way {
    std::vector<WayKey> keys;  ///< Times ascend; none: it stands still.
    Vec3 axis = Vec3::UnitX();

    WayKey at(double t) const;
};

/// Nodes that a tool grasps, carries as one rigid piece, and releases.
struct HoldPlan {
    std::vector<int> nodes;
    int tool = -1;
    double from = 0, to = 0;                       ///< [s]
    double chatter_period = 0, chatter_phase = 0;  ///< [s] Held only in the first half of each period, if there is one.
    Way way;                                       ///< Counted from where the nodes are when grasped.

    bool held_at(double t) const;
};

/// A part of a tool: a capsule and its way from where it starts.
struct ToolPlan {
    int tool = 0;
    Capsule capsule;
    Way way;
};

/// The thread cut before a tick.
struct CutPlan {
    double t = 0;      ///< [s]
    double place = 0;  ///< Along it, as it is then [m].
};

/// Input that is not what it should be, for a while.
struct Fault {
    enum class Kind { nan, infinite, zero_rotation, long_rotation, flipped_rotation, frozen, leap, sampled };
    Kind kind = Kind::nan;
    std::string input;        ///< "holds", "tools", or an instrument of a drill.
    double from = 0, to = 0;  ///< [s]
    Vec3 by = Vec3::Zero();   ///< Of a leap [m].
    double hz = 0;            ///< Of what is sampled.
};

/// One scene, ready to be played.
struct Scene {
    sim::thread::ThreadDef thread;
    std::vector<Vec3> nodes;  ///< [m]
    std::vector<HoldPlan> holds;
    std::vector<ToolPlan> tools;
    std::vector<sim::geometry::Triangle> surface;
    std::vector<Fault> faults;
    std::vector<CutPlan> cuts;  ///< Those of one tick from the last place to the first.
    double break_force = std::numeric_limits<double>::infinity();  ///< [N]
    double tick = 1e-3, duration = 0;                              ///< [s]
    std::filesystem::path drill;  ///< If set, the scene is this drill moved by its own motion ...
    std::string model;            ///< ... with this thread instead of its own, unless empty.
};

/// What is measured and what it must be.
struct Condition {
    std::string is;  ///< One of condition_kinds().
    Must must = Must::be_at_most;
    double bound = 0;
    double from = 0;                                      ///< Measured from here [s] ...
    double to = std::numeric_limits<double>::infinity();  ///< ... to here.
    int node = -1;                                        ///< Of which node; -1: the one that shows most.
    int tool = 0;
    int vessel = -1;              ///< Of which; -1: the one that shows most.
    double factor = 1;            ///< Of what is scaled.
    std::string knot;             ///< The name it must have.
    std::string event;            ///< The kind that is counted.
    std::string model;            ///< Asked only of variants with this thread; empty: of all.
    std::string known;            ///< Not empty: misses its bound today, for this reason ...
    std::optional<double> today;  ///< ... and keeps this one meanwhile.
};

struct HardCase {
    std::string id, goes_wrong, why;
    std::vector<std::string> cases;  ///< "E4", "T20", as numbered in docs/stability.md.
    std::vector<Scene> scenes;       ///< At least one; the others are its variants.
    std::vector<Condition> conditions;
};

/// Reads a scene file. Throws scenarios::drill::FileError "file:line:column: error: /json/pointer: what, what would be
/// right", or InputFault for a curve or drill that it names.
HardCase load_hard_case(const std::filesystem::path& file);
HardCase parse_hard_case(const std::string& text, const std::filesystem::path& file);

/// The scene files of a folder, in order of name.
std::vector<std::filesystem::path> hard_case_files(const std::filesystem::path& folder);

/// A condition and the worst of it over all variants.
struct Outcome {
    Condition condition;
    double value = 0, seconds = 0;
    bool measured = false;

    bool holds() const { return keeps(condition.bound); }
    bool keeps(double bound) const { return condition.must == Must::be_at_most ? value <= bound : value >= bound; }
};

/// Whether a condition is asked of this variant.
bool is_asked_of(const Scene& scene, const Condition& condition);

/// Plays every variant (only the first if `quick`) and measures every condition that is asked of any of them.
std::vector<Outcome> examine(const HardCase& hard_case, bool quick = false);

}  // namespace bench::lab
