#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/drill/motion.hpp"

namespace scenarios::drill {

/// What a waypoint file may say, for its author.
inline constexpr const char* waypoint_steps = R"(One step a line; '#' starts a comment; mm, s, mm/s.

  tool left pointing 1 0 -0.35 opening 0.35 0 1    how a tool is turned from the next step on: from handle to
                                                   tip, and the way its jaws open (made square to it)
  start left -7 37 42 jaw 0.6 right 22 0 30 jaw 0  where every tool is at time 0; jaw 0 is closed, 1 open
  speed 60                                         of the fastest tool in the steps that follow; else 50
  go left -8 30 36 right -18 0 20                  in a straight line, all tools arriving together
  turn right 120 about 0 1 0 through 0 0 5 in 2    round an axis through a place, by degrees, place and turn of
                                                   the tool: as a needle is driven
  jaw right 0 in 0.3                               opens or closes
  wait 0.5
  frame 0 0 2 turned 90 about 0 0 1                where places and directions of the steps that follow are seen
                                                   from, as from a vessel; "frame 0 0 0" is the world again
  steps stitch ... end                             a line each: names the steps between
  play stitch                                      as if they stood here, their frames seen from the frame here,
                                                   which is back after them
  mirror y                                         from here on y of places is negated, turns go the other way;
                                                   "mirror off" ends that)";

/// A choreography of tools as a person writes it, by waypoint_steps.
struct Waypoints {
    std::vector<std::string> instruments;  ///< Names, in the order of the `start` line.
    Motion motion;                         ///< A list of keys for each of them.
};

/// Reads a waypoint file. Throws FileError with file and line.
Waypoints load_waypoints(const std::filesystem::path& file);
/// Reads the text of a waypoint file, which messages call `name`; the rest as load_waypoints().
Waypoints parse_waypoints(const std::string& text, const std::string& name);

}  // namespace scenarios::drill
