#pragma once
#include <span>
#include <string>

namespace scenarios::drill {

/// A suture size of the US Pharmacopeia (USP <861> diameters, <881> knot-pull tensile strength, class I).
struct Size {
    const char* name;
    double diameter_mm;  ///< Middle of the range of the size.
    double break_N;      ///< Minimum average knot-pull.
};

/// A thread material. Initial moduli of silk and polyglactin: tension tests of Naleway 2015; the other moduli and the
/// densities: handbook values. Bending moduli of braids are rough, published ones range from 300 to 1000 MPa.
struct Material {
    const char* name;
    double young_MPa;          ///< Along the thread, initial.
    double bending_young_MPa;  ///< In bending; lower than along where a braid's fibres slide.
    double density_kg_m3;
    double
        yield_percent;  ///< Strain beyond which a fibre stays as it is bent: the middle of 3 to 5 % for polypropylene,
                        ///< which yields early [SurgeryAndPhysics C2]; 0: no figure is known, or fibres slide instead.
};

std::span<const Size> sizes();  ///< 3-0 to 10-0.
std::span<const Material> materials();

/// The entry of that name, which must exist.
const Size& size_named(const std::string& name);
const Material& material_named(const std::string& name);

}  // namespace scenarios::drill
