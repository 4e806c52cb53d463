#pragma once
#include <vector>

#include "tests/bench/lab/row.hpp"

namespace bench::lab {

/// A limp thread hung by half a turn over a straight strand of itself that is held all along, links of half a diameter,
/// friction 0.2, drawn over it against a load: ln(pull / load) / pi is the friction that it slides by [Euler and
/// Eytelwein]. At speeds by which it goes on by a hundredth and a tenth of its thickness in a millisecond. Some ten
/// seconds.
std::vector<Row> strand_capstan_rows(bool quick);

}  // namespace bench::lab
