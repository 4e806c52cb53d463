#pragma once
#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// The elastic rod against closed forms: each case at four resolutions, its error and the order in which that falls; it
/// and the elastic thread drawn over a cylinder; the elastic thread's loose and tight overhands and its tight clasp;
/// then laws of scale and symmetry. `quick` leaves out the finest.
lab::Suite accuracy_suite(bool quick, const lab::Progress& progress);

}  // namespace bench::suites
