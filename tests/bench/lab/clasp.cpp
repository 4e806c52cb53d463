#include "tests/bench/lab/clasp.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/geometry/resample.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/stopwatch.hpp"

namespace bench::lab {

namespace {

using sim::thread::Hold;
using sim::thread::Thread;
using sim::thread::ThreadDef;

using std::numbers::pi;

constexpr double arm = 15, tips_apart = 3;  // [D] of a bight from tip to end, and of the tips at first
constexpr double pull_strain =
    0.01;  // then bent about a strand it pulls back with less than a hundredth of what pulls it

// A bight as wide as it is when tight, its tip at 0, its arms along z to `arm`.
std::vector<Vec3> bight() {
    constexpr int fine = 1000;
    std::vector<Vec3> path{{-1, 0, arm}};
    for (int i = 0; i <= fine; ++i) path.emplace_back(-std::cos(pi * i / fine), 0, 1 - std::sin(pi * i / fine));
    path.emplace_back(1, 0, arm);
    return path;
}

// Two of them in one thread, and the nodes where they end: what leads from one to the other is slack and keeps clear.
struct Hooked {
    explicit Hooked(double link_in_diameters) : link(link_in_diameters) {
        std::vector<Vec3> up = bight(), down = up;
        for (Vec3& p : up) p.z() -= 0.5 * tips_apart;
        for (Vec3& p : down) p = {0, -p.x(), 0.5 * tips_apart - p.z()};
        const std::vector<Vec3> between{up.back(), {2 * arm, 2 * arm, 0}, down.front()};
        add(up), add(between), add(down);
        for (Vec3& p : nodes) p *= default_diameter;
    }

    void add(const std::vector<Vec3>& path) {
        double length = 0;
        for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
        const auto laid = sim::geometry::resample(path, static_cast<int>(std::lround(length / link)));
        nodes.insert(nodes.end(), laid.begin() + (nodes.empty() ? 0 : 1), laid.end());
        ends.push_back(static_cast<int>(nodes.size()) - 1);
    }

    double link;              // [D]
    std::vector<Vec3> nodes;  // [m]
    std::vector<int> ends{0};
};

class Drawing {
  public:
    explicit Drawing(double link) : Drawing(Hooked(link)) {}

    Clasp draw() {
        constexpr int most_ticks = 2000, rest = 100;
        constexpr double speed = 0.025 * default_diameter;  // in a tick
        Clasp result{.excess = NAN, .tips = NAN, .gap = NAN};
        const auto tight = [&] { return pull() >= pull_strain; };
        for (int i = 0; i < most_ticks && !tight(); ++i) result.pass_throughs += move(speed);
        if (!tight()) return result;
        for (int i = 0; i < rest; ++i) result.pass_throughs += move(0);
        result.excess = excess() / default_diameter;
        result.tips = (tip(0) - tip(2)).norm() / default_diameter;
        result.gap = Gauge(thread_).gap(thread_.nodes());
        return result;
    }

  private:
    explicit Drawing(const Hooked& hooked) : thread_(limp(), hooked.nodes), ends_(hooked.ends) {}

    static ThreadDef limp() {
        return {.friction = 0, .elastic = sim::thread::RodDef{.bending_share = 1e-3, .axial_over_bending = 0}};
    }
    const Vec3& node(int i) const { return thread_.nodes()[static_cast<std::size_t>(i)]; }
    const Vec3& end(std::size_t k) const { return node(ends_[k]); }

    int move(double by) {
        const auto held = [&](std::size_t k, double way) { return Hold{ends_[k], end(k) + way * Vec3::UnitZ()}; };
        const Hold holds[] = {held(0, by), held(1, by), held(2, -by), held(3, -by)};
        constexpr int owners[] = {0, 0, 1, 1};
        return thread_.tick({holds, owners, {}, nullptr}).pass_throughs;
    }

    // Strain of the first link of either bight, the smaller of both.
    double pull() const {
        const auto strain = [&](std::size_t k) {
            return (node(ends_[k] + 1) - end(k)).norm() / thread_.rest_lengths()[static_cast<std::size_t>(ends_[k])] -
                   1;
        };
        return std::min(strain(0), strain(2));
    }

    double length(std::size_t bight) const {
        double sum = 0;
        for (int i = ends_[bight]; i < ends_[bight + 1]; ++i) sum += (node(i + 1) - node(i)).norm();
        return sum;
    }

    double excess() const { return length(0) + length(2) - 2 * (end(0).z() - end(2).z()); }

    // Where the bight goes across the axis.
    Vec3 tip(std::size_t bight) const {
        const int middle = ends_[bight] + ends_[bight + 1];
        return 0.5 * (node(middle / 2) + node((middle + 1) / 2));
    }

    Thread thread_;
    std::vector<int> ends_;
};

}  // namespace

Clasp clasp(double link_in_diameters) {
    return Drawing(link_in_diameters).draw();
}

std::vector<Row> clasp_rows(bool quick) {
    constexpr double critical = 4.263, most_off = 3;  // [D], [%]
    std::vector<Row> rows;
    for (const int pieces : quick ? std::vector{1, 2} : std::vector{1, 2, 4, 8}) {
        const Stopwatch watch;
        const Clasp found = clasp(1.0 / pieces);
        const std::string id = "elastic-clasp-link" + std::to_string(pieces),
                          what = "elastic thread, tight clasp, links of D/" + std::to_string(pieces) + ": ";
        const auto add = [&](const char* name, const char* of, double value, const char* unit,
                             std::optional<double> bound = {}) {
            rows.push_back(
                {.id = id + name, .what = what + of, .value = value, .unit = unit, .bound = bound, .error = {}});
        };
        const auto off = [](double excess) { return 100 * std::abs(excess / critical - 1); };
        add("", "excess length", found.excess, "D");
        rows.back().seconds = watch.seconds();
        add("-off", "excess length, off the critical clasp's", off(found.excess), "%", most_off);
        add("-gap", "how far apart its strands' centre lines are", found.gap, "D");
        add("-by-gap-off", "excess length over that, off the critical clasp's", off(found.excess / found.gap), "%",
            most_off);
        add("-tips-by-gap", "how far apart its tips are, over that", found.tips / found.gap, "ratio");
        add("-passes", "pass-throughs", found.pass_throughs, "count", 0);
    }
    return rows;
}

}  // namespace bench::lab
