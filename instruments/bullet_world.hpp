#pragma once
#include <memory>
#include <vector>

#include "sim/geometry/hash.hpp"
#include "sim/geometry/shapes.hpp"

namespace instruments {

using sim::geometry::Box;
using sim::geometry::Capsule;
using sim::geometry::Triangle;
using sim::geometry::Vec3;

/// One Bullet unit [m]. Bullet's fixed lengths (0.05 of slack around every body in its tree, 0.04 of margin on a mesh,
/// advice to stay above 0.1) were chosen for objects of about one unit; jaws, threads and vessel walls are about 1 mm.
constexpr double bullet_unit = 1e-3;

/// The Bullet bodies of a ToolWorld, and who is near whom. Everything outside is in metres.
class BulletWorld {
  public:
    /// `metres_per_unit`: how long Bullet's unit is, above 0 [m].
    explicit BulletWorld(double metres_per_unit = bullet_unit);
    ~BulletWorld();
    /// The copy finds what this one finds, whatever moves in either from then on; shapes, which never change, are
    /// shared.
    BulletWorld(const BulletWorld& other);
    BulletWorld& operator=(const BulletWorld& other);
    BulletWorld(BulletWorld&&) noexcept;
    BulletWorld& operator=(BulletWorld&&) noexcept;

    /// Adds a static surface of at least one triangle [m]. Bodies are numbered 0, 1, 2 ... in the order they are added;
    /// returns its number.
    int add_surface(const std::vector<Triangle>& triangles);
    /// Adds a kinematic capsule, `length` between its end points [m]; returns its number.
    int add_capsule(double length, double radius);

    /// Moves the capsule of this number: its end points [m], and the hinge axis (unit, perpendicular to b - a).
    void place(int body, const Capsule& capsule, const Vec3& hinge_axis);

    /// Something near a box: a capsule, or one triangle of a surface. Ordered by body, then by triangle.
    struct Near {
        int body;      ///< Its number.
        int triangle;  ///< Index into the surface's triangles; -1 for a capsule.
        auto operator<=>(const Near&) const = default;
    };
    /// Replaces `found` by all that may touch `box` (never too few), in ascending order: Bullet's own order is that of
    /// its tree, which depends on how bodies moved before.
    void near(const Box& box, std::vector<Near>& found) const;
    /// Adds where each body is, and its box in the tree.
    friend void add_to(sim::geometry::Hash& hash, const BulletWorld& world);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace instruments
