#pragma once
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "sim/knot/namer.hpp"
#include "tests/bench/lab/curves.hpp"
#include "tests/bench/lab/throws.hpp"

// Curves whose type is known: drawn from a formula, or read from tests/data/curves.
namespace ropes {

using sim::knot::Component;
using sim::knot::Vec3;
using Rope = std::vector<Vec3>;

using Labelled = bench::lab::LabelledCurve;

/// All of tests/data/curves/labels.json; only the one named `id` when given.
std::vector<Labelled> labelled(const std::string& id = "");

/// T(2, n), closed: on a torus, right-handed for positive n.
Rope torus_knot(int n);

Rope mirrored(Rope rope);
Rope turned(Rope rope, std::mt19937& random);

}  // namespace ropes
