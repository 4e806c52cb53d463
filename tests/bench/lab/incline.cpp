#include "tests/bench/lab/incline.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/words.hpp"

namespace bench::lab {

namespace {

using sim::thread::RodDef;
using sim::thread::Thread;
using sim::thread::Vec3;

constexpr double gravity = 9.81;
constexpr int incline_links = 20;

// The plane goes down towards +x.
struct Slope {
    explicit Slope(const Incline& incline) : of(incline), thread(def(incline), nodes()) {}

    double angle() const { return std::atan(of.share * of.friction); }
    Vec3 down() const { return {std::cos(angle()), 0, -std::sin(angle())}; }
    Vec3 up() const { return {std::sin(angle()), 0, std::cos(angle())}; }

    static sim::thread::ThreadDef def(const Incline& incline) {
        return {.friction = incline.friction, .elastic = RodDef{.axial_over_bending = 0, .gravity = {0, 0, -gravity}}};
    }

    std::vector<Vec3> nodes() const {
        std::vector<Vec3> found;
        for (int i = 0; i <= incline_links; ++i)
            found.push_back(0.5 * default_diameter * up() +
                            i * of.link * default_diameter * (of.across ? Vec3::UnitY() : down()));
        return found;
    }

    // One triangle, so large that no slide comes near its sides.
    sim::geometry::TriangleTree plane() const {
        constexpr double far = 1;  // [m]
        return sim::geometry::TriangleTree(
            {{-far * down() - far * Vec3::UnitY(), 2 * far * down(), -far * down() + far * Vec3::UnitY()}});
    }

    void tick() {
        thread.tick({.holds = {}, .hold_owners = {}, .capsules = {}, .surface = &surface, .seconds = of.tick});
    }
    double middle() const { return thread.nodes()[incline_links / 2].dot(down()); }  // how far down [m]

    Incline of;
    Thread thread;
    const sim::geometry::TriangleTree surface = plane();
};

double moved(const Slope& slope, const std::vector<Vec3>& from) {
    double most = 0;
    for (std::size_t i = 0; i < from.size(); ++i) most = std::max(most, (slope.thread.nodes()[i] - from[i]).norm());
    return most / default_diameter;
}

}  // namespace

Compared incline_acceleration(const Incline& incline) {
    constexpr double part = 0.25;  // [s]
    Slope slope(incline);
    const int ticks = static_cast<int>(std::lround(part / incline.tick));
    const auto run = [&](int count) {
        for (int i = 0; i < count; ++i) slope.tick();
    };
    const auto speed = [&] {
        const double before = slope.middle();
        run(1);
        return (slope.middle() - before) / incline.tick;
    };
    run(ticks - 1);
    const double first = speed();
    run(ticks - 1);
    const double angle = slope.angle();
    return {(speed() - first) / (ticks * incline.tick),
            gravity * (std::sin(angle) - incline.friction * std::cos(angle))};
}

double incline_drift(const Incline& incline, double seconds) {
    Slope slope(incline);
    const std::vector<Vec3> start = slope.nodes();
    double most = 0;
    for (double t = 0; t < seconds && most < 1; t += incline.tick) {
        slope.tick();
        most = std::max(most, moved(slope, start));
    }
    return most;
}

static void add_rows(std::vector<Row>& rows, const Incline& on, double seconds) {
    const std::string id = "elastic-incline-mu" + whole(10 * on.friction) + "-link" + whole(on.link) + "-tick" +
                           whole(1000 * on.tick) + (on.across ? "-across" : "");
    const std::string what = "elastic thread on an incline, friction 0." + whole(10 * on.friction) + ", links of " +
                             whole(on.link) + " D, ticks of " + whole(1000 * on.tick) + " ms, " +
                             (on.across ? "level" : "down the slope") + ", ";
    Incline steep = on, flat = on;
    steep.share = 1.02, flat.share = 0.98;
    double begin = processor_time();
    const double error = 100 * std::abs(incline_acceleration(steep).error());
    rows.push_back({.id = id + "-slides",
                    .what = what + "1.02 of what slides: error of its acceleration",
                    .value = error,
                    .unit = "%",
                    .bound = 5,
                    .error = {},
                    .seconds = processor_time() - begin});
    begin = processor_time();
    const double drift = incline_drift(flat, seconds);
    rows.push_back({.id = id + "-holds",
                    .what = what + "0.98: drift in " + whole(seconds) + " s",
                    .value = drift,
                    .unit = "D",
                    .bound = 0.1,
                    .error = {},
                    .seconds = processor_time() - begin});
}

std::vector<Row> incline_rows(bool quick) {
    std::vector<Row> rows;
    for (const double friction : {0.1, 0.3})
        for (const double tick : {1e-3, 4e-3})
            for (const double link : quick ? std::vector{1.0} : std::vector{1.0, 4.0})
                for (const bool across : quick ? std::vector{false} : std::vector{false, true})
                    add_rows(rows, {.friction = friction, .share = 1, .link = link, .tick = tick, .across = across},
                             quick ? 4 : 60);
    return rows;
}

}  // namespace bench::lab
