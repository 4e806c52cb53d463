#pragma once
#include "tissue/join.hpp"

namespace tissue {

/// Where a lapse begins: what reference work names, or judgement where it names nothing; an instructor may change each.
/// Walls are the vessel's thickness.
struct LapseLimits {
    double gap = 0.25;           ///< The suture line is open where its gap is wider than this [walls].
    double open_spacings = 1;    ///< It is disrupted where it is open for longer than this at a stretch [spacings].
    double arc = 90;             ///< Angle round the ring between bites that one loop joins, at most [degrees].
    double obliqueness = 15;     ///< Obliqueness of a stitch, at most [degrees].
    double bite_walls = 3;       ///< Size of a bite, at most [walls].
    double bite_medians = 1.5;   ///< Size of a bite, at most [medians of all bites].
    double partial_bites = 0;    ///< How many bites may be partial.
    double least_spacing = 0.6;  ///< Distance from stitch to stitch, at least [means of the same rim's].
    double most_spacing = 1.5;   ///< Distance from stitch to stitch, at most [means of the same rim's].
    double spacing_variation = 0.25;  ///< Standard deviation of spacings over their mean, at most.
    double hole_diameters = 2;        ///< Length of a hole, at most [diameters of the thread].
    double torn_holes = 0;            ///< How many holes may be torn to the edge.
    double edge_strain = 0.3;         ///< Share of its size that a bite may be pressed together by.
    double least_loop = 0.8;          ///< Loop over the length of its path along the wall, at least.
    double depth_diameters = 1;       ///< How deep thread may be in the lumen [diameters of the thread].
    double overlap_walls = 1;         ///< How far the ends may overlap [walls].
};

/// One kind of mistake that an opened join shows.
struct Lapse {
    const char* name;  ///< What the kind is called.
    /// What value and limit are of, with their unit: of several measures the first that is over its limit, else the
    /// first.
    const char* measure = "";
    double value = 0;        ///< The worst of the join.
    double limit = 0;        ///< Beyond it the lapse is committed.
    bool at_least = false;   ///< The limit is from below.
    bool committed = false;  ///< The limit is not kept.
};

/// The ten of the Anastomosis Lapse Index (Ghanem et al. 2016), in its order: disruption of the suture line, back-wall
/// stitch, oblique stitch, wide bite, partial thickness, unequal spacing, tear, strangulation, thread in the lumen,
/// overlap. Its tests are by eye; these are one reading of it.
std::array<Lapse, 10> lapses(const Join& join, const LapseLimits& limits = {});

}  // namespace tissue
