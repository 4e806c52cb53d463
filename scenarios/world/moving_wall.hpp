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
    /// Of each corner of a triangle: the hole that it is about; none: -1.
    using Holes = std::array<int, 3>;

    /// None has a hole yet. `radius`: of the thread [m].
    MovingWall(std::vector<Triangle> triangles, double radius);

    /// Other triangles in place of these, each a part of one of them: what is left stays where it was shown. `holes`:
    /// one each. Milliseconds.
    void renew(std::vector<Triangle> triangles, std::span<const tissue::Part> parts, const std::vector<Holes>& holes);

    const sim::geometry::TriangleTree& tree() const { return tree_; }
    int size() const { return tree_.size(); }

    /// Towards `targets`, one each. `rooms` and `gaps`: of Thread::surface_room(). Returns the farthest that any corner
    /// went [m]. Allocates nothing.
    double follow(std::span<const Triangle> targets, std::span<const double> rooms,
                  std::span<const sim::thread::SurfaceGap> gaps);

  private:
    void number_corners(const std::vector<Holes>& holes);
    void show();
    void move_holes(std::span<const sim::thread::SurfaceGap> gaps);
    void move_rest(std::span<const sim::thread::SurfaceGap> gaps);
    double may(double room) const;

    double radius_;
    sim::geometry::TriangleTree tree_;
    std::vector<std::array<int, 3>> corners_;  // of each triangle; those that began in one place are one
    std::vector<sim::geometry::Vec3> places_, targets_;
    std::vector<double> room_;               // of each corner [m]
    std::vector<sim::geometry::Vec3> ways_;  // of each in this tick [m]
    std::vector<int> hole_;                  // of each
    std::vector<double> share_;              // of their ways that corners about a hole make
    std::vector<double> taken_;              // of the ways of each gap's corners, along its normal [m]
    std::vector<Triangle> moved_;
};

}  // namespace scenarios::world
