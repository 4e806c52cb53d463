#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace app::rope {

using sim::geometry::Vec3;

/// Where a held node is to be at one time.
struct Key {
    double t;    ///< [s]
    Vec3 place;  ///< [m]
};

/// A node that is held from its first key to its last, moving linearly in between.
struct HeldNode {
    int node;
    std::vector<Key> keys;  ///< At least one; times ascend.

    bool held_at(double t) const { return keys.front().t <= t && t <= keys.back().t; }
    Vec3 place_at(double t) const;  ///< [m]; t [s] while held.
};

/// Reads a motion of nodes (.csv as scenarios::drill::CsvReader has it, header "t_s,node,x_mm,y_mm,z_mm"); `node` is
/// "first", "last" or an index below `nodes`. Rows of different nodes may be mixed. Ascending by node.
/// Throws InputFault "file:line:column: error: ...": unreadable, a wrong header or number of columns, a number that is
/// not finite or out of range, an unknown node, a node whose times do not ascend, no row at all. Cost: n log n.
std::vector<HeldNode> load_motion(const std::filesystem::path& file, int nodes);

}  // namespace app::rope
