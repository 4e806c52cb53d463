#pragma once
#include <array>
#include <cassert>
#include <optional>
#include <vector>

#include "instruments/bullet_world.hpp"
#include "instruments/tool.hpp"

namespace instruments {

/// An input as the simulation writes it: canonical unit rotation, jaw in [0, 1]. None if it is not finite, its
/// quaternion is zero or its place is further away than 100 shaft lengths.
std::optional<ToolInput> usable(const ToolInput& input, const ToolShape& shape);

/// How far a tool got in one tick.
struct Advance {
    ToolInput reached;           ///< Where it is now: rotation unit, with w >= 0; jaw in [0, 1].
    bool stopped = false;        ///< Something stood in the way; `reached` is short of what was wanted.
    int part = -1;               ///< Which Part was stopped; none: -1.
    int tool = -1;               ///< Number of the tool that stopped it; none: -1.
    int surface = -1;            ///< Number of the surface that stopped it; none: -1.
    bool input_dropped = false;  ///< The wanted pose was not usable; the tool was held where it was.
};

/// Tools that move, surfaces that do not, and nothing ever inside anything else.
///
/// Tools and surfaces are numbered 0, 1, 2 ... in the order they are added. Tools are driven, not pushed: each is three
/// kinematic Bullet bodies, a shaft and two jaws. The hinge between them is not a btHingeConstraint: kinematic bodies
/// have infinite mass, so a constraint cannot move them, and the angle is an input. parts_at() places the jaws on it.
///
/// Deterministic: the same calls give the same bits, at any Bullet unit; a copy goes on as the original does. Allocates
/// nothing once its buffers have grown.
class ToolWorld {
  public:
    /// `metres_per_unit`: how long Bullet's unit is [m]; changes no bit of what happens.
    explicit ToolWorld(double metres_per_unit = bullet_unit) : world_(metres_per_unit) {}

    /// Adds a tool of a kind; returns its number.
    int add_tool(Kind kind) { return add_tool(shape_of(kind)); }
    /// Adds a tool of this shape, open at the origin; place it with set_pose(). Returns its number.
    int add_tool(const ToolShape& shape);
    /// Adds a surface of any number of finite triangles [m]; returns its number.
    int add_surface(std::vector<Triangle> triangles);

    /// Puts a tool somewhere without asking what is in between: a start, or back on the path it came. An input that is
    /// not usable() leaves it where it is.
    void set_pose(int tool, const ToolInput& input);
    /// Where a tool is.
    const ToolInput& pose(int tool) const { return at(tool).now; }
    /// A tool's parts where they are [m].
    const std::array<Capsule, part_count>& parts(int tool) const { return at(tool).parts; }

    /// Moves a tool towards `wanted` as far as nothing is in the way; the other tools stand still meanwhile. What is
    /// stopped slides along the obstacle, and a stopped jaw does not hold back the rest of the tool.
    ///
    /// Guarantee:  no part comes nearer to anything than skin(tool) / 4, at any speed, at any moment in between; if it
    ///             already was nearer (a start pose), it may only move away.
    /// Bad input:  what is not usable(): held, `input_dropped`.
    /// Cost:       3 tree queries when nothing is near; at most max_steps (tool_world.cpp) looks at what is.
    /// Source:     conservative advancement [Mirtich1996], with a separating plane per pair, as both are convex.
    Advance advance(int tool, const ToolInput& wanted);

    /// Smallest gap [m] between a tool and all that is within `range` [m] of it; `range` when nothing is, negative
    /// where they overlap.
    double clearance(int tool, double range) const;

    /// Where a moving tool stops before an obstacle [m]: a fiftieth of its jaw's radius, a twentieth of a 6-0 thread.
    double skin(int tool) const { return at(tool).shape.jaw_radius / 50; }
    /// Adds where all tools are.
    friend void add_to(sim::geometry::Hash& hash, const ToolWorld& tools);

  private:
    struct Tool {
        ToolShape shape;
        ToolInput now;
        std::array<Capsule, part_count> parts;
        std::array<int, part_count> bodies;
    };
    struct Owner {
        int tool, part, surface;  // of a Bullet body; -1 where it does not apply
    };
    struct Motion;  // of a tool from where it is
    struct Pair {   // a part of the moving tool and one convex thing it could meet
        std::size_t part;
        BulletWorld::Near other;
        double gap = -1e300, time = 0;  // [m] when last looked at, and when
    };
    struct Plane {  // that separates a pair: the pair's gap cannot be smaller than the part's height over it
        double gap;
        Vec3 normal, point;  // normal zero if the cores of the two meet
    };
    struct Stop {
        bool stopped = false;
        Pair by{};
        Vec3 normal = Vec3::Zero();
    };

    const Tool& at(int tool) const {
        assert(tool >= 0 && static_cast<std::size_t>(tool) < tools_.size() && "the number of a tool that was added");
        return tools_[static_cast<std::size_t>(tool)];
    }
    const Owner& owner(const Pair& pair) const { return owners_[static_cast<std::size_t>(pair.other.body)]; }
    Plane separate(const Capsule& capsule, const BulletWorld::Near& other) const;
    void collect_pairs(int tool, const std::array<double, part_count>& range) const;
    void place(int tool, const ToolInput& input);
    Stop sweep(int tool, const ToolInput& wanted);
    Stop leg(int tool, const ToolInput& wanted, int& steps);
    static double allowed(const Motion& motion, const Pair& pair, const Plane& plane, const Capsule& part, double rest,
                          double keep);

    BulletWorld world_;
    std::vector<Tool> tools_;
    std::vector<std::vector<Triangle>> surfaces_;
    std::vector<Owner> owners_;

    // Scratch, kept for its capacity.
    mutable std::vector<BulletWorld::Near> near_;
    mutable std::vector<Pair> pairs_;
};

}  // namespace instruments
