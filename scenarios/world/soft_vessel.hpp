#pragma once
#include "scenarios/world/defs.hpp"
#include "sim/thread/thread.hpp"
#include "tissue/bite.hpp"
#include "tissue/skin.hpp"
#include "tissue/tissue.hpp"

namespace scenarios::world {

/// The wall of a vessel as a drill has it, in the world frame: of a tube cells finest near its cut, or all as fine
/// where both ends are held; of a mesh as fine as that.
tissue::Mesh wall_of(const VesselDef& def);

/// What the thread reckons that a wall gives way by where a push on it changes [m/N] (TickInput::soft_give). An end of
/// 0.2 MPa gives by 10 mm a newton, one of 2 MPa by 1. Softer than that a strand goes through a rim before its wall has
/// followed.
constexpr double wall_gives = 1e-3;

/// What a thread presses with at a point of a wall.
struct Press {
    tissue::MaterialPoint at;
    int hole;     ///< That it is about; none: -1.
    double size;  ///< [N]
    Vec3 way;     ///< Unit.
    double gone;  ///< How far along it the wall is from where the thread met it [m].
};

/// A vessel that gives way.
struct SoftVessel {
    SoftVessel(const VesselDef& def, double wire);

    /// What the thread presses on one of its triangles, of which `believed` counts. It presses on the wall that it is
    /// `shown`.
    void press(const sim::thread::SurfaceForce& pressed, const sim::geometry::Triangle& shown, double believed);
    /// All of that acts for `share` (0 to 1) of the next step. By as much as the skin has gone on already from where it
    /// was shown it is less. `elastic`: the thread.
    void load(double share, bool elastic);

    tissue::Tissue tissue;
    tissue::Skin skin;
    tissue::Bites bites;
    std::vector<tissue::Hold> clamps;  ///< Nodes that are held where they are,
    int held_by;                       ///< or where the tool of this number leads them; none: -1:
    double side = 1;                   ///< by its jaw towards x (1) or away from it (-1).
    Eigen::Isometry3d to_jaw =
        Eigen::Isometry3d::Identity();  ///< From the world to the jaw's axes as it was at the start,
    Eigen::Isometry3d carried = Eigen::Isometry3d::Identity();  ///< and how it has carried the clamps since.
    std::vector<tissue::PointForce> forces;                     ///< For the next step, so far.
    std::vector<Press> presses;                                 ///< Of the thread in this tick,
    struct Pressed {
        double size = 0;
        int places = 0;
    };
    std::vector<Pressed> pressed;  ///< and all of them at each hole together, at first those at none [N].
    std::vector<Vec3> pulls;       ///< Of the thread at each hole, the mean since the last step [N],
    std::vector<Vec3> mean_pulls;  ///< and over some more.
    std::vector<sim::thread::Strength> strengths;  ///< Of each bite,
    std::vector<double> bitten_s;  ///< and when the needle was through, or until then last did anything to it [s].
    std::string name;
    int first = 0;  ///< Its triangles' first number in the scene's wall.
};

/// These triangles and after them those of all vessels, which learn their numbers.
std::vector<sim::geometry::Triangle> with_skins(std::vector<sim::geometry::Triangle> triangles,
                                                std::span<SoftVessel> vessels);

/// Of the same triangles' corners: the holes that they are about, numbered from vessel to vessel; the `rigid` first
/// have none.
std::vector<std::array<int, 3>> holes_in(std::size_t rigid, std::span<const SoftVessel> vessels);

}  // namespace scenarios::world
