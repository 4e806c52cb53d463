#include "app/hands/strand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app::hands {

namespace {

bool is_held(const World& world, int node) {
    for (const auto& needle : world.needles())
        if (node == needle.node || node == needle.node + 1) return true;
    for (const auto& tool : world.tools())
        for (const auto& grasp : tool.grasps)
            if (node >= grasp.first && node < grasp.first + grasp.count()) return true;
    return false;
}

// Looks for the nearest of links, each from a to b.
struct Nearest {
    Vec3 point;
    double distance2;  // of the nearest so far, or the most that is asked for [m^2]
    Vec3 at = Vec3::Zero(), way = Vec3::Zero();

    bool is_farther_than(const Vec3& a, const Vec3& b, Vec3& foot) const {
        const Vec3 link = b - a;
        foot = a + std::clamp((point - a).dot(link) / link.squaredNorm(), 0.0, 1.0) * link;
        return !((foot - point).squaredNorm() < distance2);
    }
    void look(const Vec3& a, const Vec3& b, const auto& is_free) {
        Vec3 foot;
        if (is_farther_than(a, b, foot) || !is_free()) return;
        distance2 = (foot - point).squaredNorm(), at = foot, way = b - a;
    }
};

}  // namespace

std::optional<Takeable> nearest_takeable(const World& world, int tool, const Vec3& point, double within) {
    Nearest nearest{point, within * within};
    const auto nodes = world.thread();
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        nearest.look(nodes[i], nodes[i + 1], [&] {
            const int link = static_cast<int>(i);
            return !world.thread_state().is_cut(link) && !is_held(world, link) && !is_held(world, link + 1);
        });
    // Jaws at the very end of a wire would close past it.
    constexpr double end = 0.05;
    constexpr int looks = 24;
    for (const auto& needle : world.needles()) {
        const auto at = [&](int k) { return needle.now.at(needle.now.length() * (end + (1 - 2 * end) * k / looks)); };
        for (int k = 0; k < looks && !needle.is_held_by(tool); ++k) nearest.look(at(k), at(k + 1), [] { return true; });
    }
    if (nearest.way.isZero(0)) return {};
    return Takeable{nearest.at, nearest.way.normalized(), std::sqrt(nearest.distance2)};
}

double distance_to_wall(const World& world, const Vec3& point) {
    double least2 = std::numeric_limits<double>::infinity();
    for (const auto& vessel : world.vessels())
        for (const Vec3& node : vessel.tissue.nodes()) least2 = std::min(least2, (node - point).squaredNorm());
    return std::sqrt(least2);
}

double along_thread(const World& world, int node) {
    const auto rest = world.thread_state().rest_lengths();
    double along = 0;
    for (int k = 0; k < node; ++k) along += rest[static_cast<std::size_t>(k)];
    return along;
}

Takeable on_thread(const World& world, double along) {
    const auto rest = world.thread_state().rest_lengths();
    const auto nodes = world.thread();
    std::size_t link = 0;
    for (; link + 1 < rest.size() && along > rest[link]; ++link) along -= rest[link];
    const Vec3 way = nodes[link + 1] - nodes[link];
    return {nodes[link] + std::clamp(along / rest[link], 0.0, 1.0) * way, way.normalized(), 0};
}

Vec3 bite_of(const instruments::Pose& pose) {
    return pose.position - bite_depth * (pose.rotation * Vec3::UnitZ());
}

}  // namespace app::hands
