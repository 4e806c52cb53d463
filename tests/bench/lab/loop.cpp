#include "tests/bench/lab/loop.hpp"

#include <algorithm>

namespace bench::lab {

using sim::thread::Hold;

Loop::Loop(const ThreadDef& def, const std::vector<Vec3>& nodes) : thread(def, nodes) {
    const int last = static_cast<int>(nodes.size()) - 1;
    double low = 1e300;
    for (const Vec3& p : nodes) low = std::min(low, p.z());
    held = {0, last / 2, last / 2, last};
    const double knot_at = low * 3 / (3 + loop_depth), level = low + 0.9 * (knot_at - low);
    while (at(held[1]).z() < level) --held[1];
    while (at(held[2]).z() < level) ++held[2];
}

TickReport Loop::pull_tails(double step) {
    const Vec3 on = step * (at(held[3]) - at(held[0])).normalized();
    const Hold holds[] = {
        {held[0], at(held[0]) - on}, {held[1], at(held[1])}, {held[2], at(held[2])}, {held[3], at(held[3]) + on}};
    const int owners[] = {0, 2, 3, 1};
    return thread.tick({holds, owners, {}, nullptr});
}

TickReport Loop::pull_sides(double step) {
    const Vec3 on = step * (at(right()) - at(left())).normalized();
    const Hold holds[] = {{left(), at(left()) - on}, {right(), at(right()) + on}};
    const int owners[] = {0, 1};
    return thread.tick({holds, owners, {}, nullptr});
}

}  // namespace bench::lab
