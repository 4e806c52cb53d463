#pragma once
#include <string>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// Vessels that give way: their material and tubes against closed forms (D17 to D19), a cut's edge against a finer
/// vessel, and what steps of two vessels cost and err by, over how they are solved. `quick` leaves out the finest.
lab::Suite tissue_suite(bool quick, const lab::Progress& progress);

/// Two charts of it (SVG): errors over what a simulated second costs, by resolution and by how it is solved.
std::string tissue_picture(const lab::Suite& suite);

}  // namespace bench::suites
