#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/bench/lab/capstan.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/words.hpp"

namespace bench::lab {

namespace {

struct Angle {
    const char *id, *words;
    double radians;
};

using std::numbers::pi;

constexpr std::array angles = {Angle{"quarter", "a quarter turn", 0.5 * pi}, Angle{"half", "half a turn", pi},
                               Angle{"one", "one turn", 2 * pi}, Angle{"one-and-half", "one and a half turns", 3 * pi}};
constexpr std::array capstan_ticks = {1.0 / 250, 1.0 / 1000, 1.0 / 4000};  // [s]

// Of the exponents' ratios at all rates: largest deviation from 1, and spread.
struct OverRates {
    double deviation = 0, spread = 0;
};

OverRates over_rates(double wrap, double friction, double link) {
    OverRates result;
    double least = 1e300, most = 0;
    for (const double tick : capstan_ticks) {
        const Capstan measured = capstan({wrap, friction, tick, link});
        result.deviation = std::max(result.deviation, measured.deviation());
        least = std::min(least, measured.ratio);
        most = std::max(most, measured.ratio);
    }
    result.spread = most - least;
    return result;
}

}  // namespace

std::vector<Row> capstan_rows(bool quick) {
    std::vector<Row> rows;
    for (const double link : {1.0, 0.5}) {
        Row spread{
            .id = "capstan-spread-link" + tenths(link),
            .what = "capstan exponent at 250, 1000 and 4000 Hz: largest difference, links of " + tenths(link) + "/10 D",
            .unit = "share",
            .bound = 0.05,
            .error = {}};
        for (const Angle& angle : angles)
            for (const double friction : quick ? std::vector{0.2} : std::vector{0.1, 0.2, 0.3}) {
                const Stopwatch watch;
                const OverRates found = over_rates(angle.radians, friction, link);
                rows.push_back(
                    {.id = std::string("capstan-") + angle.id + "-mu" + tenths(friction) + "-link" + tenths(link),
                     .what = std::string("capstan, ") + angle.words + ", friction 0." + tenths(friction) +
                             ", links of " + tenths(link) + "/10 D: exponent against the discrete law",
                     .value = found.deviation,
                     .unit = "share",
                     .bound = 0.15,
                     .error = found.spread,
                     .seconds = watch.seconds()});
                spread.value = std::max(spread.value, found.spread);
                spread.seconds += rows.back().seconds;
            }
        rows.push_back(spread);
    }
    return rows;
}

}  // namespace bench::lab
