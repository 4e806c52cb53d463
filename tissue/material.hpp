#pragma once

namespace tissue {

/// A nearly incompressible neo-Hookean wall. SI. Energy per rest volume mu/2 (|F|^2 - 3) - mu (J - 1) + kappa/2 (J - 1)^2, that of Smith, de Goes
/// and Kim 2018 (Stable Neo-Hookean Flesh Simulation) with J the mean over a cell: finite and smooth wherever corners are, so that what
/// is turned inside out comes back.
struct Material {
    double young = 0.1e6;          ///< Young's modulus when hardly strained [Pa]; vessels: 0.05e6 to 0.2e6 below a tenth.
    /// kappa / mu, 25 to 1000. 300 keeps the stress of a sheet pressed together both ways to 0.8 within 1.4 % of what cannot change its volume.
    double bulk_over_shear = 300;
    double density = 1060;         ///< [kg/m^3]
    /// Time in which a strip that is let go loses all but 1/e of its strain, inertia apart [s]. Chosen by eye, no source: a vessel in its bed
    /// does not ring. Viscous, of 2 relaxation shear() times the gradient of the velocity, so that it resists turning as well.
    double relaxation = 2.5e-3;

    double shear() const { return young / 3; }                     ///< mu [Pa].
    double viscosity() const { return 2 * relaxation * shear(); }  ///< [Pa s]
    double bulk() const { return bulk_over_shear * shear(); }      ///< kappa [Pa].
};

}  // namespace tissue
