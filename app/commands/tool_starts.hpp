#pragma once
#include <span>
#include <string>
#include <vector>

#include "assets/mesh.hpp"
#include "scenarios/drill/drill.hpp"

namespace app {

/// Throws InputFault where a tool starts with a part in a rigid vessel, which would hold it fast: names the motion
/// file, the tool, its parts and the vessel.
///
/// Input:  the rigid vessels' meshes in the world frame (vessel_meshes()); where each tool starts, one per instrument.
/// In it:  a part nearer to the surface than its radius, or inside of one that is closed. In the lumen of a tube, clear
///         of its wall, a tool is not in it.
/// Cost:   some milliseconds a vessel of ten thousand triangles.
void check_tool_starts(const scenarios::drill::Drill& drill, const std::vector<assets::Mesh>& rigid,
                       std::span<const instruments::ToolInput> start, const std::string& motion_file);

}  // namespace app
