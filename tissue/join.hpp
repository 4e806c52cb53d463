#pragma once
#include "tissue/bite.hpp"
#include "tissue/leak.hpp"
#include "tissue/rim.hpp"

namespace tissue {

/// One of two vessels whose ends were sewn together. Both are at rest in one frame, one end facing the other.
struct SewnVessel {
    const Mesh& rest;             ///< Its wall, with a cut and a lumen.
    const Skin& skin;             ///< Its surface as it is now, with its holes.
    std::span<const Bite> bites;  ///< All of them.
    Vec3 axis = Vec3::UnitX();    ///< Its axis at rest next to the cut, unit, either way.
};

/// A piece of the suture line, along the outer rim of vessel 0; from there to the inner rim it has a segment across the
/// cut.
struct LinePiece {
    double place = 0;   ///< Place of its middle along the rim at rest [m].
    double length = 0;  ///< Length along the rim at rest [m].
    double gap = 0;     ///< Least distance of the segment to the other vessel's skin; 0 where it is in that wall [m].
    /// How far from the other vessel's rim, at rest, that vessel's nearest outer or inner side is; 0 where there is a
    /// gap of a wall or more [m].
    double overlap = 0;
    double width = 0;  ///< Length now, mean of both rims [m].
};

/// An open bite, judged.
struct SewnBite {
    int vessel = 0;           ///< 0 or 1.
    int bite = 0;             ///< Its number there.
    int pass = 0;             ///< The same as Bite::pass.
    bool partial = false;     ///< The same as Bite::partial().
    bool both_walls = false;  ///< The same as Bite::both_walls.
    /// Distance of its end on the outer side from the outer rim, at rest [m]: of the farther one if both ends are
    /// there, 0 if neither is.
    double size = 0;
    double depth = 0;        ///< How deep the needle was below the skin [m].
    double place = 0;        ///< Where it is along the outer rim at rest [m].
    double angle = 0;        ///< Angle of that place about vessel 0's axis at rest [rad].
    double through = 0;      ///< Distance from hole to hole at rest [m].
    double inside = 0;       ///< Distance of the end that is not `size`'s from its rim at rest [m].
    double strain = 0;       ///< Share by which its straight distance to the outer rim has become less; negative: more.
    double hole = 0;         ///< Longest diameter of its longer hole, by the wall's stretch there [m].
    double hole_radius = 0;  ///< Radius of its hole at rest [m].
    bool torn = false;       ///< The same as Bite::torn.
    int thread = -1;         ///< Number of the thread that goes through both its holes; none: -1.
    double along = 0;        ///< Place of its middle along that thread [m].
    double outer_along = 0;  ///< Place of `size`'s end along that thread [m].
};

/// The thread goes from one vessel to the other: a bite in each, next to each other along the thread. Where one pass
/// made several, those farthest from the other vessel count.
struct Stitch {
    std::array<int, 2> bites;  ///< The bites in vessel 0 and 1, as numbers in Join::bites.
    double arc = 0;            ///< Angle between them round the ring, 0 to half a turn [rad].
    /// Angle between the line that joins their outer ends and straight across the cut, both vessels at rest and met
    /// [rad].
    double obliqueness = 0;
    /// Thread between the outer ends over the length of its path along the wall; 0: not known.
    double loop = 0;
};

/// What is left of an operation. SI.
struct Join {
    double diameter = 0;                         ///< Diameter of the thread [m].
    double wall = 0;                             ///< Thickness of vessel 0 along its cut at rest [m].
    double rim = 0;                              ///< Length of vessel 0's outer rim at rest [m].
    std::vector<LinePiece> line;                 ///< The suture line, piece by piece round the rim.
    std::vector<SewnBite> bites;                 ///< Sorted by thread and place along it; those without a thread first.
    std::vector<Stitch> stitches;                ///< Stitches in their order along the threads.
    std::array<std::vector<double>, 2> spacing;  ///< Distances from stitch to stitch round each outer rim, at rest [m].
    double arc_of_pass = 0;      ///< The widest between bites of one vessel in one pass, round the ring [rad].
    double lumen_ratio = 1;      ///< The lesser of both vessels' (lumen.hpp).
    double thread_in_lumen = 0;  ///< Length of thread deeper than its diameter in the lumen [m].
    double deepest_thread = 0;   ///< How deep the middle of a thread is in the lumen at most [m].
    double leak_of_line = 0;     ///< Through the suture line [m^3/s].
    double leak_of_holes = 0;    ///< Through holes of the needle [m^3/s].

    bool is_sewn() const { return !stitches.empty(); }  ///< Else nothing but their place holds the ends together.
    double leak() const { return leak_of_line + leak_of_holes; }  ///< All of it [m^3/s].
};

/// Judges the join of two vessels by threads of one diameter [m], each a line of nodes. Once, when a drill ends: some 8
/// ms for two of 2300 tetrahedra and eight threads. Throws std::invalid_argument for a vessel without a cut across its
/// lumen.
///
/// Leak: slits as wide as the gap along the line, through the wall or as far as ends overlap; at a bite from outside to
/// the lumen a slit round its thread, or an open hole, where a needle is still in it or was taken back too; the
/// narrower hole decides. Torn walls leak no more than that, and an everted join that is open at its edge but closed
/// further in leaks none the less. Places on two rims are compared by their angles about one axis, at rest: a vessel
/// turned on its axis since counts as stitched aslant.
Join judge(const SewnVessel& first, const SewnVessel& second, std::span<const std::vector<Vec3>> threads,
           double diameter, const Fluid& fluid = {});

/// Which of these threads of one diameter [m], each a line of nodes, passes both holes of an open bite nearest, as near
/// as what is in them could be: by twice a hole's radius, to which rims are drawn out (Skin::set_wires), and a
/// diameter; none: -1. As many distances as nodes.
int thread_in(const Bite& bite, const Skin& skin, std::span<const std::vector<Vec3>> threads, double diameter);

}  // namespace tissue
