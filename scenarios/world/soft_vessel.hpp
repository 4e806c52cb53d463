#pragma once
#include "scenarios/world/defs.hpp"
#include "scenarios/world/event.hpp"
#include "scenarios/world/tool.hpp"
#include "sim/thread/thread.hpp"
#include "tissue/bite.hpp"
#include "tissue/skin.hpp"
#include "tissue/tissue.hpp"

namespace scenarios::world {

/// The wall of a vessel as a drill has it, in the world frame [m]. The cells of a tube are finest near its cut, or all
/// as fine where both ends are held; those of a mesh are as fine as the mesh.
tissue::Mesh wall_of(const VesselDef& def);

/// Compliance of a wall as the thread reckons with it where its push on the wall changes [m/N]
/// (TickInput::soft_compliance). An end of 0.2 MPa gives way by 10 mm a newton, one of 2 MPa by 1. With less than that
/// a strand goes through a rim before its wall has followed.
constexpr double wall_compliance = 1e-3;

/// What a thread presses with at a point of a wall.
struct Press {
    tissue::MaterialPoint at;  ///< Where.
    int hole;                  ///< Which hole the point is about; none: -1.
    double size;               ///< How hard [N].
    Vec3 direction;            ///< Unit.
    double gone;               ///< How far along `direction` the wall is from where the thread met it [m].
};

/// A vessel that gives way, with what acts on it until its next step.
struct SoftVessel {
    /// `wire`: radius of the needle that will bite it [m]; holes are 1.5 times as wide.
    SoftVessel(const VesselDef& def, double wire);

    /// The approximator that holds it learns which of its jaws the vessel goes with; once, before the first tick.
    void clamp(const Tool& approximator);
    /// Takes the clamps to where the approximator's jaw is now.
    void lead_clamps(const Tool& approximator);
    /// Takes what the thread presses on one of its triangles, of which the share `trusted` counts (above 0 to 1).
    /// `shown`: the triangle as the thread met it.
    void press(const sim::thread::SurfaceForce& pressed, const sim::geometry::Triangle& shown, double trusted);
    /// Turns what press() took into forces that act for `share` (0 to 1) of the next step. By as much as the skin has
    /// gone on already from where it was shown they are less. `elastic`: the thread is.
    void load(double share, bool elastic);
    /// Adds what a tool pulls at the points of this vessel, `number` in WallGrip::vessel, that are in its jaws.
    void pull_by(const Tool& tool, int number);
    /// Moves the wall by so long under all forces so far, its skin and its bites after it.
    void step(double seconds);
    /// Tears bites that the thread has pulled at harder than they bear, after a step of so long. `elastic`: the thread
    /// is.
    void pull_at_bites(double seconds, bool elastic);
    /// Appends what the needle did in the last step to `events`.
    void note_bites(double now_s, std::vector<Event>& events);

    /// What the thread presses with about one hole.
    struct Pressed {
        double size = 0;  ///< All of it [N].
        int places = 0;   ///< At so many places.
    };

    tissue::Tissue tissue;             ///< Its wall.
    tissue::Skin skin;                 ///< The wall's surface, with holes.
    tissue::Bites bites;               ///< What the needle does and did to it.
    std::vector<tissue::Hold> clamps;  ///< Nodes that are held.
    int held_by;                       ///< Number of the tool that leads the clamps; -1: they stay where they are.
    double side = 1;                   ///< Which of the tool's jaws leads them, towards its x axis (1) or away (-1).
    Eigen::Isometry3d to_jaw = Eigen::Isometry3d::Identity();   ///< From the world to the jaw's axes at the start.
    Eigen::Isometry3d carried = Eigen::Isometry3d::Identity();  ///< How the jaw has moved the clamps since the start.
    std::vector<tissue::PointForce> forces;                     ///< For the next step, so far.
    std::vector<Press> presses;                                 ///< What the thread presses with in this tick.
    std::vector<Pressed> pressed;  ///< Scratch of load(): all that presses at no hole, then at each hole.
    std::vector<Vec3> pulls;       ///< What the thread pulls with at each hole, the mean since the last step [N].
    std::vector<Vec3> mean_pulls;  ///< The same, the mean over some 10 ms [N].
    std::vector<sim::thread::Strength>
        strengths;                 ///< What each bite bears, and for how long it has been pulled harder.
    std::vector<double> bitten_s;  ///< When the needle went through at each bite, or last did anything to it [s].
    std::string name;              ///< As the drill has it.
    int first = 0;                 ///< Number of its first triangle in what is shown to the thread.
};

/// These triangles and after them those of all vessels, which learn their numbers.
std::vector<sim::geometry::Triangle> with_skins(std::vector<sim::geometry::Triangle> triangles,
                                                std::span<SoftVessel> vessels);

/// For each corner of the same triangles the hole that it is about, numbered from vessel to vessel; none: -1, as for
/// the first `rigid` triangles.
std::vector<std::array<int, 3>> holes_in(std::size_t rigid, std::span<const SoftVessel> vessels);

}  // namespace scenarios::world
