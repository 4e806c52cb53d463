#pragma once
#include <vector>

#include "sim/thread/contact/state.hpp"

// What Follow-The-Leader carries, besides what both movers share.
namespace sim::thread::ftl {

using contact::Against;
using contact::Contact;
using contact::Row;

/// How far a length may be off, as a share of a link's rest length: half of what a thread at rest may show.
constexpr double stretch_tolerance = 5e-4;
/// How far into the margin of strands passes still work, as a share of the thickness.
constexpr double strand_goal = 0.03;
/// What friction that holds may let slide in a substep, as a share of the thickness.
constexpr double slip_goal = 0.03;

/// What is known of a link on steel from substep to substep.
struct Wrap {
    double friction_ratio = 0;  ///< Row::friction_ratio of the last substep, -1..1.
    bool presses = false;       ///< Whether it pressed when the last substep ended.
};

/// How far one dares to go, for tools that move together.
struct StepControl {
    double trust_region = 1;    ///< Share of the admissible step that the last substep managed, 1/64..1.
    int refused_in_a_row = 0;   ///< Substeps undone since the last good one.
    int jams_in_a_row = 0;      ///< Substeps undone at the least trust region since the last good one.
    int waits = 0;              ///< Ticks until what is jammed is tried again.
    bool stuck = false;         ///< Whether, while it waits, not even the slack around the jam can move.
    std::vector<Vec3> refused;  ///< Asked::displacements when a substep was last refused [m].
};

/// A short substep that is not within tolerance yet. The thread stays as it was before it, tools wait, and the next
/// tick goes on from here: a hard knot takes several ticks, none of them long.
struct Unfinished {
    int step_control = -1;  ///< Index into State::step_controls of the tools that it moves; -1: nothing is unfinished.
    double share = 0;       ///< Share of the tick's motion that it makes, 0..1.
    int tries = 0;          ///< Ticks that have worked at it.
    std::vector<Vec3> nodes;  ///< n + 1: where nodes have come to so far [m].
};

/// What a substep leaves to the next one.
struct LastSubstep {
    std::vector<Vec3> drift;        ///< n + 1: how each node moved, not carried along [m].
    double path = 0;                ///< How far held nodes or tools went [m].
    std::vector<double> following;  ///< n + 1: share of `path` that each node went.
    std::vector<Wrap> wraps;        ///< n: what is known of each link's wrap.
    std::vector<double> pulled;     ///< n: State::pulled as it ended [m].
};

/// All that a Follow-The-Leader thread carries from tick to tick.
struct State : contact::State {
    /// Makes it as contact::State's constructor does.
    State(const ThreadDef& def, std::vector<Vec3> start_nodes, std::span<const int> cuts = {});
    /// Does what contact::State::size_for_links() does, for the members here too.
    void size_for_links();

    LastSubstep last;  ///< What the substep before the one that runs left.
    /// Step-size control of all tools together, of nobody's holds, then of each tool alone.
    std::vector<StepControl> step_controls;
    Unfinished unfinished;  ///< The substep to go on with.
    bool slides = false;    ///< Whether what is led is taut over walls and follows along itself.
    /// Whether nothing moved and nothing is violated, so that a tick without motion does nothing.
    bool settled = false;
    std::vector<int> on_steel;   ///< Rows on steel, one a link, in the order of their links.
    std::vector<double> pulled;  ///< n: multipliers of the substep's length solves [m]; negative: shortened.
    std::vector<Vec3> carried;   ///< n + 1: how far taut spans went along with their ends in this substep [m].
};

}  // namespace sim::thread::ftl
