// Tools are driven to where their hands ask and stop at what they meet.
//
// Method: conservative advancement [Mirtich1996]. A motion is taken in legs, a leg in steps; each step goes as far as
// the separating planes between the tool's parts and what is near allow, so that nothing is ever passed, at any speed.
// What is stopped slides along the obstacle as a god-object with a friction cone [Ruspini1997] does. Positions alone:
// tools have no mass, and a surgeon's hand does not bounce. Cost: three tree queries where nothing is near.
// [Mirtich1996] Impulse-based Dynamic Simulation of Rigid Body Systems. [Ruspini1997] The Haptic Display of Complex
// Graphical Environments.
#include "instruments/tool_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "instruments/hash.hpp"
#include "sim/geometry/closest_points.hpp"

namespace instruments {

namespace {

// Steps short of a leg's end that one sweep may take. A stop takes about three, a slide over an edge ten; a tool that
// uses up all of them stops there for this tick, which is safe.
constexpr int max_steps = 32;

// Fractions of skin(). A step that no plane allows in full is still tried over `probe`, and kept if what it reaches is
// no nearer than `floor`. On the way it can come nearer by a probe: to a quarter of the skin, as tool_world.hpp
// promises.
constexpr double floor_of_skin = 0.5, probe_of_skin = 0.25;

// Coulomb coefficient of a tool that is pressed on something. How far inside the tool is wanted stands for the force:
// a god-object with a friction cone [Ruspini1997].
constexpr double friction = 0.15;

// The part of a wanted move that friction leaves to slide, along a plane that forbids to move against `normal`.
Vec3 slide(const Vec3& wanted, const Vec3& normal) {
    const double pressed = std::max(0.0, -wanted.dot(normal));
    const Vec3 along = wanted + pressed * normal;
    const double length = along.norm();
    return length > friction * pressed ? Vec3((1 - friction * pressed / length) * along) : Vec3::Zero();
}

bool same(const ToolInput& a, const ToolInput& b) {
    return a.pose.position == b.pose.position && a.pose.rotation.coeffs() == b.pose.rotation.coeffs() && a.jaw == b.jaw;
}

// Of q and -q, which are the same rotation, the one whose first number of w, x, y, z is positive; no negative zeros.
Eigen::Vector4d canonical(const Eigen::Vector4d& q) {
    for (const int i : {3, 0, 1, 2})
        if (q[i] != 0) return (q[i] < 0 ? Eigen::Vector4d(-q) : q).array() + 0.0;
    return q;
}

Box box_of(const Capsule& capsule, double range) {
    Box box;
    box.include(capsule.a);
    box.include(capsule.b);
    return box.grown(capsule.radius + range);
}

}  // namespace

std::optional<ToolInput> usable(const ToolInput& input, const ToolShape& shape) {
    const Vec3& position = input.pose.position;
    Eigen::Vector4d q = input.pose.rotation.coeffs();  // x y z w
    if (!position.allFinite() || !q.allFinite() || !std::isfinite(input.jaw) || q.isZero(0)) return {};
    if (position.cwiseAbs().maxCoeff() > 100 * shape.shaft_length) return {};  // a device's fault, not a place
    // What already is unit, to the rounding of four squares, stays as it is: a pose given back is the same pose.
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    if (!(std::abs(q.squaredNorm() - 1) <= rounding)) q.stableNormalize();
    return ToolInput{{position, Quat(canonical(q))}, std::clamp(input.jaw, 0.0, 1.0)};
}

/// A sweep's path and bounds on it. `time` runs from 0 to 1.
struct ToolWorld::Motion {
    ToolInput from, to;
    std::array<Capsule, part_count> end;
    std::array<double, part_count> speed;  ///< No point of the part's core moves faster [m per unit of time].
    std::array<double, part_count>
        bulge;  ///< Over a time s it leaves its chord by at most bulge s^2 u, u = share of s.

    Motion(const ToolShape& shape, const ToolInput& start, const ToolInput& wanted) : from(start), to(wanted) {
        end = parts_at(shape, to.pose, to.jaw);
        const Eigen::Vector4d q = from.pose.rotation.coeffs(), p = to.pose.rotation.coeffs();
        const double quarter_sin = 0.5 * std::min((q - p).norm(), (q + p).norm());  // sine of a quarter of the turn
        const double turn = 4 * quarter_sin / std::sqrt(1 - quarter_sin * quarter_sin);  // 4 tan: not below the angle
        const double closing = 0.5 * shape.jaw_opening * std::abs(to.jaw - from.jaw);
        const double travel = (to.pose.position - from.pose.position).norm();
        // Furthest core point from the frame's origin. For jaws true up to 60 degrees a side.
        const double jaw_arm = shape.jaw_length + 2 * shape.jaw_radius;
        const double shaft_arm = shape.jaw_length + shape.shaft_radius + shape.shaft_length;
        for (std::size_t i = 0; i < part_count; ++i) {
            const double rate = i == shaft ? turn : turn + closing, arm = i == shaft ? shaft_arm : jaw_arm;
            speed[i] = travel + rate * arm;
            // |x''| <= rate^2 arm, and a curve leaves its chord over s by at most |x''|/2 (u s)(s - u s).
            bulge[i] = 0.5 * rate * rate * arm;
        }
    }

    /// Legs to take the path in. Short ones, in jaw thicknesses, keep few things in reach; and a leg that bulges by
    /// less than a probe never has to creep where the tool only turns or slides along what it touches.
    int legs(double jaw_thickness, double probe) const {
        const double by_length = std::max(speed[shaft], speed[jaw_plus]) / (2 * jaw_thickness);
        const double by_bulge = std::sqrt(std::max(bulge[shaft], bulge[jaw_plus]) / probe);
        return std::max(1, static_cast<int>(std::ceil(std::max(by_length, by_bulge))));
    }

    ToolInput at(double time) const {
        if (time >= 1) return to;
        Pose pose = between(from.pose, to.pose, time);
        pose.rotation.coeffs() = canonical(pose.rotation.coeffs());
        return {pose, from.jaw + time * (to.jaw - from.jaw)};
    }
};

int ToolWorld::add_tool(const ToolShape& shape) {
    const int tool = static_cast<int>(tools_.size());
    tools_.push_back({shape, {}, parts_at(shape, {}, 1), {}});
    for (std::size_t i = 0; i < part_count; ++i) {
        const Capsule& part = tools_.back().parts[i];
        tools_.back().bodies[i] = world_.add_capsule((part.b - part.a).norm(), part.radius);
        owners_.push_back({tool, static_cast<int>(i), -1});
    }
    set_pose(tool, {});
    return tool;
}

int ToolWorld::add_surface(std::vector<Triangle> triangles) {
    const int surface = static_cast<int>(surfaces_.size());
    if (!triangles.empty()) {
        world_.add_surface(triangles);
        owners_.push_back({-1, -1, surface});
    }
    surfaces_.push_back(std::move(triangles));
    return surface;
}

void ToolWorld::set_pose(int index, const ToolInput& input) {
    const Tool& tool = at(index);
    place(index, usable(input, tool.shape).value_or(tool.now));
}

void ToolWorld::place(int index, const ToolInput& input) {
    Tool& tool = tools_[static_cast<std::size_t>(index)];
    tool.now = input;
    tool.parts = parts_at(tool.shape, tool.now.pose, tool.now.jaw);
    for (std::size_t i = 0; i < part_count; ++i)
        world_.place(tool.bodies[i], tool.parts[i], tool.now.pose.rotation * Vec3::UnitY());
}

ToolWorld::Plane ToolWorld::separate(const Capsule& capsule, const BulletWorld::Near& other) const {
    const Owner& who = owners_[static_cast<std::size_t>(other.body)];
    double radii = capsule.radius;
    sim::geometry::ClosestPair closest;
    if (who.surface >= 0) {
        const auto& triangles = surfaces_[static_cast<std::size_t>(who.surface)];
        closest =
            sim::geometry::closest_points(capsule.a, capsule.b, triangles[static_cast<std::size_t>(other.triangle)]);
    } else {
        const Capsule& core = at(who.tool).parts[static_cast<std::size_t>(who.part)];
        closest = sim::geometry::closest_points(capsule.a, capsule.b, core.a, core.b);
        radii += core.radius;
    }
    const double distance = std::sqrt(closest.distance_squared);
    if (distance == 0) return {-radii, Vec3::Zero(), closest.on_b};
    return {distance - radii, (closest.on_a - closest.on_b) / distance, closest.on_b};
}

// What each part could meet within its range; found by box, in a fixed order.
void ToolWorld::collect_pairs(int tool, const std::array<double, part_count>& range) const {
    pairs_.clear();
    for (std::size_t part = 0; part < part_count; ++part) {
        world_.near(box_of(at(tool).parts[part], range[part]), near_);
        for (const auto& other : near_)
            if (owners_[static_cast<std::size_t>(other.body)].tool != tool) pairs_.push_back({part, other});
    }
}

double ToolWorld::clearance(int tool, double range) const {
    collect_pairs(tool, {range, range, range});
    double gap = range;
    for (const Pair& pair : pairs_) gap = std::min(gap, separate(at(tool).parts[pair.part], pair.other).gap);
    return gap;
}

ToolWorld::Stop ToolWorld::sweep(int index, const ToolInput& wanted) {
    const Motion motion(at(index).shape, at(index).now, wanted);
    const int legs = motion.legs(2 * at(index).shape.jaw_radius, probe_of_skin * skin(index));
    int steps = max_steps;
    for (int i = 1; i <= legs; ++i) {
        const Stop stop = leg(index, i == legs ? wanted : motion.at(static_cast<double>(i) / legs), steps);
        if (stop.stopped) return stop;
    }
    return {};
}

// How much of the rest of a leg a pair allows, `plane` being between its part and the other now. Both are convex, so
// their gap is at least the part's height over that plane; and the height, at the ends of the part's straight core,
// goes from what it is to its value at the leg's end but for the bulge.
double ToolWorld::allowed(const Motion& motion, const Pair& pair, const Plane& plane, const Capsule& part, double rest,
                          double keep) {
    const double furthest = motion.speed[pair.part] * rest;
    const auto height = [&](const Capsule& c) { return std::min(plane.normal.dot(c.a), plane.normal.dot(c.b)); };
    const double falls = height(part) - height(motion.end[pair.part]) + motion.bulge[pair.part] * rest * rest;
    const double closing = plane.normal.isZero(0) ? furthest : std::min(furthest, falls);
    return closing > 0 ? std::max(plane.gap - keep, probe_of_skin * keep) / closing : 1;
}

ToolWorld::Stop ToolWorld::leg(int index, const ToolInput& wanted, int& steps) {
    const Tool& tool = at(index);
    const Motion motion(tool.shape, tool.now, wanted);
    const double keep = skin(index);
    collect_pairs(index, {motion.speed[0] + keep, motion.speed[1] + keep, motion.speed[2] + keep});

    double time = 0;  // the last place known to be good
    auto parts = tool.parts;
    Stop stop;
    for (double next = 0;;) {
        const double rest = 1 - next;
        double share = 1;
        std::size_t tightest = 0;
        Stop limit;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            Pair& pair = pairs_[i];
            const double sure = pair.gap - keep - motion.speed[pair.part] * (next - pair.time);  // without looking
            if (sure > motion.speed[pair.part] * rest * share) continue;
            const Plane plane = separate(parts[pair.part], pair.other);
            if (plane.gap < floor_of_skin * keep && plane.gap < pair.gap) {
                stop = {true, pair, plane.normal};
                break;
            }
            pair.gap = plane.gap;
            pair.time = next;
            const double here = allowed(motion, pair, plane, parts[pair.part], rest, keep);
            if (here >= share) continue;
            share = here;
            tightest = i;
            limit = {true, pair, plane.normal};
        }
        if (stop.stopped) break;
        time = next;
        if (time >= 1) break;
        if (share < 1 && --steps < 0) {
            stop = limit;
            break;
        }
        if (!pairs_.empty()) std::swap(pairs_.front(), pairs_[tightest]);  // what is tight is looked at first
        next = share >= 1 ? 1 : time + share * rest;
        const ToolInput trial = motion.at(next);
        parts = parts_at(tool.shape, trial.pose, trial.jaw);
    }
    if (time > 0) place(index, motion.at(time));
    return stop;
}

Advance ToolWorld::advance(int index, const ToolInput& input) {
    const Tool& tool = at(index);
    Advance result{.reached = tool.now};
    const auto wanted = usable(input, tool.shape);
    if (!wanted) {
        result.input_dropped = true;
        return result;
    }
    const Stop first = sweep(index, *wanted);
    if (first.stopped) {
        result.stopped = true;
        result.part = static_cast<int>(first.by.part);
        result.tool = owner(first.by).tool;
        result.surface = owner(first.by).surface;
        // The rest, a piece at a time: without the jaw, then along the obstacle, turning or not, then the jaw alone.
        Stop stop = sweep(index, {wanted->pose, tool.now.jaw});
        for (const bool turning : {true, false}) {
            if (!stop.stopped) break;
            ToolInput along = tool.now;
            along.pose.position += slide(wanted->pose.position - along.pose.position, stop.normal);
            if (turning) along.pose.rotation = wanted->pose.rotation;
            stop = sweep(index, along);
        }
        sweep(index, {tool.now.pose, wanted->jaw});
        result.stopped = !same(tool.now, *wanted);
    }
    result.reached = tool.now;
    return result;
}

void add_to(sim::geometry::Hash& hash, const ToolWorld& tools) {
    hash.add(tools.world_);
    for (const ToolWorld::Tool& tool : tools.tools_) hash.add(tool.now, tool.parts);
}

}  // namespace instruments
