#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace app {

Progress::Progress(double whole, const char* unit)
    : whole_(whole), unit_(unit), shown_(isatty(STDERR_FILENO) != 0), next_(std::chrono::steady_clock::now()) {}

void Progress::at(double done) {
    const auto now = shown_ ? std::chrono::steady_clock::now() : next_;
    if (!shown_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    constexpr int width = 40;
    const int decimals = unit_[0] == 's' ? 2 : 0;
    const int full = static_cast<int>(width * std::clamp(done / whole_, 0.0, 1.0));
    const std::string bar = std::string(full, '#') + std::string(width - full, '.');
    std::fprintf(stderr, "\r[%s] %.*f of %.*f %s", bar.c_str(), decimals, done, decimals, whole_, unit_);
}

Progress::~Progress() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
}

}  // namespace app
