#pragma once
#include <sched.h>
#include <time.h>

namespace bench::lab {

constexpr double mm = 1e-3;  ///< [m]

/// Processor time of this thread [s]: other people's work on the machine does not count.
inline double processor_time() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Keeps this thread, and the programs it starts meanwhile, on the core it is on: caches stay warm.
class OneCore {
  public:
    OneCore() {
        known_ = sched_getaffinity(0, sizeof before_, &before_) == 0;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<unsigned>(sched_getcpu()), &one);
        if (known_) sched_setaffinity(0, sizeof one, &one);
    }
    ~OneCore() {
        if (known_) sched_setaffinity(0, sizeof before_, &before_);
    }
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

  private:
    bool known_;
    cpu_set_t before_;
};

}  // namespace bench::lab
