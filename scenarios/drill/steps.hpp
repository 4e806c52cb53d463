#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/world/defs.hpp"
#include "scenarios/world/event.hpp"

namespace scenarios::drill {

/// What jaws may be asked to hold.
enum class Held { nothing, thread, needle, wall };

/// That an instrument holds this, or holds nothing at all.
struct HeldCondition {
    std::size_t instrument;  ///< Number in the drill's order.
    Held what;               ///< What is in its jaws, maybe among other things.
};

/// That an instrument's tip has come to a place.
struct NearCondition {
    std::size_t instrument;  ///< Number in the drill's order.
    world::Vec3 place;       ///< Where, in the world [m].
    double within;           ///< How near is near enough [m].
};

/// That something happened since the step began.
struct EventCondition {
    world::EventKind kind;  ///< What.
    std::string what;       ///< Instrument or vessel that world::Event::what names first; empty: any.
};

/// When a step is done: as soon as all that is asked for holds at once. At least one thing is asked for.
struct Done {
    std::vector<HeldCondition> held = {};      ///< Of different instruments.
    std::vector<NearCondition> near = {};      ///< Of different instruments.
    std::optional<EventCondition> event = {};  ///< None: nothing need happen.
    std::string knot = {};                     ///< As sim::knot::Name::surgical has it; empty: any.
    std::string notation = {};                 ///< Throws in Tera and Aberg's notation; empty: any.
    int throws = 0;                            ///< Least number of throws in the thread.
    int bites = 0;                             ///< Least number of bites through one whole wall each.

    /// Whether something is asked for that work leaves behind, a knot or a bite: hands alone come and go.
    bool is_milestone() const { return !knot.empty() || !notation.empty() || throws > 0 || bites > 0; }
};

/// One step of the guidance through a drill.
struct Step {
    std::string text;                                  ///< One sentence: what to do, and where.
    Done done;                                         ///< When it is done.
    std::optional<std::array<double, 2>> reference_s;  ///< From when to when the drill's own motion does it [s].
};

}  // namespace scenarios::drill
