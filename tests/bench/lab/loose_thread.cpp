#include <algorithm>
#include <cmath>

#include "sim/geometry/resample.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/knots.hpp"
#include "tests/bench/lab/start_shapes.hpp"

namespace bench::lab {

namespace {

// The knot `scale` times as large, straight on by `tail` [m] at either end.
std::vector<Vec3> scaled(std::vector<Vec3> path, double scale, double tail) {
    for (Vec3& p : path) p *= scale;
    const auto on = [&](const Vec3& end, const Vec3& before) { return Vec3(end + tail * (end - before).normalized()); };
    const Vec3 first = on(path[0], path[1]), last = on(path[path.size() - 1], path[path.size() - 2]);
    path.insert(path.begin(), first);
    path.push_back(last);
    return path;
}

// Strands a tenth of the thickness clear of each other, and bends no tighter than twice the thread's radius.
bool fits(const std::vector<Vec3>& nodes, double link, double radius) {
    if (Gauge(std::vector(nodes.size() - 1, link), 2 * radius).gap(nodes) < 1.1) return false;
    const double least = 2 * link / std::sqrt(1 + 0.25 * link * link / (4 * radius * radius));
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        if ((nodes[i + 1] - nodes[i - 1]).norm() < least) return false;
    return true;
}

}  // namespace

Loose loose_thread(Knot knot, int links, double link, double radius) {
    return loose_thread(loose(knot), links, link, radius);
}

Loose loose_thread(const std::vector<Vec3>& path, int links, double link, double radius) {
    const double core = length_of(path), least_tail = std::max(6 * link, 4 * radius);
    Loose start;
    for (double scale = 10 * 2 * radius / core; scale < 1000 * 2 * radius / core; scale *= 1.1) {
        const int needed = std::max(links, static_cast<int>(std::ceil((scale * core + 2 * least_tail) / link)));
        const double tail = 0.5 * (needed * link - scale * core);
        start = {sim::geometry::resample(scaled(path, scale, tail), needed), static_cast<int>(tail / link)};
        if (fits(start.nodes, link, radius)) break;
    }
    return start;
}

}  // namespace bench::lab
