#pragma once
#include <chrono>

namespace app {

/// How far long work is, on stderr, and only where that is a terminal; gone again when the work is done.
class Progress {
  public:
    /// `whole_s`: simulated time that the work will take [s], above 0.
    explicit Progress(double whole_s);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Call as often as you like: ten times a second it looks at the clock and draws.
    void at(double done_s);

  private:
    double whole_s_;
    bool shown_;
    std::chrono::steady_clock::time_point next_;
};

}  // namespace app
