#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "sim/geometry/moving.hpp"
#include "sim/rod/rod_def.hpp"

namespace sim::geometry {
class TriangleTree;
}

namespace sim::thread {

using geometry::Capsule;
using geometry::Hold;
using geometry::MovingCapsule;
using geometry::Vec3;
using rod::RodDef;

/// What a thread is. SI; n links between n + 1 nodes.
struct ThreadDef {
    double radius = 0.0425e-3;      ///< [m] of the round cross-section; 6-0 is 0.085 mm thick.
    double friction = 0.15;         ///< Coulomb coefficient, thread on thread and on surfaces.
    double friction_tool = 0.15;    ///< Coulomb coefficient, thread on moving capsules.
    double axial_stiffness = 15.9;  ///< Young's modulus times cross-section [N]; scales the tension estimate only.
    double shortest_link =
        0;  ///< [m]: where the thread bends or touches itself links are halved until they are as short,
            ///< to within the root of two, and joined again where it is straight; 0: they stay as they are.
    int contacts_per_tick =
        0;  ///< Elastic only: where the steps of a tick have pressed on so many together, tools wait with what is
            ///< left of their motion, for a shorter longest tick; 0: for nothing but the steps themselves.
    std::optional<RodDef> elastic = {};  ///< Moves as this, of `radius`; else by Follow-The-Leader.
};

/// What enters one tick. Nodes appear in `holds` at most once.
struct TickInput {
    std::span<const Hold> holds;
    std::span<const int> hold_owners;  ///< One per hold: the owner of capsules that hold it, or -1.
    std::span<const MovingCapsule> capsules;
    const geometry::TriangleTree* surface = nullptr;  ///< Triangles, or none.
    double seconds = 1e-3;                            ///< How long it takes; elastic only, as are
    std::span<const Vec3> loads = {};                 ///< forces on nodes [N], one each or none.
    double surface_moved = 0;  ///< How far the surface has gone since the last tick at most [m]; none of it through
                               ///< the thread: nearer by 0.45 of surface_room() at most.
    std::span<const int> sheathed = {};  ///< Links that touch no surface: the needles that lead them are in the wall.
    int soft_from = std::numeric_limits<int>::max();  ///< The surface's triangles from this one on come after what
                                                      ///< presses on them, which its owner moves
    double soft_give = 0;  ///< between ticks: by so much [m/N] is a push taken to move them at once; elastic only.
                           ///< Where both sides, solved in turn, reckon with how the other gives way their pushes come
                           ///< to rest however stiff either is (Robin conditions: Badia, Nobile and Vergara 2008).
};

/// What a tick did and what it gave up.
struct TickReport {
    double fraction = 1;  ///< Least share of the motion asked for that any tool made; below 1 some wait.
    int substeps = 0, contacts = 0;
    double stretch_max = 0;         ///< |l / l0 - 1| of the worst link after the tick.
    double separation_min = 1e300;  ///< Smallest centre-line distance of non-neighbour links / diameter after the tick.
    double step_over_bound = 0;     ///< Largest move of a node in a substep over its bound; at most 1.
    int pass_throughs = 0;          ///< Found by the audit, in any substep, through thread, capsules or surface.
    int sweeps = 0;                 ///< Over contacts until their pushes stood still; elastic only.
    bool not_finite = false;        ///< Input was not finite; the tick was not taken.
};

/// What the thread does to one of the surface's triangles.
struct SurfaceForce {
    int triangle;
    Vec3 at;                     ///< On it [m].
    Vec3 force;                  ///< [N]
    int link;                    ///< That presses.
    Vec3 deeper = Vec3::Zero();  ///< How far the thread has gone beyond that, for TickInput::soft_give [m].
    std::optional<geometry::Triangle> asleep =
        {};  ///< Of a piece that stays where it is: the triangle as it was when that fell asleep.
};

/// How near a link is to one of the surface's triangles.
struct SurfaceGap {
    int triangle;
    Vec3 normal;  ///< From the triangle's nearest point to the thread's middle line, unit.
    double gap;   ///< Between the two [m].
};

/// What cuts leave whole: nodes `first` to `last`, at least two.
struct Piece {
    int first, last;
};

/// The thread as it is now, in one piece or, once it was cut, several.
class Thread {
  public:
    /// Nodes at `nodes` [m], at least 2; rest lengths are the distances between them. `cuts`: links, no two of them
    /// next to each other, the first or the last, that are none: the thread is several from the start.
    Thread(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts = {});
    ~Thread();
    /// A copy goes on as the original would, bit for bit, given the same inputs; its first ticks may allocate.
    Thread(const Thread&);
    Thread& operator=(const Thread&);
    Thread(Thread&&) noexcept;
    Thread& operator=(Thread&&) noexcept;

    /// One tick. Allocates nothing once buffers have grown to the scene's size.
    TickReport tick(const TickInput& input);

    /// Between ticks: links where they are needed, by ThreadDef::shortest_link. None is longer than the longest was at
    /// first. The curve stays where it is to within a tenth of the radius, and what passes through what. `held`: nodes
    /// that somebody holds; they stay, and get their new numbers here. Returns whether any number changed. Allocates
    /// nothing; O(n).
    bool fit_links(std::span<int> held);

    /// Between ticks: cuts the thread at `share` (0..1) of a link, or where it broke there. Its pieces follow each
    /// other among the nodes, the link between them is a cut. Their round ends just touch, and nothing moves: the
    /// thread loses a thickness of its length and, where what would be left of a link is shorter than the radius and a
    /// quarter of it, that as well. `held` as in fit_links; -1 where a node is no more. False, and nothing is cut,
    /// where either piece would have no link left. May allocate; O(n).
    bool cut(int link, double share, std::span<int> held);
    /// Of the links that can be cut in their middle, the one whose outermost fibres bear most: a bend of curvature k,
    /// beyond what it keeps when unloaded, adds radius * k of what the link carries, so a knotted thread breaks where
    /// it enters the knot [Pieranski et al. 2001]. -1: none carries anything.
    int most_loaded() const;

    const ThreadDef& def() const;
    std::span<const Vec3> nodes() const;           ///< n + 1 positions [m].
    std::span<const double> rest_lengths() const;  ///< n [m], 0 of a cut; change only in fit_links and cut.
    bool is_cut(int link) const { return rest_lengths()[static_cast<std::size_t>(link)] == 0; }
    std::vector<Piece> pieces() const;        ///< In their order along the thread.
    std::span<const double> tension() const;  ///< n, estimate [N]: what a thread of this stiffness would carry.
    /// What it did to the surface as the last tick ended: pushes and friction of an elastic thread; by
    /// Follow-The-Leader, which has no forces, what the estimated tensions of the links that meet there pull.
    std::span<const SurfaceForce> surface_forces() const;
    /// How far each triangle of the last tick's surface is at least from the thread's middle line [m]; never told more
    /// than it looked. Where that may be less than three radii it says nothing, and `gaps` what each link leaves: where
    /// corners of the triangle come nearer by less along the normal, neither passes the other. Some 0.2 us a gap.
    void surface_room(std::span<double> rooms, std::vector<SurfaceGap>& gaps) const;
    double progress(int owner) const;  ///< Share of its motion that a tool made in the last tick.
    std::uint64_t hash() const;        ///< Of every bit that the next tick depends on.

  private:
    struct Impl;
    Impl* impl_;
};

/// What pull a thread bears. Newtons of an elastic one break it at once. By Follow-The-Leader a pull is an estimate
/// from how far tools lag, as they do where jaws shut on a strand or a tracker loses a hand for a frame as well: it
/// must stand for a tenth of a second. A thread that gave way does so again only after it bore what pulls: hands may
/// draw its pieces on faster than they can recoil here.
struct Strength {
    double force = std::numeric_limits<double>::infinity();  ///< [N]
    double pulled_s = 0;                                     ///< For how long harder than that.

    bool gives_way(double pull, double tick_s, bool is_elastic);  ///< In this tick.
};

}  // namespace sim::thread
