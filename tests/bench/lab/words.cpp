#include "tests/bench/lab/words.hpp"

#include <cmath>
#include <cstdio>

namespace bench::lab {

static std::string printed(const char* form, double value) {
    char text[32];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

std::string whole(double value) {
    return std::to_string(std::lround(value));
}

std::string tenths(double value) {
    return whole(10 * value);
}

std::string digits(double value) {
    return printed("%g", value);
}

std::string figure(double value) {
    return printed("%.4g", value);
}

}  // namespace bench::lab
