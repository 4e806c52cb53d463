#include <malloc.h>

#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/laws.hpp"
#include "tests/bench/lab/stopwatch.hpp"

namespace bench::lab {

// Bytes in use on the heap.
static double heap() {
    return static_cast<double>(mallinfo2().uordblks);
}

// Grown between the first round of the same motion and the last, for rounds of 1000 ticks.
static Row while_moving(int rounds) {
    const Stopwatch watch;
    const double radius = ThreadDef{}.radius;
    Thread thread({}, loose_thread(Knot::trefoil, 100, 2 * radius, radius).nodes);
    Apart pull(thread);
    const auto round = [&] {
        for (int i = 0; i < 1000; ++i) pull.by(thread, i < 500 ? 0.02e-3 : -0.02e-3);
    };
    round();
    const double before = heap();
    for (int i = 1; i < rounds; ++i) round();
    const double grown = heap() - before;
    return {.id = "memory-moving",
            .what = "heap grown after the first second of " + std::to_string(rounds) +
                    " s of pulling an overhand and letting it go",
            .value = grown,
            .unit = "bytes",
            .bound = 0,
            .error = {},
            .seconds = watch.seconds()};
}

static void at_rest(int ticks, std::vector<Row>& rows) {
    const double radius = ThreadDef{}.radius;
    Thread thread({}, loose_thread(Knot::trefoil, 200, 2 * radius, radius).nodes);
    Apart pull(thread);
    tighten(thread, pull, 0.1, 1000);
    for (int i = 0; i < 1000; ++i) pull.by(thread, 0);
    const double before = heap();
    const Stopwatch watch;
    for (int i = 0; i < ticks; ++i) pull.by(thread, 0);
    const double seconds = watch.seconds(), grown = heap() - before;
    rows.push_back({.id = "memory-rest",
                    .what = "heap grown in " + std::to_string(ticks) + " ticks at rest",
                    .value = grown,
                    .unit = "bytes",
                    .bound = 0,
                    .error = {},
                    .seconds = seconds});
    rows.push_back({.id = "rest-tick",
                    .what = "tick at rest, tight overhand of 200 links or more",
                    .value = 1e6 * seconds / ticks,
                    .unit = "us",
                    .bound = {},
                    .error = {},
                    .seconds = seconds});
}

std::vector<Row> memory_rows(bool quick) {
    std::vector<Row> rows{while_moving(quick ? 2 : 10)};
    at_rest(quick ? 100'000 : 10'000'000, rows);
    return rows;
}

}  // namespace bench::lab
