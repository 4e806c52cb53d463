#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/bench/knots.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/thread/thread.hpp"

namespace app::bench {

namespace {

double length_of(const std::vector<Vec3>& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
    return length;
}

// The knot `scale` times as large, straight on by `tail` [m] at either end.
std::vector<Vec3> scaled(std::vector<Vec3> path, double scale, double tail) {
    for (Vec3& p : path) p *= scale;
    const auto on = [&](const Vec3& end, const Vec3& before) { return Vec3(end + tail * (end - before).normalized()); };
    const Vec3 first = on(path[0], path[1]), last = on(path[path.size() - 1], path[path.size() - 2]);
    path.insert(path.begin(), first);
    path.push_back(last);
    return path;
}

// Strands a tenth of the thickness clear of each other, and bends no tighter than twice the thread's radius. Links nearer
// in order than half a turn of the tightest bend are the bend itself.
bool fits(const std::vector<Vec3>& nodes, double link, double radius) {
    const auto skip = static_cast<std::size_t>(std::ceil(std::numbers::pi * radius / link)) + 1;
    const double apart = 1.1 * 2 * radius;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        for (std::size_t j = i + skip; j + 1 < nodes.size(); ++j)
            if (sim::geometry::closest_points(nodes[i], nodes[i + 1], nodes[j], nodes[j
                + 1]).distance_squared < apart * apart) return false;
    const double least = 2 * link / std::sqrt(1 + 0.25 * link * link / (4 * radius * radius));
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        if ((nodes[i + 1] - nodes[i - 1]).norm() < least) return false;
    return true;
}

}  // namespace

Loose loose_thread(Knot knot, int links, double link, double radius) { return loose_thread(loose(knot), links, link, radius); }

Loose loose_thread(const std::vector<Vec3>& path, int links, double link, double radius) {
    const double core = length_of(path), least_tail = std::max(6 * link, 4 * radius);
    Loose start;
    for (double scale = 10 * 2 * radius / core; scale < 1000 * 2 * radius / core; scale *= 1.1) {
        const int needed = std::max(links, static_cast<int>(std::ceil((scale * core + 2 * least_tail) / link)));
        const double tail = 0.5 * (needed * link - scale * core);
        start = {sim::thread::resample(scaled(path, scale, tail), needed), static_cast<int>(tail / link)};
        if (fits(start.nodes, link, radius)) break;
    }
    return start;
}

}  // namespace app::bench
