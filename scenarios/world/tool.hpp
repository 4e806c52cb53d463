#pragma once
#include <vector>

#include "instruments/tool.hpp"
#include "scenarios/world/defs.hpp"
#include "tissue/mesh.hpp"

namespace scenarios::world {

using instruments::ToolInput;

/// One strand between a tool's jaws: the nodes `first` to `first + count() - 1`, fixed to the tool. However many lie
/// there, all are held: a node that is left free between the jaws is wedged in metal.
struct Grasp {
    int first = 0;                  ///< Its first node.
    std::vector<Vec3> anchor = {};  ///< Where the tool holds each, in the tool's frame [m].

    int count() const { return static_cast<int>(anchor.size()); }  ///< How many nodes; none: nothing is held.
    int middle() const { return first + count() / 2; }             ///< The node halfway along it.
};

/// A point of a wall between a tool's jaws.
struct WallGrip {
    static constexpr std::size_t most = 256;  ///< Of one tool: two walls at each look along the longest jaws.
    int vessel;                               ///< Index into Walls::vessels().
    tissue::MaterialPoint at;                 ///< Which point of its wall.
    Vec3 anchor;                              ///< Where the tool draws it, in the tool's frame [m].
};

/// An instrument in the scene, and what its jaws hold.
struct Tool {
    InstrumentDef def;              ///< As the drill has it.
    instruments::ToolShape shape;   ///< Of its kind.
    ToolInput asked;                ///< The last usable input: where its hand is.
    ToolInput before;               ///< Where the simulated tool was as the tick began.
    ToolInput now;                  ///< Where the simulated tool is; behind `asked` when it has to wait.
    std::vector<Grasp> grasps;      ///< Strands of thread in its jaws.
    bool closed = false;            ///< Its jaws are shut on whatever they hold; with hysteresis.
    bool stopped = false;           ///< Another tool or a vessel stopped it in this tick.
    bool slipping = false;          ///< Thread slid between its jaws in the last tick.
    std::vector<WallGrip> walls{};  ///< Points of walls in its jaws, at most WallGrip::most.
    bool held_up = false;           ///< That it is farther behind its hand than a jaw is thick has been told.
    int crosses = -1;               ///< Index into Walls::vessels() of the one whose wall it is led through; none: -1.

    /// How far it is behind its hand, a turn taken at its jaws' length [m].
    double lag() const { return instruments::distance_between(now.pose, asked.pose, shape.jaw_length); }
};

}  // namespace scenarios::world
