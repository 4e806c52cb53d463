#include "tests/bench/suites/ties.hpp"

#include <algorithm>

#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/ties.hpp"

namespace bench::suites {

using namespace lab;

// The least that any seed of 1100 came to, with any friction [D]; to tell loose from tight, not a law.
static double takes_up_when_tight(Knot knot) {
    constexpr double least[] = {11, 14, 18, 18, 22, 23, 36, 26};  // in the order of Knot
    return least[static_cast<std::size_t>(knot)];
}

namespace {

/// Of many seeds.
struct TieTally {
    double passes = 0, changed = 0, stretch = 0, seconds = 0;
    std::vector<double>
        left;  ///< Where there was no friction: a thread that follows its hands comes as tight as an ideal one.
};

TieTally tally(int seeds, bool elastic, const Progress& progress) {
    const Stopwatch watch;
    TieTally all;
    for (int seed = 0; seed < seeds; ++seed) {
        const Tied tied = ties(static_cast<std::uint64_t>(seed), {}, elastic);
        if (progress && !tied.good())
            progress(words(static_cast<std::uint64_t>(seed), tie_of(static_cast<std::uint64_t>(seed)), tied));
        all.passes += tied.pass_throughs;
        all.changed += tied.changed();
        all.stretch = std::max(all.stretch, tied.stretch);
        if (const Tie tie = tie_of(static_cast<std::uint64_t>(seed)); tie.friction == 0)
            all.left.push_back(tied.left / takes_up_when_tight(tie.knot));
    }
    all.seconds = watch.seconds();
    return all;
}

std::string words_of(int seeds, bool elastic) {
    return std::to_string(seeds) + " seeded ties of eight knots" + (elastic ? ", elastic thread: " : ": ");
}

}  // namespace

static std::vector<Row> elastic_ties_rows(int seeds, const Progress& progress) {
    const TieTally all = tally(seeds, true, progress);
    const std::string what = words_of(seeds, true);
    return {{.id = "elastic-ties-passes",
             .what = what + "pass-throughs",
             .value = all.passes,
             .unit = "count",
             .bound = 0,
             .error = {},
             .seconds = all.seconds},
            {.id = "elastic-ties-changed",
             .what = what + "knots whose name changed: loops may slip over an end",
             .value = all.changed,
             .unit = "count",
             .bound = {},
             .error = {}},
            {.id = "elastic-ties-stretch",
             .what = what + "worst link at any time; tools wait at a tenth",
             .value = all.stretch,
             .unit = "share",
             .bound = 0.100001,
             .error = {}}};
}

static std::vector<Row> ftl_ties_rows(int seeds, const Progress& progress) {
    const TieTally all = tally(seeds, false, progress);
    const std::string what = words_of(seeds, false);
    return {{.id = "ties-passes",
             .what = what + "pass-throughs",
             .value = all.passes,
             .unit = "count",
             .bound = 0,
             .error = {},
             .seconds = all.seconds},
            {.id = "ties-changed",
             .what = what + "knots whose name changed",
             .value = all.changed,
             .unit = "count",
             .bound = 0,
             .error = {}},
            {.id = "ties-slack",
             .what = what + "without friction, what the knot takes up in the end over what it takes up tight; median",
             .value = percentile(all.left, 0.5),
             .unit = "ratio",
             .bound = {},
             .error = {}},
            {.id = "ties-stretch",
             .what = what + "worst link at any time",
             .value = all.stretch,
             .unit = "share",
             .bound = {},
             .error = {}}};
}

Suite ties_suite(bool quick, const Progress& progress) {
    return {"ties", ftl_ties_rows(quick ? 200 : 10000, progress)};
}
Suite elastic_ties_suite(bool quick, const Progress& progress) {
    return {"elastic-ties", elastic_ties_rows(quick ? 20 : 1000, progress)};
}

std::vector<Row> ties_rows(bool quick) {
    std::vector<Row> rows = ftl_ties_rows(quick ? 200 : 1000, {});  // all are suites of their own
    for (Row& row : elastic_ties_rows(quick ? 20 : 100, {})) rows.push_back(std::move(row));
    return rows;
}

}  // namespace bench::suites
