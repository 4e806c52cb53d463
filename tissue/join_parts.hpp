#pragma once
#include "tissue/join.hpp"

// What judge() is made of.
namespace tissue {

/// A vessel and the rims that face the other one.
struct SewnEnd {
    const SewnVessel& vessel;
    Rim outer, inner;
    std::span<const Vec3> nodes() const { return vessel.skin.nodes(); }
};

/// The frame in which places on both rims are compared: across vessel 0's axis.
struct Around {
    Vec3 x, y;
    double angle(const SewnEnd& end, double place) const;  ///< Of a place on its outer rim at rest [rad].
};
Around around(const SewnEnd& end);

/// All open bites of an end, by their numbers.
std::vector<SewnBite> sewn_bites(const SewnEnd& end, int number, const Around& around,
                                 std::span<const std::vector<Vec3>> threads, double diameter);
/// `bites` by thread and along it.
std::vector<Stitch> stitches_of(std::span<const SewnBite> bites, double radius);
std::vector<double> spacing_of(std::span<const SewnBite> bites, std::span<const Stitch> stitches, std::size_t vessel,
                               double rim);
double arc_of_pass(std::span<const SewnBite> bites);

std::vector<LinePiece> suture_line(const SewnEnd& end, const SewnEnd& other, double wall);

}  // namespace tissue
