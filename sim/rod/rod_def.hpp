#pragma once
#include "sim/geometry/vec.hpp"

namespace sim::rod {

/// What an elastic thread is made of. SI.
struct RodDef {
    double radius = 0.0425e-3;  ///< [m]
    double young = 2.8e9;       ///< Young's modulus [Pa], along the thread;
    double bending_share = 1;   ///< what of it counts in bending: less than 1 where a braid's fibres slide.
    double poisson = 0.5;       ///< Poisson's ratio, of the twist alone.
    double friction = 0.15;     ///< Coulomb, of nodes on RodInput::bodies.
    double density = 905;       ///< [kg/m^3]; 0: without inertia, every step ends in equilibrium.
    /// Axial stiffness of a link over its bending stiffness, EA h^2 / B: practically inextensible at 1e4. 0: that of
    /// the material, which is 4 (h / radius)^2 and stretches a suture by a twentieth at a newton.
    double axial_over_bending = 1e4;
    /// Whether it is as it was made, bent by as much at each node as at first, when unloaded; else straight. About
    /// which axis a node bends is free, as in a round thread of which no end is kept from turning.
    bool keeps_shape = false;
    bool quasi_static = false;  ///< Every step ends in equilibrium, as without density, but under its weight.
    /// Strain beyond which a fibre stays as it is bent, [0, 1], 0: never. A round section all of whose fibres yield
    /// carries 16 / (3 pi) of the moment at which the outermost begin to; here it springs up to that moment and gives
    /// way at it, where a true one gives way little by little. Of bending alone: what a pull adds to the strain is left
    /// out.
    double yield_strain = 0;
    /// In which the air about it takes all but 1/e of its speed [s]; 0: there is none. So slowly air flows as oil does,
    /// and drags each part of a thin thread by itself and in proportion to its speed (Stokes).
    double halting_time = 0;
    double most_strain = 0.1;                         ///< No step pulls harder than its material does at this strain.
    geometry::Vec3 gravity = geometry::Vec3::Zero();  ///< [m/s^2]

    double bending_stiffness() const;   ///< B = E I [N m^2].
    double yield_curvature() const;     ///< Most that it springs back by when let go of [1/m].
    double twisting_stiffness() const;  ///< C = B / (1 + poisson) [N m^2].
    /// [N], of links of this length. Of one shorter than half a radius never less than a bend's next to it, B / link^2.
    double axial_stiffness(double link) const;
    double most_pull() const;  ///< [N] at most_strain.
    double contact_stiffness(
        double link) const;          ///< [N/m], where strands are nearer to each other than they are thick.
    double mass_per_length() const;  ///< [kg/m]
};

}  // namespace sim::rod
