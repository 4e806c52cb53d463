#pragma once
#include <cmath>

namespace tissue {

/// What runs out, and how hard it is pressed. Blood at 100 mmHg.
struct Fluid {
    double density = 1055;      ///< Mass per volume [kg/m^3]; blood's.
    double viscosity = 3.5e-3;  ///< Dynamic viscosity [Pa s]; blood's in a wide vessel.
    double pressure = 13332;    ///< Inside over outside [Pa], not negative.
};

/// Share of the ideal flow that a sharp-edged opening lets through.
constexpr double discharge_coefficient = 0.6;

/// Speed [m/s] of what runs out of a slit `gap` wide through a wall of `depth` [m]: the positive root of
/// density v^2 / (2 Cd^2) + 12 viscosity depth v / gap^2 = pressure, orifice and plane Poiseuille flow in series. 0
/// where gap is not positive.
///
/// Limits: steady, laminar, Newtonian; walls of the slit flat and parallel, rigid against the pressure, nothing clots.
/// A slit that is narrower further in leaks less. Below some 20 um cells no longer pass as a fluid does. What a real
/// gap is decides more than the formula errs.
inline double leak_speed(double gap, double depth, const Fluid& fluid = {}) {
    if (!(gap > 0)) return 0;
    const double inertia = fluid.density / (2 * discharge_coefficient * discharge_coefficient),
                 drag = 12 * fluid.viscosity * depth / (gap * gap);
    const double sum = drag + std::sqrt(drag * drag + 4 * inertia * fluid.pressure);
    return sum > 0 ? 2 * fluid.pressure / sum : 0;  // not the difference of two numbers that are nearly the same
}

/// Flow [m^3/s] out of a slit `gap` by `width` through a wall of `depth` [m].
inline double leak_of_slit(double gap, double width, double depth, const Fluid& fluid = {}) {
    return gap > 0 ? gap * width * leak_speed(gap, depth, fluid) : 0;
}

/// Flow [m^3/s] out of an opening of `area` [m^2] that is wide for its depth.
inline double leak_of_hole(double area, const Fluid& fluid = {}) {
    return discharge_coefficient * area * std::sqrt(2 * fluid.pressure / fluid.density);
}

/// A flow in mL/min, of one in m^3/s.
inline double in_ml_per_min(double flow) {
    return flow * 60e6;
}

}  // namespace tissue
