#pragma once
#include <string>

#include "scenarios/drill/drill.hpp"

namespace scenarios::drill {

/// What is wrong with a goal.
struct GoalFault {
    std::string key, what;  ///< The key at fault, and the end of a message on it; both empty when the goal can be tied.
};
/// Says what is wrong with asking for this in a scene with or without a vessel.
GoalFault fault_of(const Goal& goal, bool has_vessel);

/// How many throws a notation has: "2=1" has two.
int throw_count(const std::string& notation);

/// Whether a tie is a hitch, which is made fast round a vessel and has no throws.
bool is_hitch(const std::string& tie);

/// The throws that are asked for, in Tera and Aberg's notation: those given, or as many as are asked of this tie; empty
/// when the goal says nothing of them.
std::string throws_asked(const Goal& goal);

}  // namespace scenarios::drill
