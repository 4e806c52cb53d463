#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/world/defs.hpp"
#include "scenarios/world/event.hpp"

// What a played drill came to: what result.json, report.html and a recording's score table are written from.
namespace scenarios::drill {

/// One scored item. No item is added to another: each stands with its band and its moment.
struct ScoreItem {
    std::string name;   ///< "knot", "throws", "tail_short", "time", "path_left" ...
    std::string title;  ///< For people: "Knot", "Path length, left tool".
    std::string value;  ///< As shown, without unit: "square", "12.4".
    std::string unit;   ///< "mm", "s", "N", "".
    std::string band;   ///< As shown: "square", "3 to 8", "at most 120"; empty: measured, not judged.
    bool passed = false;
    double at_s = 0;  ///< When it was decided or reached its value [s].
    std::string why;  ///< If failed: one sentence for the resident. Of a lapse, its number and limit. Else empty.

    bool operator==(const ScoreItem&) const = default;
};

/// State of the scene every 10 ms of simulated time, for the timeline.
struct Sample {
    double t_s;
    double tension_N;                     ///< Largest estimate along the thread.
    std::vector<double> tool_speed_mm_s;  ///< One per instrument, commanded.
    std::vector<double> tool_lag_mm;      ///< One per instrument; a turn counts at a jaw's length.
    std::vector<std::string> held;  ///< What each instrument has in its jaws: "thread", "needle", "wall", several of
                                    ///< them with " and " between, or "".
    std::string knot;               ///< What it was called then: "0_1", "overhand", ...
};

struct Percentiles {
    double p50 = 0, p99 = 0, max = 0;
};

struct Result {
    std::string drill_title;
    std::vector<std::string> instruments;  ///< Names in order.
    bool finished = true;  ///< False: of a recording that was broken off, as by a kill; it has not passed.
    bool passed = false;   ///< Every goal and every item with a band.
    std::vector<ScoreItem> items;
    std::vector<Sample> samples;
    std::vector<world::Event> events;
    double duration_s = 0;
    int links = 0;
    std::uint64_t ticks = 0, substeps = 0;
    double stretch_max = 0, stretch_settled = 0;  ///< |l/l0 - 1| of the worst link: at any tick, at the end.
    double separation_min = 0;                    ///< Smallest distance of non-neighbour links over the diameter.
    double node_step_max_over_bound = 0;
    std::uint64_t pass_throughs = 0;
    int contacts_max = 0;
    std::string knot, surgical, throws;  ///< "3_1#m3_1", "square", "1=1".
    std::string state_hash;              ///< 16 hex digits, after the last tick.
    Percentiles tick_us;                 ///< Processor time; the only figures here that differ between runs.
    std::string machine;
};

}  // namespace scenarios::drill
