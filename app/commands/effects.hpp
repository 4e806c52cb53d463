#pragma once
#include <string>
#include <vector>

#include "scenarios/drill/drill.hpp"

namespace app {

/// One physical effect in a drill: whether it is simulated, and what leaving it out means for this thread.
struct Effect {
    std::string name;  ///< As in drill files.
    bool on = false;
    std::string group;  ///< The dimensionless group that governs it, as a formula.
    double value = 0;   ///< Of that group, for this thread and length.
    std::string error;  ///< What leaving it out gets wrong here, with numbers.
    std::string cost;   ///< Of a tick: what it costs now, or would.
};

/// Every effect of drill files, and those that are always on. The formulas are dimensional estimates; sources beside
/// them.
std::vector<Effect> effects_of(const scenarios::drill::Drill& drill);

}  // namespace app
