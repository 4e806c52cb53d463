#pragma once
#include <vector>

#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

/// Keeps every bend no tighter than a round thread can: none has a radius below its own.
class BendLimit {
  public:
    /// Measures the limit at the links that the thread has.
    explicit BendLimit(const State& state);
    /// Measures the limit anew, after links have changed.
    void resize(const State& state);

    /// Makes one pass from the first node to the last: outer ends of two links that bend too tightly move apart. O(n).
    void limit(State& state) const;

  private:
    std::vector<double> least_span_;  // per inner node: least distance of its neighbours [m]
};

}  // namespace sim::thread::ftl
