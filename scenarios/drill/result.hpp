#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/world/defs.hpp"
#include "scenarios/world/event.hpp"

// What a played drill came to: what result.json, report.html and a recording's score table are written from.
namespace scenarios::drill {

/// One scored item. No item is added to another: each stands with its band and its moment.
struct ScoreItem {
    std::string name;     ///< "knot", "throws", "tail_short", "time", "path_left" ...
    std::string title;    ///< For people: "Knot", "Path length, left tool".
    std::string value;    ///< As shown, without unit: "square", "12.4".
    std::string unit;     ///< "mm", "s", "N", "".
    std::string band;     ///< As shown: "square", "3 to 8", "at most 120"; empty: measured, not judged.
    bool passed = false;  ///< Whether the value is within its band; without a band it is.
    double at_s = 0;      ///< When it was decided or reached its value [s].
    std::string why;      ///< If failed: one sentence for the resident. Of a lapse, its number and limit. Else empty.
    std::optional<double> number =
        {};  ///< The value with all its digits, where it is one number. Of a lapse, of `why`.

    bool operator==(const ScoreItem&) const = default;
};

/// State of the scene every 10 ms of simulated time, for the timeline.
struct Sample {
    double t_s;                           ///< Simulated time [s].
    double tension_N;                     ///< Largest estimate along the thread [N].
    std::vector<double> tool_speed_mm_s;  ///< Commanded speed [mm/s], one per instrument.
    std::vector<double> tool_lag_mm;      ///< Lag [mm], one per instrument; a turn counts at a jaw's length.
    /// What each instrument has in its jaws: "thread", "needle", "wall", several of them with " and " between, or "".
    std::vector<std::string> held;
    std::string knot;  ///< What the thread was called then: "0_1", "overhand", ...
};

/// What half, 99 of 100 and all of some figures stay below.
struct Percentiles {
    double p50 = 0, p99 = 0, max = 0;  ///< In the unit of the figures.
};

/// Who plays a session, and under which rules.
struct Circumstances {
    std::string who = {};           ///< A pseudonym; empty: nobody says.
    std::string device = {};        ///< "mouse and keys", "motion file" ...
    std::string assists = {};       ///< Assists that are on as it begins, with blanks between; marks say what changes.
    bool exam = false;              ///< An exam: no help, no pause.
    double pace = 1;                ///< What the drill declares: simulated over wall time.
    std::string machine = {};       ///< The machine, in words.
    std::string parent = {};        ///< SHA-256 of the recording that it goes on from, or empty.
    std::uint64_t parent_tick = 0;  ///< From which of its ticks.

    bool operator==(const Circumstances&) const = default;
};

/// All that a played drill came to.
struct Result {
    std::string drill_title;               ///< As the drill file has it.
    std::vector<std::string> instruments;  ///< Names, in the drill's order.
    bool finished = true;              ///< False: of a recording that was broken off, as by a kill; it has not passed.
    bool passed = false;               ///< Whether every goal and every item with a band passed.
    std::vector<ScoreItem> items;      ///< In the order in which they are shown.
    std::vector<Sample> samples;       ///< In order of time.
    std::vector<world::Event> events;  ///< In the order in which they happened.
    double duration_s = 0;             ///< Simulated time that was played [s].
    int links = 0;                     ///< Links of the thread at the end.
    std::uint64_t ticks = 0, substeps = 0;        ///< How many were made.
    double stretch_max = 0, stretch_settled = 0;  ///< |l/l0 - 1| of the worst link: at any tick, at the end.
    double separation_min = 0;                    ///< Smallest distance of non-neighbour links over the diameter.
    double node_step_max_over_bound = 0;          ///< Largest move of a node in a substep over its bound; at most 1.
    std::uint64_t pass_throughs = 0;     ///< Pass-throughs that the audit found; 0 unless the solver is at fault.
    int contacts_max = 0;                ///< Most contacts at once.
    std::string knot, surgical, throws;  ///< The names at the end, as in sim::knot::Name: "3_1#m3_1", "square", "1=1".
    std::string state_hash;              ///< 16 hex digits, after the last tick.
    Percentiles tick_us;  ///< Processor time of a tick [us]; the only figures here that differ between runs.
    std::string machine;  ///< The machine that it was played on, in words; empty where nobody says.
    std::optional<Circumstances> session = {};  ///< Who played it, and how; none where nobody says.
    bool is_comparable = true;                  ///< Whether it went as fast as its drill declares.
};

}  // namespace scenarios::drill
