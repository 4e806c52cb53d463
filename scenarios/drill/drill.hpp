#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/drill/file.hpp"
#include "scenarios/drill/steps.hpp"
#include "scenarios/world/defs.hpp"

namespace scenarios::drill {

/// The values of a scored item that pass.
struct Band {
    double low = 0, high = std::numeric_limits<double>::infinity();  ///< Least and greatest, both pass.

    /// Whether a value passes; one that is no number does not.
    bool holds(double value) const { return value >= low && value <= high; }
};

/// What the thread must be at the end.
struct Goal {
    std::string tie;               ///< "square", "surgeons", "slip", "clove hitch", ... as sim::knot::Name::surgical.
    std::string around;            ///< Name of the vessel that it is tied round, or empty.
    int throws = 0;                ///< Number of throws asked for, or 0.
    std::string notation;          ///< Throws in notation asked for ("2=1"), or empty.
    std::optional<Band> tails_mm;  ///< Length of both tails [mm]; none: they are not judged.
    int times = 1;                 ///< Number of pieces of thread that it is asked for in, at least 1.
};

/// Bands of scored items, in the unit of the name. An item without one is shown, not judged.
struct Bands {
    std::optional<Band> time_s, tension_N, pass_throughs;      ///< Bands of the whole session.
    std::optional<Band> walls_crossed;                         ///< Band of what tools do to walls that give way.
    std::optional<Band> needle_deg, bites, bite_mm, bite_deg;  ///< Bands of needle and bites.
    std::optional<Band> gap_mm, lumen, leak_mL_min, lapses;    ///< Bands of a join.
    std::vector<std::optional<Band>> path_mm, grasps, lag_mm;  ///< One per instrument, in the drill's order.
};

/// A drill file, read and checked.
struct Drill {
    std::string title, description;  ///< For people, as the file has them.
    world::WorldDef world;           ///< What is in the scene, in SI.
    std::vector<Goal> goals;         ///< What is to be tied; none: nothing is judged by a goal.
    Bands bands;                     ///< What is judged, in units that people read.
    std::vector<Step> steps;         ///< The guidance through it, in order; none: there is none.
    double pace = 1;                 ///< Seconds simulated in a second of the clock at most, above 0 to 1.
    double time_limit_s = 0;         ///< Simulated time at which the session ends [s], above 0.
    std::filesystem::path motion;    ///< Resolved beside the drill file; empty if none is named.
    std::string text;                ///< The file itself, byte for byte: what a recording keeps.
    std::string filled;              ///< The same as JSON with every default and table value filled in.
};

/// Reads a drill file. Throws FileError, also when a mesh named there is missing or has another hash, the motion is
/// missing, or steps refer to a motion that cannot be read or ends before.
Drill load_drill(const std::filesystem::path& file);

/// Reads a drill from its text, as a recording keeps it; looks at no other file. `name` is what messages call it,
/// relative paths start from `base`. Throws FileError.
Drill parse_drill(const std::string& text, const std::string& name, const std::filesystem::path& base);

/// The names of a drill's instruments, in its order.
std::vector<std::string> instrument_names(const Drill& drill);

/// The published JSON Schema (draft 2020-12) of drill files, as committed in scenarios/drills/schema.
std::string published_schema();

}  // namespace scenarios::drill
