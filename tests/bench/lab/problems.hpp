#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/rod_cases.hpp"

namespace bench::lab {

/// Who moves a thread, and how finely.
struct Setting {
    bool elastic;  ///< Else ftl.
    double link;   ///< Its length in diameters, or how many there are, as the problem says.
    double tick;   ///< [s]
};

/// What theory knows the answer to, for a thread that is moved by either model.
struct Problem {
    std::string id, what;       ///< "capstan-half"
    std::string links;          ///< What `link` counts.
    std::vector<double> link;   ///< From coarse to fine.
    std::vector<double> ticks;  ///< [s], from long to short.
    std::function<Compared(const Setting&, Cost&)> with;
    bool ranks = false;  ///< Theory has no number, and only says that what is found is above 1.
};
std::vector<Problem> problems();

/// For the rod alone, whose answer is an equilibrium: no ticks, so many links.
std::vector<RodCase> still_problems();

}  // namespace bench::lab
