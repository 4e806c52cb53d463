#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/knot/namer.hpp"

namespace scenarios::world {

/// A number and the moment it was reached.
struct Moment {
    double value = 0;
    double at_s = 0;
};

/// One way of the needle through a wall.
struct BiteMeasure {
    std::string vessel, from, to;  ///< Sides: "outer", "inner", "cut", "far end"; `to` empty: it did not come through.
    double size_mm = 0;            ///< From its end on the outer side to the cut, at rest; 0: none is there.
    double depth_mm = 0,
           to_wall_deg = 0;  ///< Of the wire, at the deepest; between needle and wall where it was first touched.
    bool partial = false, both_walls = false, torn = false, withdrawn = false;
    bool on_needle = false;  ///< Not drawn through yet: no thread lies in it.
    bool is_empty = false;   ///< Its thread was drawn out of it.
    bool caved_in =
        false;        ///< The wall gave way so far that the needle was through with less force than piercing takes.
    double at_s = 0;  ///< When the needle was through, or last did anything to it.
};

/// One of the ten lapses (tissue/lapse.hpp).
struct LapseMeasure {
    std::string name, measure;
    double value = 0, limit = 0;
    bool at_least = false, committed = false;  ///< The limit is from below; it is not kept.
};

/// A piece of thread with a knot in it.
struct TieMeasure {
    sim::knot::Name knot;
    std::vector<double> tail_mm;  ///< Two: from the knot to the first and to the last node of the piece.
};

/// Of two vessels whose ends were sewn (tissue/join.hpp).
struct JoinMeasure {
    double gap_mm = 0;                        ///< Widest along the suture line.
    double lumen_ratio = 1, leak_ml_min = 0;  ///< At 100 mmHg.
    std::vector<LapseMeasure> lapses;         ///< Empty: nothing was sewn.
};

/// What has been measured of the session so far. One entry per instrument where it says so.
struct Measures {
    sim::knot::Name knot;  ///< Now, of the thread alone; a hitch, of the thread round a vessel.
    int hitched_to = -1;   ///< That vessel.
    int piece = 0;  ///< Of a thread that was cut, the most tied; its knot and hitch are those above, its tails below.
    double knot_since_s = 0;  ///< When it took this name.
    std::vector<double>
        tail_mm;                ///< Two: from the knot to the first and to the last node of its piece; 0,0 if no knot.
    double loop_mm = 0;         ///< Thread in the loop between the knot's two strands.
    double knot_mm = 0;         ///< Thread in those strands: the less, the tighter.
    double off_tissue_mm = -1;  ///< From the knot to the tube it goes round; -1 where it goes round none.
    std::vector<std::string> around;  ///< Vessels that the knot's loop goes round.
    std::vector<TieMeasure> ties;     ///< At the end, piece by piece of the thread.
    std::optional<Moment>
        needle_deg;  ///< Least angle between jaws and wire of all grasps of a needle, 90 is right; none: never held.
    std::vector<BiteMeasure> bites;  ///< At the end, vessel by vessel.
    std::string slipped;             ///< At the end, the vessel that the needle slipped off first; empty: none,
    double slipped_s = 0;            ///< and when.
    JoinMeasure join;
    double duration_s = 0;
    std::vector<double> path_mm;  ///< Per instrument, commanded path of the tip.
    std::vector<int> grasps;      ///< Per instrument.
    Moment tension_max_N;
    std::vector<Moment> lag_max_mm;  ///< Per instrument that holds thread and that nothing else stops: commanded
                                     ///< against simulated tip, turns at a jaw's length.
    std::uint64_t pass_throughs = 0;
    double first_pass_through_s = 0;
    std::optional<double> broke_s;  ///< When the thread first broke.
};

}  // namespace scenarios::world
