#pragma once
#include "tests/bench/lab/rod_cases.hpp"
#include "tissue/tissue.hpp"
#include "tissue/tube.hpp"

// D17 to D19 of surgery-and-physics.md, in equilibrium, by Newton's method.
namespace bench::lab {

/// Each pull of D19.
enum class Deformation { uniaxial, equibiaxial, pure_shear };

/// Engineering stress over mu of a cube of cells pulled to `stretch`, and that of an incompressible neo-Hookean.
Compared patch_stress(Deformation mode, double stretch);

/// How fine a tube is, and whether volume is kept by cells or, to show what that would do, by each tetrahedron.
struct Resolution {
    int around = 16, through = 2;
    bool locks = false;
    double aspect = 1;  ///< Cells' length along the tube over that through the wall.
    double scale = 1;   ///< All lengths, over what is said below.
};

/// Inner radius over that at rest of a tube of inner radius 2 mm and outer 2.5 under pressure, held so that all of it
/// is `axial` times as long; the pressure is such that the radius of an incompressible one grows to `stretch`.
Compared inflated_radius(const Resolution& resolution, double stretch, double axial);

/// Force in the middle of a tube of 4 mm with a wall of 0.5 mm, 16 mm long, whose clamped ends are drawn apart to
/// `stretch`, and what the stretch that its middle has would take [N].
Compared clamped_force(const Resolution& resolution, double stretch);

/// The same mesh with each tetrahedron a cell of its own.
tissue::Mesh with_own_volumes(tissue::Mesh mesh);

}  // namespace bench::lab
