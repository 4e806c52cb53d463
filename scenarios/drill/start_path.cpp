#include "scenarios/drill/start_path.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "scenarios/drill/schema.hpp"
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
        return StartProblem{-1, "the path is " + shown(1e-6 * std::round(along * 1e9)) +
                                    " mm long, expected at least length_mm, which is " + shown(thread.length * 1000) +
                                    " mm"};
    thread.length = along;
    return {};
}

double gap(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    return std::sqrt(closest_points(a0, a1, b0, b1).distance_squared);
}

// Half along its axis, and how far from that a thread's middle line is clear of it.
struct Core {
    Vec3 from, to;
    double clear;
};

Core core_of(const world::VesselDef& vessel, const world::ThreadDef& thread) {
    const Vec3 half = vessel.length / 2 * vessel.axis;
    return {vessel.centre - half, vessel.centre + half, (vessel.diameter + thread.diameter) / 2};
}

std::optional<StartProblem> clear_of_tubes(const world::WorldDef& world) {
    const auto& path = world.thread.start;
    for (const world::VesselDef& vessel : world.vessels) {
        if (!vessel.mesh_file.empty()) continue;
        const Core core = core_of(vessel, world.thread);
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            if (gap(path[i], path[i + 1], core.from, core.to) < core.clear)
                return StartProblem{static_cast<int>(i),
                                    "from here to the next corner the thread is inside the vessel \"" + vessel.name +
                                        "\", expected to start clear of it"};
    }
    return {};
}

// Pieces as long as a bend needs that leave a corner side by side: what is as far from it on one is within a diameter
// on the other.
bool folds_back(const world::ThreadDef& thread, std::size_t corner) {
    const Vec3 back = thread.start[corner - 1] - thread.start[corner],
               on = thread.start[corner + 1] - thread.start[corner];
    const double bend = 3 * thread.diameter;
    return std::min(back.norm(), on.norm()) >= bend &&
           bend * (back.normalized() - on.normalized()).norm() < thread.diameter;
}

std::optional<StartProblem> clear_of_itself(const world::ThreadDef& thread) {
    const auto& path = thread.start;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (i > 0 && folds_back(thread, i))
            return StartProblem{static_cast<int>(i),
                                "the thread folds back onto itself here, expected a bend with room for it"};
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

// What a link that goes straight leaves out of the path, in triangles.
std::vector<sim::geometry::Triangle> cut_corners(std::span<const Vec3> between, const Vec3& from, const Vec3& to) {
    std::vector<sim::geometry::Triangle> all;
    for (std::size_t i = 0; i < between.size(); ++i)
        all.push_back({from, between[i], i + 1 < between.size() ? between[i + 1] : to});
    return all;
}

// Laid link by link from the first, the thread must come through nothing where a link cuts corners: what it goes round
// it would no more go round.
std::optional<StartProblem> links_go_as_the_path(const world::WorldDef& world) {
    const world::ThreadDef& thread = world.thread;
    const std::vector<Vec3> nodes = sim::geometry::resample(thread.start, thread.links);
    std::vector<double> along{0};
    for (std::size_t i = 1; i < thread.start.size(); ++i)
        along.push_back(along.back() + (thread.start[i] - thread.start[i - 1]).norm());
    const auto corner_after = [&](std::size_t node) {
        const double here = along.back() * static_cast<double>(node) / thread.links;
        return static_cast<std::size_t>(std::upper_bound(along.begin(), along.end() - 1, here) - along.begin());
    };
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        const std::size_t first = corner_after(k), last = corner_after(k + 1);
        const auto cut = cut_corners(std::span(thread.start).subspan(first, last - first), nodes[k], nodes[k + 1]);
        if (cut.empty()) continue;
        const auto goes_through = [&](const Vec3& a, const Vec3& b, double clear) {
            return std::any_of(cut.begin(), cut.end(), [&](const auto& triangle) {
                return closest_points(a, b, triangle).distance_squared < clear * clear;
            });
        };
        const auto cuts = [&](const std::string& what) {
            return StartProblem{-1, "of " + std::to_string(thread.links) + " links number " + std::to_string(k) +
                                        " cuts a corner through " + what + ", expected more links, or a wider bend"};
        };
        for (const world::VesselDef& vessel : world.vessels)
            if (const Core core = core_of(vessel, thread);
                vessel.mesh_file.empty() && goes_through(core.from, core.to, core.clear))
                return cuts("the vessel \"" + vessel.name + "\"");
        const double one_bend = 3 * thread.diameter, link = along.back() / thread.links;
        for (std::size_t i = 0; static_cast<double>(i + 1) * link + one_bend < static_cast<double>(k) * link; ++i)
            if (goes_through(nodes[i], nodes[i + 1], thread.diameter / 2)) return cuts("link " + std::to_string(i));
        for (std::size_t i = last; i + 1 < thread.start.size(); ++i)
            if (along[i] > static_cast<double>(k + 1) * link + one_bend &&
                goes_through(thread.start[i], thread.start[i + 1], thread.diameter / 2))
                return cuts("what comes behind corner " + std::to_string(i));
    }
    return {};
}

}  // namespace

std::optional<StartProblem> cut_and_check_start(world::WorldDef& world) {
    if (auto problem = cut(world.thread)) return problem;
    if (auto problem = clear_of_tubes(world)) return problem;
    if (auto problem = clear_of_itself(world.thread)) return problem;
    return links_go_as_the_path(world);
}

std::optional<StartProblem> cut_and_check_last_spare(world::WorldDef& world) {
    world::WorldDef alone = world;
    alone.thread.start = world.spares.back().start;
    if (auto problem = cut_and_check_start(alone)) return problem;
    std::vector<Vec3>& path = world.spares.back().start = alone.thread.start;
    const auto meets = [&](const std::vector<Vec3>& other, std::size_t i) {
        for (std::size_t j = 0; j + 1 < other.size(); ++j)
            if (gap(path[i], path[i + 1], other[j], other[j + 1]) < world.thread.diameter) return true;
        return false;
    };
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        bool met = meets(world.thread.start, i);
        for (std::size_t before = 0; before + 1 < world.spares.size(); ++before)
            met = met || meets(world.spares[before].start, i);
        if (met)
            return StartProblem{
                static_cast<int>(i),
                "from here to the next corner it touches a thread before it, expected them a diameter apart"};
    }
    return {};
}

std::vector<Vec3> start_behind(const world::WorldDef& world, const sim::geometry::Arc& needle) {
    const double two_links = 2 * world::first_link(world);
    return {needle.tail(), needle.tail() - two_links * needle.tangent(0)};
}

nlohmann::json straight_start(const world::WorldDef& world) {
    if (!world.needle_code.empty()) {
        const Vec3 end = 1000 * (world.needle.tail() - world.thread.length * world.needle.tangent(0)),
                   before = 0.5 * (1000 * world.thread.start.back() + end);
        return {{before.x(), before.y(), before.z()}, {end.x(), end.y(), end.z()}};
    }
    double top = 0;
    for (const world::VesselDef& vessel : world.vessels)
        top = std::max(top, vessel.centre.z() + vessel.length / 2 * std::abs(vessel.axis.z()) + vessel.diameter / 2);
    const double z = top * 1000 + 10, half = world.thread.length * 1000 / 2;
    return {{0, -half, z}, {0, half, z}};
}

}  // namespace scenarios::drill
