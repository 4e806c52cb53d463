#pragma once
#include "instruments/needle.hpp"
#include "instruments/tool.hpp"

namespace scenarios::world {

using instruments::Arc;

/// Who holds a needle, and how.
struct Holder {
    int tool = -1;     ///< Index into World::tools(); none: -1.
    Arc seen = {};     ///< The needle in the tool's frame.
    double along = 0;  ///< Where the jaws have it, from its tail along the wire [m].
};

/// A needle at the end of a thread: it goes where its holder goes and stays where it is let go.
struct Needle {
    int node;           ///< The thread's node that it is swaged to, the first of its piece.
    Arc before;         ///< Where it was as the tick began, in the world.
    Arc now;            ///< Where it is, in the world.
    Holder holder;      ///< Who leads it.
    Holder next;        ///< Who has closed on it too, and leads it when `holder` lets go.
    bool bent = false;  ///< It was pushed harder than its wire bears; it keeps its shape here.

    /// Whether this tool has closed on it, be it to lead it next.
    bool is_held_by(int tool) const { return holder.tool == tool || next.tool == tool; }
    /// Where it is when its holder has this pose.
    Arc led_by(const instruments::Pose& tool) const;
};

}  // namespace scenarios::world
