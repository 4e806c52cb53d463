#pragma once
#include <span>
#include <string>

namespace scenarios::drill {

/// A suture size of the US Pharmacopeia (USP <861> diameters, <881> knot-pull tensile strength, class I).
struct Size {
    const char* name;    ///< As drill files have it: "6-0".
    double diameter_mm;  ///< Middle of the size's range [mm].
    double break_N;      ///< Minimum average knot-pull [N].
};

/// A thread material. Initial moduli of silk and polyglactin: tension tests of Naleway 2015; the other moduli and the
/// densities: handbook values. Bending moduli of braids are rough, published ones range from 300 to 1000 MPa.
struct Material {
    const char* name;          ///< As drill files have it.
    double young_MPa;          ///< Initial modulus along the thread [MPa].
    double bending_young_MPa;  ///< Modulus in bending [MPa]; lower than along where a braid's fibres slide.
    double density_kg_m3;      ///< Mass per volume [kg/m^3].
    /// Strain beyond which a fibre stays as it is bent [%]: the middle of 3 to 5 % for polypropylene, which yields
    /// early [SurgeryAndPhysics C2]; 0: no figure is known, or fibres slide instead.
    double yield_percent;
};

/// All suture sizes, 3-0 to 10-0.
std::span<const Size> sizes();
/// All thread materials.
std::span<const Material> materials();

/// The size of that name, which must be one of sizes().
const Size& size_named(const std::string& name);
/// The material of that name, which must be one of materials().
const Material& material_named(const std::string& name);

}  // namespace scenarios::drill
