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
    /// A thread at rest with nodes at `nodes` [m], at least 2, or 3 of an elastic one; rest lengths are the distances
    /// between them. `cuts`: links that part the thread into several from the start; neither the first nor
    /// the last link, and no two next to each other.
    Thread(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts = {});
    ~Thread();
    /// A copy goes on as the original would, bit for bit, given the same inputs; its first ticks may allocate.
    Thread(const Thread&);
    Thread& operator=(const Thread&);
    Thread(Thread&&) noexcept;
    Thread& operator=(Thread&&) noexcept;

    /// Makes one tick and says what it did. Allocates nothing once buffers have grown to the scene's size.
    TickReport tick(const TickInput& input);

    /// Between ticks: puts links where they are needed, by ThreadDef::shortest_link. None is longer than the longest
    /// was at first. The curve stays where it is to within a tenth of the radius, and what passes through what. `held`:
    /// nodes that somebody holds; they stay, and get their new numbers here. Returns whether any number changed.
    /// Allocates nothing; O(n).
    bool fit_links(std::span<int> held);

    /// Between ticks: cuts the thread at `share` (0..1) of a link, or where it broke there. Its pieces follow each
    /// other among the nodes, the link between them is a cut. Their round ends just touch, and nothing moves: the
    /// thread loses a thickness of its length and, where what would be left of a link is shorter than the radius and a
    /// quarter of it, that as well. `held` as in fit_links; -1 where a node is no more. False, and nothing is cut,
    /// where either piece would have no link left. May allocate; O(n).
    bool cut(int link, double share, std::span<int> held);
    /// The link, of those that can be cut in their middle, whose outermost fibres bear most: a bend of curvature k,
    /// beyond what it keeps when unloaded, adds radius * k of what the link carries, so a knotted thread breaks where
    /// it enters the knot [Pieranski et al. 2001]. -1: none carries anything.
    int most_loaded() const;

    /// What the thread is, as it was made.
    const ThreadDef& def() const;
    std::span<const Vec3> nodes() const;  ///< n + 1 positions [m], world frame.
    std::span<const double> rest_lengths()
        const;  ///< n lengths [m], 0 of a cut; they change only in fit_links and cut.
    /// Whether a link, counted from 0, is a cut.
    bool is_cut(int link) const { return rest_lengths()[static_cast<std::size_t>(link)] == 0; }
    /// The pieces that cuts leave, in their order along the thread.
    std::vector<Piece> pieces() const;
    /// n pulls [N], negative where a link is pushed together; by Follow-The-Leader an estimate of what a thread of
    /// ThreadDef::axial_stiffness would carry.
    std::span<const double> tension() const;
    /// What it did to the surface as the last tick ended: pushes and friction of an elastic thread; by
    /// Follow-The-Leader, which has no forces, what the estimated tensions of the links that meet there pull.
    std::span<const SurfaceForce> surface_forces() const;
    /// How far each triangle of the last tick's surface is at least from the thread's middle line [m]; never told more
    /// than it looked. Where that may be less than three radii it says nothing, and `gaps` what each link leaves: where
    /// corners of the triangle come nearer by less along the normal, neither passes the other. Some 0.2 us a gap.
    void surface_room(std::span<double> rooms, std::vector<SurfaceGap>& gaps) const;
    /// The share of its motion that a tool made in the last tick, 0..1; -1 asks for what no tool holds.
    double progress(int owner) const;
    /// FNV-1a over what a recording holds against a replay: positions, speeds, pushes, distances of what is near and
    /// how far tools dare to go. Its words and their order stay, so that earlier recordings still verify.
    std::uint64_t hash() const;
    /// FNV-1a over every bit that is carried from tick to tick: two threads with the same one go on alike.
    std::uint64_t hash_of_all_carried() const;

  private:
    struct Impl;
    Impl* impl_;
};

/// The pull that a thread bears. A pull beyond it breaks an elastic thread at once. By Follow-The-Leader a pull is an
/// estimate from how far tools lag, as they do where jaws shut on a strand or a tracker loses a hand for a frame as
/// well: it must stand for a tenth of a second. A thread that gave way does so again only after it bore what pulls:
/// hands may draw its pieces on faster than they can recoil here.
struct Strength {
    double force = std::numeric_limits<double>::infinity();  ///< Most pull that the thread bears for long [N].
    double pulled_s = 0;                                     ///< How long it has been pulled harder than that [s].

    /// Whether the thread breaks in this tick of `tick_s` seconds under a pull [N]; counts the time it is pulled for.
    bool gives_way(double pull, double tick_s, bool is_elastic);
};

}  // namespace sim::thread
