#pragma once
#include "tissue/join.hpp"

// The parts of judge().
namespace tissue {

/// A vessel and the rims that face the other one.
struct SewnEnd {
    const SewnVessel& vessel;  ///< Whose end it is.
    Rim outer, inner;          ///< Rims of its cut.

    std::span<const Vec3> nodes() const { return vessel.skin.nodes(); }  ///< Nodes of its wall now [m].
};

/// The frame in which places on both rims are compared: across vessel 0's axis.
struct Around {
    Vec3 x, y;  ///< Unit, across the axis and each other.

    double angle(const SewnEnd& end, double place) const;  ///< Angle of a place on an end's outer rim, at rest [rad].
};
/// That frame for the end of vessel 0.
Around around(const SewnEnd& end);

/// All open bites of the end of vessel `number`, in their order there. `threads`: lines of nodes [m] of one `diameter`
/// [m].
std::vector<SewnBite> sewn_bites(const SewnEnd& end, int number, const Around& around,
                                 std::span<const std::vector<Vec3>> threads, double diameter);
/// The stitches that these bites, sorted by thread and place along it, make. `radius`: of the ring [m].
std::vector<Stitch> stitches_of(std::span<const SewnBite> bites, double radius);
/// Distances from stitch to stitch round a rim of this length, of vessel 0 or 1 [m].
std::vector<double> spacing_of(std::span<const SewnBite> bites, std::span<const Stitch> stitches, std::size_t vessel,
                               double rim);
/// The widest angle between bites of one vessel in one pass [rad].
double arc_of_pass(std::span<const SewnBite> bites);

/// The suture line of an end against the other, whose wall is so thick [m].
std::vector<LinePiece> suture_line(const SewnEnd& end, const SewnEnd& other, double wall);

}  // namespace tissue
