#pragma once
#include <string>
#include <vector>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// How fast the thread is and how right at that speed, against peers in the same run; all on one core. `quick`: once
/// instead of several times, without the long threads.
lab::Suite speed_suite(bool quick, const lab::Progress& progress);

/// The parts of it. The overhand pull, by us and by peers (pulls.cpp).
void add_pulls(lab::Suite& suite, bool quick, const lab::Progress& progress);
/// Cost of a tick over the number of links (growth.cpp).
void add_growth(lab::Suite& suite, bool quick, const lab::Progress& progress);
/// The overhand pull over link length and tick (trade_off.cpp).
void add_trade_off(lab::Suite& suite, bool quick, const lab::Progress& progress);
/// Links halved where they are needed against short ones everywhere (fitted.cpp).
void add_fitted(lab::Suite& suite, const lab::Progress& progress);
/// What each effect of an elastic thread costs a tick of the overhand pull (effects_cost.cpp).
void add_effects(lab::Suite& suite, bool quick, const lab::Progress& progress);
/// A figure without a bound.
inline lab::Row told(std::string id, std::string what, double value, std::string unit, double seconds) {
    lab::Row row;
    row.id = std::move(id), row.what = std::move(what), row.unit = std::move(unit);
    row.value = value, row.seconds = seconds;
    return row;
}

/// What add_trade_off found, drawn: error over cost (SVG).
std::string trade_off_picture(const lab::Suite& suite);

}  // namespace bench::suites
