#pragma once
#include "sim/geometry/vec.hpp"

namespace sim::rod {

/// What an elastic thread is made of. SI.
struct RodDef {
    double radius = 0.0425e-3;  ///< Radius of the round cross-section [m].
    double young = 2.8e9;       ///< Young's modulus along the thread [Pa].
    double bending_share = 1;   ///< The share of `young` that counts in bending: below 1 where a braid's fibres slide.
    double poisson = 0.5;       ///< Poisson's ratio; it acts on the twisting stiffness alone.
    double friction = 0.15;     ///< Coulomb coefficient of nodes on RodInput::bodies.
    double density = 905;       ///< Mass per volume [kg/m^3]; 0: without inertia, every step ends in equilibrium.
    /// Axial stiffness of a link over its bending stiffness, EA h^2 / B: practically inextensible at 1e4. 0: that of
    /// the material, which is 4 (h / radius)^2 and stretches a suture by a twentieth at a newton.
    double axial_over_bending = 1e4;
    /// Whether the unloaded rod is bent as it was made, by as much at each node as at first; else it is straight. The
    /// axis about which a node bends is free, as in a round thread of which no end is kept from turning.
    bool keeps_shape = false;
    bool quasi_static = false;  ///< Whether every step ends in equilibrium, as without density, but under its weight.
    /// Strain beyond which a fibre stays as it is bent, [0, 1], 0: never. A round section all of whose fibres yield
    /// carries 16 / (3 pi) of the moment at which the outermost begin to; here it springs up to that moment and yields
    /// at it, where a true one yields little by little. It acts in bending alone: what a pull adds to the strain is
    /// left out.
    double yield_strain = 0;
    /// Time in which the air about the thread takes all but 1/e of its speed [s]; 0: there is none. So slowly air flows
    /// as oil does, and drags each part of a thin thread by itself and in proportion to its speed (Stokes).
    double halting_time = 0;
    double most_strain = 0.1;  ///< No step pulls a link harder than its material does at this strain.
    geometry::Vec3 gravity = geometry::Vec3::Zero();  ///< Acceleration of all mass [m/s^2], world frame.

    double bending_stiffness() const;   ///< B = E I, `bending_share` in it [N m^2].
    double yield_curvature() const;     ///< The most curvature that a bend springs back by when let go of [1/m].
    double twisting_stiffness() const;  ///< C = B / (1 + poisson) [N m^2].
    /// Force per strain of links of this length [m], in [N]. For a link shorter than half a radius it is never less
    /// than that of a bend next to it, B / link^2.
    double axial_stiffness(double link) const;
    double most_pull() const;  ///< The pull at `most_strain` [N].
    /// Force per depth by which strands of links of this length [m] are nearer to each other than they are thick [N/m].
    double contact_stiffness(double link) const;
    double mass_per_length() const;  ///< Mass of a metre of thread [kg/m].
};

}  // namespace sim::rod
