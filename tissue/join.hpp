#pragma once
#include "tissue/bite.hpp"
#include "tissue/leak.hpp"
#include "tissue/rim.hpp"

namespace tissue {

/// One of two vessels whose ends were sewn together. Both are at rest in one frame, one end facing the other.
struct SewnVessel {
    const Mesh& rest;  ///< With a cut, and a lumen.
    const Skin& skin;  ///< As it is now, with its holes.
    std::span<const Bite> bites;
    Vec3 axis = Vec3::UnitX();  ///< At rest next to the cut, unit, either way.
};

/// A piece of the suture line, along the outer rim of vessel 0; from there to the inner rim it has a segment across the
/// cut.
struct LinePiece {
    double place = 0, length = 0;  ///< Of its middle; at rest [m].
    double gap = 0;      ///< Least distance of the segment to the other vessel's skin; 0 where it is in that wall [m].
    double overlap = 0;  ///< How far from the other vessel's rim, at rest, its outer or inner side is next; 0 where a
                         ///< gap of a wall or more is [m].
    double width = 0;    ///< Now, mean of both rims [m].
};

/// An open bite, judged.
struct SewnBite {
    int vessel = 0, bite = 0;  ///< Its number there.
    int pass = 0;
    bool partial = false, both_walls = false;
    double size =
        0;  ///< From its end on the outer side to the outer rim, the further if both are; at rest [m]. 0: none is.
    double depth = 0;  ///< Of the needle below the skin [m].
    double place = 0;  ///< Along the outer rim [m] ...
    double angle = 0;  ///< ... and of that place about vessel 0's axis, both at rest [rad].
    double through = 0,
           inside = 0;       ///< From hole to hole, and from the one that is not `size`'s to its rim; at rest [m].
    double strain = 0;       ///< By which its distance to the outer rim, straight, has become less; negative: more.
    double hole = 0;         ///< The longer way across its longer hole, by the wall's stretch there [m].
    double hole_radius = 0;  ///< At rest [m].
    bool torn = false;
    int thread = -1;                    ///< That goes through both holes; none: -1.
    double along = 0, outer_along = 0;  ///< That thread, of its middle and of `size`'s end [m].
};

/// The thread goes from one vessel to the other: a bite in each, next to each other along it. Of bites of one pass the
/// ones furthest from the other vessel.
struct Stitch {
    std::array<int, 2> bites;  ///< In vessel 0 and 1.
    double arc = 0;            ///< Between them round the ring, 0 to half a turn [rad].
    double obliqueness = 0;  ///< Of the line between their outer ends to the way straight across the cut, both ends at
                             ///< rest and met [rad].
    double loop = 0;  ///< Thread between the outer ends over the way along the wall that it was led; 0: not known.
};

/// What is left of an operation. SI.
struct Join {
    double diameter = 0;  ///< Of the thread [m].
    double wall = 0;      ///< Of vessel 0 along its cut at rest [m].
    double rim = 0;       ///< Length of vessel 0's outer rim at rest [m].
    std::vector<LinePiece> line;
    std::vector<SewnBite> bites;  ///< By thread and along it; those without a thread first.
    std::vector<Stitch> stitches;
    std::array<std::vector<double>, 2> spacing;  ///< From stitch to stitch round each outer rim, at rest [m].
    double arc_of_pass = 0;      ///< The widest between bites of one vessel in one pass, round the ring [rad].
    double lumen_ratio = 1;      ///< The lesser of both vessels' (lumen.hpp).
    double thread_in_lumen = 0;  ///< Length of thread deeper than its diameter in the lumen [m] ...
    double deepest_thread = 0;   ///< ... and how deep its middle is at most [m].
    double leak_of_line = 0, leak_of_holes = 0;  ///< [m^3/s]

    bool is_sewn() const { return !stitches.empty(); }  ///< Else nothing but their place holds the ends together.
    double leak() const { return leak_of_line + leak_of_holes; }
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
