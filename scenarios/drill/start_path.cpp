#include "scenarios/drill/start_path.hpp"

#include <algorithm>

#include "scenarios/drill/shape.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/resample.hpp"

namespace scenarios::drill {

namespace {

using sim::geometry::closest_points;
using world::Vec3;

// People write paths with a few digits; a thread of 150 mm on a path of 149.9 mm is a rounding, not a mistake. The
// thread then has the length of the path.
constexpr double rounding = 1e-3;

std::optional<StartProblem> cut(world::ThreadDef& thread) {
    double along = 0;
    for (std::size_t i = 1; i < thread.start.size(); ++i) {
        const Vec3 from = thread.start[i - 1], step = thread.start[i] - from;
        if (step.isZero(0)) return StartProblem{static_cast<int>(i), "is the corner before it again, remove one"};
        if (along + step.norm() >= thread.length) {
            thread.start.resize(i + 1);
            thread.start[i] = from + (thread.length - along) / step.norm() * step;
            return {};
        }
        along += step.norm();
    }
    if (along < (1 - rounding) * thread.length)
        return StartProblem{-1, "the path is " + shown(along * 1000) +
                                    " mm long, expected at least length_mm, which is " + shown(thread.length * 1000) +
                                    " mm"};
    thread.length = along;
    return {};
}

double gap(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    return std::sqrt(closest_points(a0, a1, b0, b1).distance_squared);
}

// A piece of a path, and the tube that it lies in.
struct InTube {
    int piece;
    const world::VesselDef* vessel;
};

std::optional<InTube> in_tube(const world::WorldDef& world, std::span<const Vec3> path) {
    for (const world::VesselDef& vessel : world.vessels) {
        if (!vessel.mesh_file.empty()) continue;
        const Vec3 half = vessel.length / 2 * vessel.axis;
        const double clear = (vessel.diameter + world.thread.diameter) / 2;
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            if (gap(path[i], path[i + 1], vessel.centre - half, vessel.centre + half) < clear) return InTube{static_cast<int>(i), &vessel};
    }
    return {};
}

std::optional<StartProblem> clear_of_tubes(const world::WorldDef& world) {
    const auto in = in_tube(world, world.thread.start);
    if (!in) return {};
    return StartProblem{in->piece, "from here to the next corner the thread is inside the vessel \"" + in->vessel->name + "\", expected to start clear of it"};
}

// Pieces as long as a bend needs that leave a corner side by side: what is as far from it on one is within a diameter on the other.
bool folds_back(const world::ThreadDef& thread, std::size_t corner) {
    const Vec3 back = thread.start[corner - 1] - thread.start[corner], on = thread.start[corner + 1] - thread.start[corner];
    const double bend = 3 * thread.diameter;
    return std::min(back.norm(), on.norm()) >= bend && bend * (back.normalized() - on.normalized()).norm() < thread.diameter;
}

std::optional<StartProblem> clear_of_itself(const world::ThreadDef& thread) {
    const auto& path = thread.start;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (i > 0 && folds_back(thread, i))
            return StartProblem{static_cast<int>(i), "the thread folds back onto itself here, expected a bend with room for it"};
        double between = 0;  // along the thread, from the end of piece i to the start of piece j
        for (std::size_t j = i + 1; j + 1 < path.size(); between += (path[j + 1] - path[j]).norm(), ++j) {
            // Pieces this near along the thread are one bend; a bend that touches itself is at least pi diameters long.
            if (between < 3 * thread.diameter) continue;
            if (gap(path[i], path[i + 1], path[j], path[j + 1]) < thread.diameter)
                return StartProblem{static_cast<int>(j),
                                    "from here to the next corner the thread touches the piece from corner " +
                                        std::to_string(i) + ", expected them a diameter apart"};
        }
    }
    return {};
}

// Few links cut corners.
std::optional<StartProblem> links_clear(const world::WorldDef& world) {
    const world::ThreadDef& thread = world.thread;
    const std::vector<Vec3> nodes = sim::geometry::resample(thread.start, thread.links);
    const double link = thread.length / thread.links;
    const std::string few = "of " + std::to_string(thread.links) + " links number ";
    if (const auto in = in_tube(world, nodes))
        return StartProblem{-1, few + std::to_string(in->piece) + " is inside the vessel \"" + in->vessel->name + "\", expected more links, or a start farther from it"};
    const auto apart = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(3 * thread.diameter / link)));
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        for (std::size_t j = i + apart; j + 1 < nodes.size(); ++j)
            if (gap(nodes[i], nodes[i + 1], nodes[j], nodes[j + 1]) < thread.diameter / 2)
                return StartProblem{-1, few + std::to_string(i) + " lies in number " + std::to_string(j) + ", expected more links, or a wider bend"};
    return {};
}

}  // namespace

std::optional<StartProblem> cut_and_check_start(world::WorldDef& world) {
    if (auto problem = cut(world.thread)) return problem;
    if (auto problem = clear_of_tubes(world)) return problem;
    if (auto problem = clear_of_itself(world.thread)) return problem;
    return links_clear(world);
}

std::vector<Vec3> start_behind(const world::WorldDef& world) {
    const double two_links = 2 * world.thread.length / world.thread.links;
    return {world.needle.tail(), world.needle.tail() - two_links * world.needle.tangent(0)};
}

nlohmann::json straight_start(const world::WorldDef& world) {
    if (!world.needle_code.empty()) {
        const Vec3 end = 1000 * (world.needle.tail() - world.thread.length * world.needle.tangent(0)), before = 0.5 * (1000 * world.thread.start.back() + end);
        return {{before.x(), before.y(), before.z()}, {end.x(), end.y(), end.z()}};
    }
    double top = 0;
    for (const world::VesselDef& vessel : world.vessels)
        top = std::max(top, vessel.centre.z() + vessel.length / 2 * std::abs(vessel.axis.z()) + vessel.diameter / 2);
    const double z = top * 1000 + 10, half = world.thread.length * 1000 / 2;
    return {{0, -half, z}, {0, half, z}};
}

}  // namespace scenarios::drill
