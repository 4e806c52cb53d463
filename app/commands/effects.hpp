#pragma once
#include <optional>
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
    std::string predicted_of =
        {};  ///< What `predicted` is a figure of; "" where leaving it out gets no one figure wrong.
    double predicted =
        0;  ///< How large the effect is: what leaving it out gets wrong, to within a factor of 3 up to 1.
    std::optional<double> needed_above =
        {};  ///< Value of the group above which a thread needs it, where a drill can have it.

    std::string remedy = {};  ///< What to write in this drill to have it: "gravity": true in the effects; "": nothing.

    /// Whether it is off and the thread needs it.
    bool is_missed() const { return !on && needed_above && value > *needed_above; }
};

/// Every effect of drill files, and those that are always on. The formulas are dimensional estimates; sources beside
/// them.
std::vector<Effect> effects_of(const scenarios::drill::Drill& drill);

}  // namespace app
