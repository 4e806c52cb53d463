#pragma once
#include <string>
#include <vector>

#include "app/bench/row.hpp"

namespace app::bench {

/// How fast the thread is and how right at that speed, against peers in the same run; all on one core. `quick`: once
/// instead of several times, without the long threads.
Suite speed_suite(bool quick, const Progress& progress);

/// The parts of it. The overhand pull, by us and by peers (pulls.cpp).
void add_pulls(Suite& suite, bool quick, const Progress& progress);
/// Cost of a tick over the number of links (growth.cpp).
void add_growth(Suite& suite, bool quick, const Progress& progress);
/// The overhand pull over link length and tick (trade_off.cpp).
void add_trade_off(Suite& suite, bool quick, const Progress& progress);
/// Links halved where they are needed against short ones everywhere (fitted.cpp).
void add_fitted(Suite& suite, const Progress& progress);
/// What each effect of an elastic thread costs a tick of the overhand pull (effects_cost.cpp).
void add_effects(Suite& suite, bool quick, const Progress& progress);
/// A figure without a bound.
inline Row told(std::string id, std::string what, double value, std::string unit, double seconds) {
    Row row;
    row.id = std::move(id), row.what = std::move(what), row.unit = std::move(unit);
    row.value = value, row.seconds = seconds;
    return row;
}

/// What add_trade_off found, drawn: error over cost (SVG).
std::string trade_off_picture(const Suite& suite);

}  // namespace app::bench
