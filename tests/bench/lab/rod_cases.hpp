#pragma once
#include <functional>
#include <string>
#include <vector>

namespace bench::lab {

/// What a case came to, and what theory says of it, in the same unit.
struct Compared {
    double found, reference;

    double error() const { return found / reference - 1; }
};

/// A load that theory knows the answer to, on a rod of so many links.
struct RodCase {
    std::string id;  ///< "cantilever-tip-10"
    std::string what;
    std::function<Compared(int links)> at;
    double bound;     ///< Of the error, where it must hold:
    int bound_links;  ///< at so many links, and finer.
};

/// All of them: cantilevers under a load at the tip and under their own weight, Euler's strut before and far past
/// buckling, the twisted ring, the twisted rod, the helix that it springs into, catenaries, the hanging chain's swing
/// in two ticks. References: surgery-and-physics.md D2 to D8 and D20; sources are given where a case is defined.
std::vector<RodCase> rod_cases();

}  // namespace bench::lab
