#pragma once
#include <cmath>

#include "tests/bench/lab/core.hpp"

namespace bench::lab {

/// Of this length [s] there are so many in `seconds`.
inline int ticks_in(double seconds, double tick) {
    return static_cast<int>(std::lround(seconds / tick));
}

/// What a thread's ticks cost; what is measured between them does not count.
class Cost {
  public:
    int links = 0;  ///< Of the thread.

    /// Makes a tick by calling `tick`, and hands on its report.
    template <class Tick>
    auto of(const Tick& tick) {
        const double begin = processor_time();
        const auto report = tick();
        spent_ += processor_time() - begin;
        sweeps_ += report.sweeps;
        ++ticks_;
        return report;
    }

    /// Processor time of a simulated second in ticks this long [s]; 1000 ms is real time [ms].
    double per_second(double tick) const { return 1000 * spent_ / (ticks_ * tick); }
    double sweeps() const { return sweeps_ / ticks_; }  ///< Over contacts, mean of a tick.

  private:
    double spent_ = 0, sweeps_ = 0, ticks_ = 0;
};

}  // namespace bench::lab
