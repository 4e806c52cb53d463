#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/drill/file.hpp"
#include "scenarios/world/defs.hpp"

namespace scenarios::drill {

/// Passes inside [low, high].
struct Band {
    double low = 0, high = std::numeric_limits<double>::infinity();

    bool holds(double value) const { return value >= low && value <= high; }
};

/// What the thread must be at the end.
struct Goal {
    std::string tie;       ///< "square", "surgeons", "slip", "clove hitch", ... as sim::knot::Name::surgical.
    std::string around;    ///< Name of a vessel, or empty.
    int throws = 0;        ///< Number of throws asked for, or 0.
    std::string notation;  ///< Throws in notation asked for ("2=1"), or empty.
    std::optional<Band> tails_mm;
    int times = 1;  ///< In so many pieces of thread.
};

/// Bands of scored items, in the unit of the name. Absent: the item is shown, not judged. Lists: one per instrument.
struct Bands {
    std::optional<Band> time_s, tension_N, pass_throughs;
    std::optional<Band> needle_deg, bites, bite_mm, bite_deg;
    std::optional<Band> gap_mm, lumen, leak_mL_min, lapses;  ///< Of a join.
    std::vector<std::optional<Band>> path_mm, grasps, lag_mm;
};

/// A drill file, read and checked. World in SI; goals and bands as people read them.
struct Drill {
    std::string title, description;
    world::WorldDef world;
    std::vector<Goal> goals;
    Bands bands;
    double time_limit_s = 0;
    std::filesystem::path motion;  ///< Resolved beside the drill file; empty if none is named.
    std::string text;              ///< The file itself, byte for byte: what a recording keeps.
    std::string filled;            ///< The same as JSON with every default and table value filled in.
};

/// Reads a drill file. Throws FileError, also when a mesh named there is missing or has another hash, or the motion is
/// missing.
Drill load_drill(const std::filesystem::path& file);

/// Reads a drill from its text, as a recording keeps it; looks at no other file. `name` is what messages call it,
/// relative paths start from `base`. Throws FileError.
Drill parse_drill(const std::string& text, const std::string& name, const std::filesystem::path& base);

/// The published JSON Schema (draft 2020-12) of drill files, as committed in scenarios/drills/schema.
std::string published_schema();

}  // namespace scenarios::drill
