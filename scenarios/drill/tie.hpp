#pragma once
#include <string>

#include "scenarios/drill/drill.hpp"

namespace scenarios::drill {

/// What is wrong with asking for this, as the end of a message on the key that is named; nothing when it can be tied.
struct GoalFault {
    std::string key, what;
};
GoalFault fault_of(const Goal& goal, bool has_vessel);

/// How many throws a notation has: "2=1" two.
int throw_count(const std::string& notation);

/// Made fast round a vessel: of no throws.
bool is_hitch(const std::string& tie);

/// The throws that are asked for, in Tera and Aberg's notation: those given, or as many as are asked of this tie; empty
/// when the goal says nothing of them.
std::string throws_asked(const Goal& goal);

}  // namespace scenarios::drill
