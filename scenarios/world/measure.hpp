#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/knot/namer.hpp"

namespace scenarios::world {

/// A number and the moment it was reached.
struct Moment {
    double value = 0;  ///< In the unit that its name says.
    double at_s = 0;   ///< When [s].
};

/// One passage of the needle through a wall.
struct BiteMeasure {
    std::string vessel;    ///< Its name.
    std::string from, to;  ///< Sides: "outer", "inner", "cut", "far end"; `to` is empty where it did not come through.
    double size_mm = 0;    ///< From its end on the outer side to the cut, at rest; 0: it has no end there.
    double depth_mm = 0;   ///< How deep the wire went below the skin, at the deepest.
    double to_wall_deg = 0;   ///< Between needle and wall where the needle first touched it, 0 to 90.
    bool partial = false;     ///< It does not go from outside to the lumen or back.
    bool both_walls = false;  ///< One pass took this wall and the one across the lumen.
    bool torn = false;        ///< It is torn out to the cut.
    bool withdrawn = false;   ///< The needle left the way it came.
    bool on_needle = false;   ///< The needle is not drawn through yet: no thread lies in it.
    bool is_empty = false;    ///< Its thread was drawn out of it.
    bool caved_in =
        false;        ///< The wall gave way so far that the needle was through with less force than piercing takes.
    double at_s = 0;  ///< When the needle was through, or last did anything to it [s].
};

/// One of the ten lapses (tissue/lapse.hpp).
struct LapseMeasure {
    std::string name;        ///< Of the lapse.
    std::string measure;     ///< What was measured, with its unit.
    double value = 0;        ///< Of that measure.
    double limit = 0;        ///< Beyond it the lapse is committed.
    bool at_least = false;   ///< The limit is from below.
    bool committed = false;  ///< The limit is not kept.
};

/// A piece of thread with a knot in it.
struct TieMeasure {
    sim::knot::Name knot;         ///< Its name.
    std::vector<double> tail_mm;  ///< Two: from the knot to the first and to the last node of the piece.
};

/// Of two vessels whose ends were sewn (tissue/join.hpp).
struct JoinMeasure {
    double gap_mm = 0;                 ///< Widest along the suture line.
    double lumen_ratio = 1;            ///< Narrowest section of the lumen over that at rest.
    double leak_ml_min = 0;            ///< At 100 mmHg.
    std::vector<LapseMeasure> lapses;  ///< Ten; none where nothing was sewn.
};

/// Where a knot is and how it lies.
struct KnotPlace {
    /// Two: from the knot to the first and to the last node of its piece; 0 and 0 where there is no knot.
    std::vector<double> tail_mm;
    double loop_mm = 0;               ///< Thread in the loop between the knot's two strands.
    double knot_mm = 0;               ///< Thread in those strands: the less, the tighter.
    double off_tissue_mm = -1;        ///< From the knot to the tube it goes round; -1 where it goes round none.
    std::vector<std::string> around;  ///< Names of the vessels that the knot's loop goes round.
};

/// What was sewn.
struct Sewing {
    std::vector<BiteMeasure> bites;  ///< Vessel by vessel, in the order they were made.
    std::string slipped;             ///< The vessel that the needle slipped off first; empty: none.
    double slipped_s = 0;            ///< When it slipped off [s].
    JoinMeasure join;                ///< Of two ends.
};

/// What has been measured of a session so far; what judge() finds at its end as well, once that has been called.
struct Measures : KnotPlace, Sewing {
    sim::knot::Name knot;          ///< The thread's knot now, its own; a hitch is of the thread round a vessel.
    int hitched_to = -1;           ///< Index of the vessel that the thread is hitched to; none: -1.
    int piece = 0;                 ///< Of a thread that was cut, which piece is tied most: it has that knot and hitch.
    double knot_since_s = 0;       ///< When the knot took this name [s].
    std::vector<TieMeasure> ties;  ///< At the end: each piece of thread that has a knot.
    std::optional<Moment> needle_deg;  ///< Least angle between jaws and wire of all grasps of a needle; 90 is right.
    double duration_s = 0;             ///< How long the session has taken [s].
    std::vector<double> path_mm;       ///< For each instrument, how far its tip has gone.
    std::vector<int> grasps;           ///< For each instrument, how often it took hold of a strand.
    Moment tension_max_N;              ///< Largest tension of the thread [N].
    /// For each instrument, how far it was behind its hand at most while it held thread and nothing else stopped it, a
    /// turn taken at its jaws' length [mm].
    std::vector<Moment> lag_max_mm;
    std::uint64_t pass_throughs = 0;  ///< How often thread passed through anything.
    double first_pass_through_s = 0;  ///< When it first did [s].
    std::optional<double> broke_s;    ///< When the thread first broke [s]; none: it did not.
    int walls_crossed = 0;            ///< How often a tool was led through a wall that gave way.
    double first_crossed_s = 0;       ///< When one first was [s].
};

}  // namespace scenarios::world
