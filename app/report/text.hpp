#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace app::report {

/// Text safe between tags and inside quoted attributes. Control characters, which HTML forbids, become blanks.
std::string escaped(std::string_view text);

/// RFC 4648, section 4, with padding.
std::string base64(const std::vector<unsigned char>& bytes);

/// Fixed notation, independent of the locale; a dash where the number is not finite.
std::string number(double value, int decimals);

}  // namespace app::report
