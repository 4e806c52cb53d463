#pragma once
#include <chrono>

namespace app {

/// How far long work is, on stderr, and only where that is a terminal; gone again when the work is done.
class Progress {
  public:
    /// `whole`: how much work there is, above 0; in simulated seconds if nothing else is said.
    explicit Progress(double whole, const char* unit = "s");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Call as often as you like: ten times a second it looks at the clock and draws.
    void at(double done);

  private:
    double whole_;
    const char* unit_;
    bool shown_;
    std::chrono::steady_clock::time_point next_;
};

}  // namespace app
