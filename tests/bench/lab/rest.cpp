#include <cmath>

#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/laws.hpp"
#include "tests/bench/lab/stopwatch.hpp"

namespace bench::lab {

double motion_at_rest(Knot knot) {
    constexpr double speed = 0.05;  // [m/s]
    constexpr int most_ticks = 3000, a_second = 1000;
    const double radius = ThreadDef{}.radius;
    Thread thread({}, loose_thread(knot, 150, 2 * radius, radius).nodes);
    Apart pull(thread);
    tighten(thread, pull, speed, most_ticks);
    for (int i = 0; i < a_second; ++i) pull.by(thread, 0);
    double squares = 0;
    std::vector<Vec3> before;
    for (int i = 0; i < a_second; ++i) {
        before.assign(thread.nodes().begin(), thread.nodes().end());
        pull.by(thread, 0);
        for (std::size_t n = 0; n < before.size(); ++n) squares += (thread.nodes()[n] - before[n]).squaredNorm();
    }
    return std::sqrt(squares / (a_second * static_cast<double>(before.size()))) / radius;
}

std::vector<Row> rest_rows(bool quick) {
    std::vector<Row> rows;
    for (const Knot knot : quick ? std::vector{Knot::trefoil, Knot::square}
                                 : std::vector{Knot::trefoil, Knot::square, Knot::granny, Knot::surgeons}) {
        const Stopwatch watch;
        std::string id = known(knot).words;
        std::erase(id, '\'');
        const double motion = motion_at_rest(knot);
        rows.push_back(
            {.id = "rest-" + id,
             .what = std::string("at rest after a second, tight ") + known(knot).words + ": RMS node motion a tick",
             .value = motion,
             .unit = "R",
             .bound = 1e-3,
             .error = {},
             .seconds = watch.seconds()});
    }
    return rows;
}

}  // namespace bench::lab
