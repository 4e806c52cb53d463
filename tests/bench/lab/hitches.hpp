#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bench::lab {

/// What a thread that is pulled tight round a bar was called while it was pulled.
struct OnBar {
    std::string curve;           ///< "p138"
    std::string expected, last;  ///< Its name, and the one in the end.
    int names = 0, other = 0;    ///< 50 a second; others than expected.
    int pass_throughs = 0;
    double drawn_out = 0;  ///< By which the pulled ends came out in the end [D].
};

/// The labelled curves of `folder` that are bowlines or hitches.
std::vector<std::string> curves_on_bar();

/// One of them round a steel bar: a bowline pulled by its standing part, a hitch by both ends, at 20 mm/s until it is
/// tight.
OnBar hitch_on_bar(const std::filesystem::path& folder, const std::string& curve);

}  // namespace bench::lab
