#pragma once
#include <array>
#include <span>
#include <vector>

#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"
#include "tissue/skin.hpp"

namespace scenarios::world {

using sim::geometry::Triangle;

/// All walls of a scene as the thread meets them. Those that give way come after their tissue as fast as the thread
/// makes room, so that no wall ever passes through it: where they are near a corner comes no nearer in a tick than 0.45
/// of what its triangles are off the thread's middle line, less what the thread is left at least, but goes as it likes
/// along or away; elsewhere it goes no farther than that any way. Corners about a hole make the same share of their
/// ways, so that it keeps its width.
class MovingWall {
  public:
    /// For each corner of a triangle the hole that it is about; none: -1.
    using Holes = std::array<int, 3>;

    /// Triangles without a hole [m]. `radius`: the thread's [m].
    MovingWall(std::vector<Triangle> triangles, double radius);

    /// Other triangles in place of these, each a part of one of them: what is left stays where it was shown. `parts`
    /// and `holes`: one for each triangle. Takes milliseconds.
    void renew(std::vector<Triangle> triangles, std::span<const tissue::Part> parts, const std::vector<Holes>& holes);

    const sim::geometry::TriangleTree& tree() const { return tree_; }  ///< As the thread meets them.
    int size() const { return tree_.size(); }                          ///< How many triangles.

    /// Goes towards `targets`, one for each triangle. `rooms` and `gaps`: as Thread::surface_room() tells. Returns the
    /// farthest that any corner went [m]. Allocates nothing.
    double follow(std::span<const Triangle> targets, std::span<const double> rooms,
                  std::span<const sim::thread::SurfaceGap> gaps);
    /// Adds all that is carried from tick to tick.
    friend void add_to(sim::geometry::Hash& hash, const MovingWall& wall);

  private:
    void number_corners(const std::vector<Holes>& holes);
    void show();
    void move_holes(std::span<const sim::thread::SurfaceGap> gaps);
    void move_rest(std::span<const sim::thread::SurfaceGap> gaps);
    double most_step(double room) const;

    double radius_;  // of the thread [m]
    sim::geometry::TriangleTree tree_;
    std::vector<std::array<int, 3>> corners_;  // of each triangle; corners that began in one place are one
    std::vector<int> hole_;                    // of each corner, the hole that it is about; none: -1
    std::vector<sim::geometry::Vec3> places_;  // of each corner, where it is shown [m]
    std::vector<Triangle> moved_;              // what is shown

    // Scratch of follow().
    std::vector<sim::geometry::Vec3> targets_;  // of each corner, where it should be [m]
    std::vector<double> room_;                  // of each corner [m]
    std::vector<sim::geometry::Vec3> steps_;    // of each corner, its displacement in this tick [m]
    std::vector<double> share_;                 // of each hole, how much of their displacements its corners make
    std::vector<double> taken_;  // of each gap's corners, what it took of their steps along its normal [m]
};

}  // namespace scenarios::world
