#pragma once
#include "app/bench/row.hpp"

namespace app::bench {

/// The shipped knot drills by their own motions, with other threads, links and ticks. A row's `error` is how far its
/// figure is from the same drill's in a fine run. Cost: minutes. `quick`: the first drill as it is, and no fine run to
/// be off.
void add_drills(Suite& suite, bool quick, const Progress& progress);

}  // namespace app::bench
