#pragma once
#include <span>
#include <vector>

#include "assets/mesh.hpp"
#include "scenarios/drill/drill.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::session {

/// The rigid vessels of a scene as meshes in the world frame: read from their files, or tubes made by numbers.
/// Throws assets::AssetError for a bad mesh file, InputFault for one in which the thread would start.
std::vector<assets::Mesh> vessel_meshes(const scenarios::world::WorldDef& def);

/// `def` with the outside of vessels that give way and are meshes, read from their files. Throws as vessel_meshes()
/// does, and where no wall can be made of one, or something starts in one.
scenarios::world::WorldDef with_walls(scenarios::world::WorldDef def);

/// A world ready for its first tick, with its tools at `start`.
scenarios::world::World make_world(const scenarios::world::WorldDef& def, const std::vector<assets::Mesh>& vessels,
                                   std::span<const instruments::ToolInput> start);

}  // namespace scenarios::session
