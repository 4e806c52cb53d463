#pragma once

namespace tissue {

/// A nearly incompressible neo-Hookean wall. SI. Energy per rest volume mu/2 (|F|^2 - 3) - mu (J - 1) + kappa/2 (J -
/// 1)^2, that of Smith, de Goes and Kim 2018 (Stable Neo-Hookean Flesh Simulation) with J the mean over a cell: finite
/// and smooth wherever corners are, so that what is turned inside out comes back.
struct Material {
    double young = 0.1e6;  ///< Young's modulus when hardly strained [Pa]; vessels: 0.05e6 to 0.2e6 below a tenth.
    /// The bulk modulus over the shear modulus, kappa / mu, at least 10: the softer, the longer an old stiffness is of
    /// use. 200 keeps the stress of a sheet pressed together both ways to 0.8 within 2 % of what cannot change its
    /// volume, the worst of D19; a tube's radius under pressure already at 30.
    double bulk_over_shear = 200;
    double density = 1060;  ///< Mass per volume of a vessel's wall [kg/m^3].
    /// Time in which a strip that is let go loses all but 1/e of its strain [s]. Chosen by eye, no source. The stress
    /// is viscosity() times the gradient of the velocity, so that it resists turning as well.
    double relaxation = 2.5e-3;
    /// Time in which a free piece, pushed, would lose its speed [s]. Chosen by eye. Inertia itself is left out: at 5
    /// m/s, waves cross a vessel in 2 ms.
    double slowing = 25e-3;

    double shear() const { return young / 3; }                     ///< The shear modulus mu [Pa].
    double viscosity() const { return 2 * relaxation * shear(); }  ///< The wall's viscosity, by `relaxation` [Pa s].
    double bulk() const { return bulk_over_shear * shear(); }      ///< The bulk modulus kappa [Pa].
};

}  // namespace tissue
