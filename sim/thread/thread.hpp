#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/thread/def.hpp"

namespace sim::thread {

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
    /// FNV-1a over what a recording holds against a replay: positions, speeds, pushes, distances of what is near and
    /// how far tools dare to go. Its words and their order stay, so that earlier recordings still verify.
    std::uint64_t hash() const;
    /// FNV-1a over every bit that is carried from tick to tick: two threads with the same one go on alike.
    std::uint64_t hash_of_all_carried() const;

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
