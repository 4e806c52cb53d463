#pragma once
#include "scenarios/world/defs.hpp"
#include "tissue/skin.hpp"
#include "tissue/tissue.hpp"

namespace scenarios::world {

/// The wall of a tube as a drill has it, in the world frame: cells finest near its cut, or all as fine where both ends are held.
tissue::Mesh wall_of(const VesselDef& def);

/// A vessel that gives way.
struct SoftVessel {
    explicit SoftVessel(const VesselDef& def);

    tissue::Tissue tissue;
    tissue::Skin skin;
    std::vector<tissue::Hold> clamps;         ///< Nodes that are held where they are.
    std::vector<tissue::PointForce> forces;   ///< For the next step, so far.
    int first = 0;                            ///< Its triangles' first number in the scene's wall.
};

}  // namespace scenarios::world
