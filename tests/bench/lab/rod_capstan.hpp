#pragma once
#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/rod_cases.hpp"

namespace bench::lab {

/// A thin rod wound about a cylinder ten times as thick, hardly stiff against bending, pulled over it at 10 mm/s
/// against a load: the pull over the load when it slides, and Euler and Eytelwein's e^(friction wrap). `turn`: of a
/// link about the cylinder [rad].
Compared rod_capstan(double friction, double wrap, double turn, double tick);

/// The same by an elastic thread, whose contacts are solved all together once a tick. `cost`: of its ticks.
Compared elastic_capstan(double friction, double wrap, double turn, double tick, Cost& cost);

inline Compared elastic_capstan(double friction, double wrap, double turn, double tick) {
    Cost cost;
    return elastic_capstan(friction, wrap, turn, tick, cost);
}

/// The same, of a polyline: what its nodes carry (surgery-and-physics.md, table D1).
double capstan_of_nodes(double friction, double wrap, double turn);

/// Loaded at both ends, the one with this share of what slides for a polyline: how far it goes in a second after that
/// [D].
double rod_slides(double friction, double wrap, double turn, double share);
double elastic_slides(double friction, double wrap, double turn, double share);

}  // namespace bench::lab
