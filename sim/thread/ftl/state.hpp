#pragma once
#include <vector>

#include "sim/thread/contact/state.hpp"

// What Follow-The-Leader carries, besides what both movers share.
namespace sim::thread::ftl {

using contact::Against;
using contact::Contact;
using contact::Row;

constexpr double stretch_tolerance = 5e-4;  ///< Of a link's rest length: half of what a thread at rest may show.
constexpr double strand_goal = 0.03;        ///< Of the thickness: how far into the margin of strands passes still work.
constexpr double slip_goal = 0.03;          ///< Of the thickness: what friction that holds may let slide in a substep.

/// A link on steel, from substep to substep.
struct Wrap {
    double grip = 0;       ///< As Row::grip.
    bool presses = false;  ///< Whether it pressed when the last substep ended.
};

/// How far one dares to go, for tools that move together.
struct Pace {
    double trust = 1;           ///< Share of the admissible step that the last substep managed, 1/64..1.
    int refused_in_a_row = 0;   ///< Substeps undone since the last good one.
    int jams_in_a_row = 0;      ///< Of the substeps undone, those at the least trust.
    int waits = 0;              ///< Ticks until what is jammed is tried again.
    bool stuck = false;         ///< While it waits not even the slack around the jam can answer.
    std::vector<Vec3> refused;  ///< What was asked for when last refused: the ways of what is held and of tools [m].
};

/// A short substep that is not within tolerance yet. The thread stays as it was before it, tools wait, and the next
/// tick goes on from here: a hard knot takes several ticks, none of them long.
struct Unfinished {
    int pace = -1;            ///< Of State::paces: whose it is; -1: there is none.
    double share = 0;         ///< Of the tick's motion, 0..1.
    int tries = 0;            ///< Ticks that have worked at it.
    std::vector<Vec3> nodes;  ///< n + 1: as far as it has come [m].
};

struct State : contact::State {
    /// As contact::State.
    State(const ThreadDef& def, std::vector<Vec3> start_nodes, std::span<const int> cuts = {});
    /// As contact::State::size_for_links().
    void size_for_links();

    std::vector<Vec3> drift;            ///< n + 1: how each node moved in the last substep, not carried along [m].
    double drift_way = 0;               ///< How far held nodes or tools went meanwhile [m].
    std::vector<double> following;      ///< n + 1: share of drift_way that each node went.
    std::vector<Pace> paces;            ///< Of all tools together, then of nobody's holds, then of each tool alone.
    Unfinished unfinished;              ///< A substep to go on with.
    bool slides = false;                ///< What is led is taut over walls and follows along itself.
    bool settled = false;               ///< Nothing moved and nothing is violated: a tick without motion does nothing.
    std::vector<Wrap> wraps;            ///< n: of the last substep.
    std::vector<int> on_steel;          ///< Rows that glide, one a link, in the order of their links.
    std::vector<double> pulled;         ///< n: multipliers of the substep's length solves [m]; negative: shortened.
    std::vector<double> pulled_before;  ///< n: `pulled` of the substep before [m].
    std::vector<Vec3> carried;          ///< n + 1: how far taut spans went along with their ends in this substep [m].
};

}  // namespace sim::thread::ftl
