#include "tests/bench/suites/speed.hpp"

#include "tests/bench/lab/core.hpp"

namespace bench::suites {

using namespace lab;

Suite speed_suite(bool quick, const Progress& progress) {
    const OneCore pinned;
    Suite suite{"speed", {}};
    add_pulls(suite, quick, progress);
    add_growth(suite, quick, progress);
    add_trade_off(suite, quick, progress);
    add_fitted(suite, progress);
    add_effects(suite, quick, progress);
    return suite;
}

}  // namespace bench::suites
