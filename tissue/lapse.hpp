#pragma once
#include "tissue/join.hpp"

namespace tissue {

/// Where a lapse begins: what reference work names, or judgement where it names nothing; an instructor may change each.
/// Lengths of a wall are of the vessel's.
struct LapseLimits {
    double gap = 0.25;         ///< Walls: wider than this the suture line is open ...
    double open_spacings = 1;  ///< ... and disrupted where it is so for more spacings at a stretch.
    double arc = 90;           ///< Between bites that one loop joins, round the ring [degrees].
    double obliqueness = 15;   ///< [degrees]
    double bite_walls = 3;
    double bite_medians = 1.5;   ///< Medians of all bites.
    double partial_bites = 0;    ///< How many may be.
    double least_spacing = 0.6;  ///< Means of the same rim's ...
    double most_spacing = 1.5;
    double spacing_variation = 0.25;  ///< ... and standard deviation over mean.
    double hole_diameters = 2;        ///< Length of a hole in diameters of the thread.
    double torn_holes = 0;            ///< How many may be.
    double edge_strain = 0.3;         ///< By how much of it a bite is pressed together.
    double least_loop = 0.8;          ///< Loop over the way along the wall that it was led.
    double depth_diameters = 1;       ///< Of thread in the lumen, in its diameters.
    double overlap_walls = 1;
};

/// One kind of mistake that an opened join shows.
struct Lapse {
    const char* name;
    const char* measure =
        "";  ///< What value and limit are of: of several the first that is over its limit, else the first.
    double value = 0, limit = 0;  ///< The worst of the join.
    bool at_least = false;        ///< The limit is from below.
    bool committed = false;
};

/// The ten of the Anastomosis Lapse Index (Ghanem et al. 2016), in its order: disruption of the suture line, back-wall
/// stitch, oblique stitch, wide bite, partial thickness, unequal spacing, tear, strangulation, thread in the lumen,
/// overlap. Its tests are by eye; these are one reading of it.
std::array<Lapse, 10> lapses(const Join& join, const LapseLimits& limits = {});

}  // namespace tissue
