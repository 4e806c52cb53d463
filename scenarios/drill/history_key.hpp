#pragma once
#include <string>

#include "scenarios/drill/drill.hpp"

namespace scenarios::drill {

/// What attempts at a drill are kept together by: the SHA-256, in 64 hex digits, of all that is simulated and judged,
/// with defaults filled in and its pace. Title, description, steps, the motion's name and names of mesh files are left
/// out, so that words can be mended and a file moved. Cost: a millisecond.
std::string history_key(const Drill& drill);

}  // namespace scenarios::drill
