#include <algorithm>

#include "app/bench/gauge.hpp"
#include "app/bench/stopwatch.hpp"
#include "app/bench/ties.hpp"

namespace app::bench {

// The least that any seed of 1100 came to, with any friction [D]; to tell loose from tight, not a law.
static double takes_up_when_tight(Knot knot) {
    constexpr double least[] = {11, 14, 18, 18, 22, 23, 36, 26};  // in the order of Knot
    return least[static_cast<std::size_t>(knot)];
}

std::vector<Row> ties_rows(bool quick) {
    const int seeds = quick ? 200 : 1000;
    const Stopwatch watch;
    double passes = 0, changed = 0, stretch = 0;
    std::vector<double> left;  // where there was no friction: a thread that follows its hands comes as tight as an ideal one
    for (int seed = 0; seed < seeds; ++seed) {
        const Tied tied = ties(static_cast<std::uint64_t>(seed));
        passes += tied.pass_throughs;
        changed += tied.changed();
        stretch = std::max(stretch, tied.stretch);
        if (const Tie tie = tie_of(static_cast<std::uint64_t>(seed)); tie.friction == 0) left.push_back(tied.left / takes_up_when_tight(tie.knot));
    }
    const std::string what = std::to_string(seeds) + " seeded ties of eight knots: ";
    return {{.id = "ties-passes", .what = what + "pass-throughs", .value = passes, .unit = "count", .bound = 0, .error = {},
        .seconds = watch.seconds()},
            {.id = "ties-changed", .what = what + "knots whose name changed", .value = changed, .unit = "count", .bound = 0,
                .error = {}},
            {.id = "ties-slack", .what = what
                + "without friction, what the knot takes up in the end over what it takes up tight; median",
                .value = percentile(left, 0.5),
             .unit = "ratio", .bound = {}, .error = {}},
            {.id = "ties-stretch", .what = what + "worst link at any time", .value = stretch, .unit = "share", .bound = {},
                .error = {}}};
}

}  // namespace app::bench
