#pragma once
#include "tissue/bite.hpp"
#include "tissue/tube.hpp"

// A vessel that is held, and a needle that is driven through its wall.
namespace app::bench {

/// A needle that turns about its circle's centre: its tip goes through `point` when turn is 0, that way; bent towards `bend`, across the way.
struct Swing {
    tissue::Vec3 point, way, bend;
    double radius = 3.95e-3, angle = 2.356, wire = 0.1e-3;   // of a BV-1

    tissue::Arc at(double turn) const;                        ///< [rad]
};

/// Wall, skin and bites stepped together.
struct Stitching {
    static constexpr double step = 2e-3;                      ///< [s]

    /// The far end is held, and the half of the cut end that is below, y < 0.
    explicit Stitching(const tissue::BiteDef& def, const tissue::TubeDef& tube = {}, const tissue::Solver& solver = {});
    /// One step with the needle there; none: nullptr.
    void go(const tissue::Arc* needle);
    /// How far the wall is off its rest at most where the needle goes through its skins, across the wire [m].
    double moved_aside(const tissue::Arc& needle) const;
    /// Whether any of the needle is in the wall.
    bool is_in_wall(const tissue::Arc& needle) const;

    tissue::Mesh mesh;
    tissue::Tissue tissue;
    tissue::Skin skin;
    tissue::Bites bites;
    std::vector<tissue::Hold> holds;
};

}  // namespace app::bench
