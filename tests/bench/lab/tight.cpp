#include <cmath>

#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/laws.hpp"
#include "tests/bench/lab/stopwatch.hpp"

namespace bench::lab {

Tight tight(double link_in_diameters, double friction, double speed, double length_in_diameters) {
    constexpr int most_ticks = 6000;
    const double diameter = 2 * ThreadDef{}.radius, link = link_in_diameters * diameter;
    Thread thread(
        {.friction = friction},
        loose_thread(Knot::trefoil, static_cast<int>(length_in_diameters / link_in_diameters), link, 0.5 * diameter)
            .nodes);
    Apart pull(thread);
    Tight result;
    result.least = tighten(thread, pull, speed, most_ticks);
    result.in_the_end = taken_up(thread);
    result.cost = pull.cost;
    result.cost.links = static_cast<int>(thread.rest_lengths().size());
    return result;
}

std::vector<Row> tight_rows(bool quick) {
    std::vector<Row> rows;
    for (const int pieces : quick ? std::vector{1} : std::vector{1, 2, 4})
        for (const double friction : {0.0, 0.15}) {
            const Stopwatch watch;
            const Tight found = tight(1.0 / pieces, friction);
            const std::string id = "tight-overhand-link" + std::to_string(pieces) + (friction > 0 ? "-mu15" : "-mu0");
            const std::string what = "tight open overhand, links of D/" + std::to_string(pieces) +
                                     (friction > 0 ? ", friction 0.15: " : ", no friction: ");
            // An ideal rope takes up 10.1 D; a tenth more for links that are not a curve.
            rows.push_back({.id = id,
                            .what = what + "takes up",
                            .value = found.in_the_end,
                            .unit = "D",
                            .bound = 11.1,
                            .error = {},
                            .seconds = watch.seconds()});
            rows.push_back({.id = id + "-least",
                            .what = what + "least at any time",
                            .value = found.least,
                            .unit = "D",
                            .bound = 10.0,
                            .must = Must::be_at_least,
                            .error = {}});
        }
    // However fast it is pulled, a knot of the same thread is tight at the same size.
    for (const double speed : quick ? std::vector{0.05} : std::vector{0.01, 0.05, 0.2, 1.0}) {
        const Stopwatch watch;
        const Tight found = tight(1, 0.15, speed, 120);
        const std::string mm_s = std::to_string(static_cast<int>(std::lround(1000 * speed)));
        rows.push_back(
            {.id = "tight-overhand-at-" + mm_s,
             .what = "tight open overhand of 120 links of D, friction 0.15, pulled at " + mm_s + " mm/s: takes up",
             .value = found.in_the_end,
             .unit = "D",
             .bound = 11.1,
             .error = {},
             .seconds = watch.seconds()});
    }
    return rows;
}

}  // namespace bench::lab
