#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "scenarios/world/defs.hpp"

namespace scenarios::drill {

/// What is wrong with a start path.
struct StartProblem {
    int at;            ///< The corner at fault, from 0; -1: the whole path.
    std::string what;  ///< What is wrong and what would be right: the end of a message.
};

/// Cuts thread.start to thread.length, measured from its first corner, and checks that a thread can lie there: long
/// enough, no corner given twice, clear of every tube and of itself, and so its links. Cost: quadratic in corners and
/// links.
std::optional<StartProblem> cut_and_check_start(world::WorldDef& world);

/// Does the same for the last of world.spares, which must be clear of the threads before it, too.
std::optional<StartProblem> cut_and_check_last_spare(world::WorldDef& world);

/// The first two corners [m] of the path of a thread on a needle: the needle's tail, and a place behind it along its
/// wire as far as the thread is sure to go straight.
std::vector<world::Vec3> start_behind(const world::WorldDef& world, const sim::geometry::Arc& needle);

/// The path used when none is given: with a needle straight on from start_behind(), else straight along y, 10 mm above
/// the highest tube. [mm], as in a drill file.
nlohmann::json straight_start(const world::WorldDef& world);

}  // namespace scenarios::drill
