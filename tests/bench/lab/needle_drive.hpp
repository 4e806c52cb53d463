#pragma once
#include "tissue/bite.hpp"
#include "tissue/tube.hpp"

// A vessel that is held, and a needle that is driven through its wall.
namespace bench::lab {

/// A needle that turns about its circle's centre: its tip goes through `point` when turn is 0, that way; bent towards
/// `bend`, across the way.
struct Swing {
    tissue::Vec3 point, way, bend;
    double radius = 3.95e-3, angle = 2.356, wire = 0.1e-3;  // of a BV-1

    tissue::Arc at(double turn) const;  ///< [rad]
};

/// Wall, skin and bites stepped together.
struct Stitching {
    double step = 2e-3;  ///< [s]

    /// The far end is held, and the half of the cut end that is below, y < 0.
    explicit Stitching(const tissue::BiteDef& def, const tissue::TubeDef& tube = {}, const tissue::Solver& solver = {});
    /// One step with the needle there; none: nullptr.
    void go(const tissue::Arc* needle);
    /// Whether any of the needle is in the wall.
    bool is_in_wall(const tissue::Arc& needle) const;

    /// Forceps in the lumen: holds the inside of the wall above, for three quarters of the length.
    void support();

    tissue::Mesh mesh;
    tissue::Tissue tissue;
    tissue::Skin skin;
    tissue::Bites bites;
    std::vector<tissue::Hold> holds;
};

/// A needle driven along its own arc, at `speed` [m/s], from outside into the lumen at some 1.5 mm from the cut, and
/// all the way through.
struct Driven {
    double entry = 0, exit = 0;  ///< Forces that the skins gave way at [N]; none: 0.
    double aside =
        0;  ///< How far the wall moves at most across the wire at its holes from 50 ms after both are open [m].
    double off = 0;      ///< How far where it was pierced is off the wire's circle, when nothing pulls [m].
    bool drawn = false;  ///< All of it is through.
};
Driven drive_through(const tissue::BiteDef& def, const tissue::TubeDef& tube, double speed, bool supported);

}  // namespace bench::lab
