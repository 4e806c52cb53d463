#pragma once
#include <string>
#include <vector>

#include "sim/geometry/vec.hpp"
#include "sim/knot/namer.hpp"
#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/row.hpp"

// D13 and D14 of surgery-and-physics.md: two ropes tied to each other by throws, or a loop of one; both standing ends
// are pulled.
namespace bench::lab {

using sim::geometry::Vec3;

/// Two throws of alternating hand with both tails on one side of the knot are a reef, or square, knot; with a tail on
/// either side a thief. Of the same hand they are a granny and a grief knot.
struct Bend {
    const char* words;  ///< "reef"
    bool mirrored;      ///< Every throw is the one before in a mirror.
    bool opposite;      ///< Tails are on opposite sides.
    int throws = 2;     ///< Even, so that either rope comes out where it went in.
};

/// Both ropes in one thread: first rope from its tail to its standing end, a slack piece far from the knot, second rope
/// from its standing end to its tail. Loose, links of `link` [m].
struct BendThread {
    BendThread(const Bend& bend, double link, double radius);

    /// Its type with both standing ends of a reef joined far below the knot, and as tails what is then free; of a thief
    /// or grief knot with the ends joined that the reef stands on, so that a thief is named like a reef.
    std::string name() const;

    std::vector<Vec3> nodes;  ///< [m]
    int left = 0, right = 0;  ///< Where the standing ends are held; between them lies the slack.
    bool opposite;
};

/// What a bend is tied in and how it is pulled. Forces in B/D^2, which is 0.99 N for polypropylene 6-0.
struct BendPull {
    double friction;
    double bending_share;     ///< Of Young's modulus: RodDef.
    double tails;             ///< Weight on either tail,
    double link = 1;          ///< [D]
    double tick = 1e-3;       ///< [s]
    bool elastic = true;      ///< Else by ftl, whose tails nothing pulls.
    double yield_strain = 0;  ///< RodDef.
    double tying = 0;         ///< Pull on all four ends before, if more than `tails` [B/D^2].
};

/// What came of it: both ends are pulled ever harder until a tail has run in by twenty diameters, several times what a
/// knot takes up as it tightens, or the thread is stretched by 8.5 %, which is 1.35 N of polypropylene 6-0 and less
/// than where hands wait.
struct Pulled {
    double force;  ///< Most that it carried, mean of both ends over twenty ticks.
    double share;  ///< Of that stretch; 0.99: it held.
    int pass_throughs;
    Cost cost;
};
Pulled pull_bend(const Bend& bend, const BendPull& pull);

/// Pulled by all four ends alike, then tails are let go of, evenly in a second.
struct LetGo {
    double needed;  ///< Pull on the tails at which both together had run in by twenty diameters; 0 where not before
                    ///< they were free.
    double run_in;  ///< How far they have, two seconds after they were free [D]; 20 where it was not waited for.
};
LetGo let_go(const Bend& bend, const BendPull& pull);

std::vector<Row> bend_rows(bool quick);

}  // namespace bench::lab
