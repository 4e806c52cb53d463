#include <cmath>

#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/thread_rope.hpp"
#include "tests/bench/suites/speed.hpp"

namespace bench::suites {

using namespace lab;

namespace {

constexpr double growth_link = 1e-3;  // [m], as long as the thread is thick

/// A coil of thread whose ends are slowly drawn out.
struct Lying {
    std::string id, words;
    double radius, pitch;  ///< In links.
};

const Lying lying[] = {{"loose", "turns ten diameters apart", 20, 10},  // touches nowhere
                       {"coiled", "turn beside turn", 5, 1.05}};        // every link near four others

// Median processor time of a tick [us].
double cost_of(const Lying& how, int links) {
    const std::vector<Vec3> start = coil(links, growth_link, how.radius * growth_link, how.pitch * growth_link);
    ThreadRope rope({.links = links, .length = links * growth_link}, start);
    constexpr int warm_up = 50, ticks = 250;
    constexpr double step = 0.01 * growth_link;  // a tick: 10 mm/s, a surgeon's median
    std::vector<double> us;
    for (int i = 1; i <= ticks; ++i) {
        const Vec3 out = i * step * Vec3::UnitX();
        const double begin = processor_time();
        rope.tick(start.front() - out, start.back() + out);
        if (i > warm_up) us.push_back(1e6 * (processor_time() - begin));
    }
    return percentile(us, 0.5);
}

struct Fit {
    double exponent, error;  ///< Error: one standard deviation of the slope, from what the line leaves over.
};

// Least squares of log cost against log n.
Fit fit(const std::vector<double>& n, const std::vector<double>& cost) {
    const auto count = static_cast<double>(n.size());
    double x = 0, y = 0, xx = 0, xy = 0, rest = 0;
    for (std::size_t i = 0; i < n.size(); ++i) x += std::log(n[i]) / count, y += std::log(cost[i]) / count;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const double dx = std::log(n[i]) - x;
        xx += dx * dx, xy += dx * (std::log(cost[i]) - y);
    }
    for (std::size_t i = 0; i < n.size(); ++i)
        rest += std::pow(std::log(cost[i]) - y - xy / xx * (std::log(n[i]) - x), 2);
    return {xy / xx, std::sqrt(rest / (count - 2) / xx)};
}

}  // namespace

void add_growth(Suite& suite, bool quick, const Progress& progress) {
    std::vector<double> sizes{100, 300, 1000};
    if (!quick) sizes.insert(sizes.end(), {3000, 10000});
    for (const Lying& how : lying) {
        progress("growth, " + how.words);
        const Stopwatch all;
        std::vector<double> costs;
        for (const double links : sizes) {
            const Stopwatch watch;
            costs.push_back(cost_of(how, static_cast<int>(links)));
            const std::string n = std::to_string(static_cast<int>(links));
            const std::string words = n + " links, " + how.words + ": median tick";
            suite.rows.push_back(told("growth-" + how.id + "-n" + n, words, costs.back(), "us", watch.seconds()));
        }
        const Fit found = fit(sizes, costs);
        const std::string words = how.words + ": cost grows as links to the power of";
        Row row = told("growth-" + how.id + "-exponent", words, found.exponent, "power", all.seconds());
        row.bound = 1.2, row.error = found.error;
        suite.rows.push_back(row);
    }
}

}  // namespace bench::suites
