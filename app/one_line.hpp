#pragma once
#include <algorithm>
#include <string>

namespace app {

/// Words of files and libraries may hold anything; a terminal gets one line.
inline std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
    return text + '\n';
}

}  // namespace app
