#pragma once
#include <vector>

#include "tests/bench/lab/rod_cases.hpp"
#include "tests/bench/lab/row.hpp"

// D16 of surgery-and-physics.md: two parts of one elastic thread lie across each other at right angles without
// friction. Each is held like a bracket, in the middle of a link, and free beyond the crossing; the clamp of the upper
// one is lowered.
namespace bench::lab {

struct Crossing {
    int links;      ///< Of either arm, from its clamp to the crossing,
    bool at_nodes;  ///< which is at a node of both, or else in the middle of a link of both.
};

/// What came of it. Reference of the first two: arms of lengths a and b, bending stiffness B, pressed together by an
/// overlap w, each bend by F a^3 / 3 B and F b^3 / 3 B under the force F between them (Bernoulli's beam, tip load),
/// together by w: F = 3 B w / (a^3 + b^3).
struct Crossed {
    Compared lift;   ///< Of the upper arm above its clamp, at the crossing [m].
    Compared force;  ///< Between them, from the bend at the clamp of the lower [N].
    double apart;    ///< At the crossing, middle to middle [D].
    double drift;    ///< Of any node in the seconds after it came to rest [D].
};
Crossed cross(const Crossing& crossing, double seconds);

std::vector<Row> crossing_rows(bool quick);

}  // namespace bench::lab
