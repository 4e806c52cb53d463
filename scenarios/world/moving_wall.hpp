#pragma once
#include <array>
#include <span>
#include <vector>

#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"
#include "tissue/skin.hpp"

namespace scenarios::world {

using sim::geometry::Triangle;

/// All walls of a scene as the thread meets them. Those that give way come after their tissue as fast as the thread makes room, so that no
/// wall ever passes through it: a corner comes no nearer to any of its links in a tick than by 0.45 of what its triangles are off the thread's middle line, less
/// what the thread is left at least. Away from the thread, and along it, it goes as it likes.
class MovingWall {
  public:
    /// `radius`: of the thread [m].
    MovingWall(std::vector<Triangle> triangles, double radius);

    /// Other triangles in place of these, each a part of one of them: what is left stays where it was shown. Milliseconds.
    void renew(std::vector<Triangle> triangles, std::span<const tissue::Part> parts);

    const sim::geometry::TriangleTree& tree() const { return tree_; }
    int size() const { return tree_.size(); }

    /// Towards `targets`, one each. `rooms`: how far each is off the thread's middle line [m], but for links that are `near` it; the thread is left as it is. Returns
    /// the farthest that any corner went [m]. Allocates nothing.
    double follow(std::span<const Triangle> targets, std::span<const double> rooms, std::span<const sim::thread::SurfaceGap> near);

  private:
    void number_corners();
    void show();
    double may_near(double width) const;
    void stop_at(std::span<const sim::thread::SurfaceGap> near);

    double radius_;
    sim::geometry::TriangleTree tree_;
    std::vector<std::array<int, 3>> corners_;       // of each triangle; those that began in one place are one
    std::vector<sim::geometry::Vec3> places_, targets_, ways_;
    std::vector<double> room_;                      // of each corner [m]
    std::vector<Triangle> moved_;
};

}  // namespace scenarios::world
