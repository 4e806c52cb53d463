#pragma once
#include "scenarios/world/defs.hpp"
#include "sim/thread/thread.hpp"
#include "tissue/bite.hpp"
#include "tissue/skin.hpp"
#include "tissue/tissue.hpp"

namespace scenarios::world {

/// The wall of a vessel as a drill has it, in the world frame: of a tube cells finest near its cut, or all as fine where both ends are held; of a mesh as fine as that.
tissue::Mesh wall_of(const VesselDef& def);

/// A vessel that gives way.
struct SoftVessel {
    SoftVessel(const VesselDef& def, double wire);

    /// What the thread presses on one of its triangles, of which `believed` counts, for `share` of the next step. It presses on the wall that it is `shown`: by as
    /// much as the tissue has gone on from there already it presses less.
    void press(const sim::thread::SurfaceForce& pressed, const sim::geometry::Triangle& shown, double believed, double share);

    tissue::Tissue tissue;
    tissue::Skin skin;
    tissue::Bites bites;
    std::vector<tissue::Hold> clamps;         ///< Nodes that are held where they are.
    std::vector<tissue::PointForce> forces;   ///< For the next step, so far.
    std::vector<Vec3> pulls;                  ///< Of the thread at each hole, the mean since the last step [N],
    std::vector<Vec3> mean_pulls;             ///< and over some more.
    std::vector<sim::thread::Strength> strengths;  ///< Of each bite.
    std::string name;
    int first = 0;                            ///< Its triangles' first number in the scene's wall.
};

/// These triangles and after them those of all vessels, which learn their numbers.
std::vector<sim::geometry::Triangle> with_skins(std::vector<sim::geometry::Triangle> triangles, std::span<SoftVessel> vessels);

/// Of the same triangles' corners: the holes that they are about, numbered from vessel to vessel; the `rigid` first have none.
std::vector<std::array<int, 3>> holes_in(std::size_t rigid, std::span<const SoftVessel> vessels);

}  // namespace scenarios::world
