#pragma once
#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// 6-0 thread through the walls of a clamped tube (T30): 100 mm of it drawn through 1, 2 and 10 bites and back, by
/// `ftl` and elastic; friction against Euler and Eytelwein's law; 100 times to and fro (E19). Cost: a minute or two;
/// `quick` leaves out ten bites.
void add_thread_in_tissue(lab::Suite& suite, bool quick, const lab::Progress& progress);

/// What a limp thread slides by as so much of it [m] is drawn through bites (1, 2, 4 ...) at a speed [m/s]: ln(pull /
/// load) over the angle turned by, means of the second half of the way; `friction`, were it Euler and Eytelwein's law.
/// Cost: a millisecond a tick.
double slides_by(int bites, bool is_elastic, double friction, double speed, double way);

}  // namespace bench::suites
