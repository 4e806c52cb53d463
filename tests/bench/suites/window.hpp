#pragma once
#include <filesystem>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// What the window costs; `drills`: the folder of the shipped drills. `quick`: a few frames instead of many.
lab::Suite window_suite(const std::filesystem::path& drills, bool quick, const lab::Progress& progress);

/// What a person at the window waits for, measured at the program beside this one on a display of its own: first
/// frames, pace and frames while both hands move, and how late a picture is (tests/app/window/measure.py; some five
/// minutes). Needs xvfb and python3, and a machine that does nothing else. Throws std::runtime_error: it failed.
void add_live(lab::Suite& suite, const std::filesystem::path& drills, bool quick, const lab::Progress& progress);

/// Processor time of a frame of 1280 x 720 by software on one thread, at both levels, of a knot drill and of a stitch
/// as they are some seconds after their start, and its ratio to an empty clear of the same run (window_drawing.cpp).
void add_drawing(lab::Suite& suite, const std::filesystem::path& drills, bool quick, const lab::Progress& progress);

}  // namespace bench::suites
