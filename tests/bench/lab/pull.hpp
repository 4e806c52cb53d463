#pragma once
#include <array>
#include <utility>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace bench::lab {

using sim::geometry::Vec3;

/// The overhand pull: a loose overhand knot, both ends held and taken apart at constant speed. Hands wait when it takes
/// up 12 D, then go on until they are 5 % farther apart than the rope is long, and wait again.
struct PullDef {
    int links = 200;
    double speed = 0.1;     ///< Of either hand [m/s].
    double tick = 1e-3;     ///< [s]
    double diameter = 0;    ///< [m]; 0: as thick as a link is long.
    double length = 1;      ///< [m]
    double friction = 0.3;  ///< Coulomb coefficient, rope on rope.
    double waits_at = 12;  ///< What the rope takes up when hands wait [D]; links as long as it is thick let an overhand
                           ///< go to between 11 and 12.
    double tight_below = 14;  ///< It counts as tight where it takes up less [D].
    bool elastic = false;     ///< Ours moves as an elastic rod of polypropylene, each hand at two nodes: a rod that may
                              ///< turn about its held ends slips its loop over them.

    double link() const { return length / links; }
    double thickness() const { return diameter > 0 ? diameter : link(); }
};

/// A rope whose ends are held: ours, or a peer's.
class Rope {
  public:
    virtual ~Rope() = default;

    /// One tick, at whose end the hands are here [m]. Only this is timed.
    virtual void tick(const Vec3& left, const Vec3& right) = 0;
    virtual void read(std::vector<Vec3>& nodes) const = 0;
    /// So far, where the rope itself looks out for them.
    virtual int pass_throughs() const { return 0; }
};

/// What the pull showed. Times: processor time of one tick [us], over ticks in which hands pull. "Tight": those of them
/// in which the rope takes up less than PullDef::tight_below, its worst case. Stretch: Gauge::stretch as share. All
/// numbers, so that a peer's go through JSON in a loop.
struct PullFigures {
    double tick_p50, tick_p99, tick_max, tick_mean;
    double tight_p50, tight_p99, tight_max;
    double stretch_pull = 0, stretch_rest = 0, stretch_over = 0;  ///< Until hands wait; while they do; beyond.
    double gap_pull = 3, gap_over = 3;                            ///< Until hands have waited; beyond [diameters].
    double kappa_rest, kappa_least = 1e9;
    double lag = 0;    ///< Largest, of an end behind its hand [diameters].
    double knot_kept;  ///< 1: the same name with the same hand as at the start.
    double pass_throughs;
};

/// Names and places of all figures.
using PullFigure = std::pair<const char*, double PullFigures::*>;
constexpr std::array<PullFigure, 17> pull_figures{{
    {"tick-p50", &PullFigures::tick_p50},
    {"tick-p99", &PullFigures::tick_p99},
    {"tick-max", &PullFigures::tick_max},
    {"tick-mean", &PullFigures::tick_mean},
    {"tight-p50", &PullFigures::tight_p50},
    {"tight-p99", &PullFigures::tight_p99},
    {"tight-max", &PullFigures::tight_max},
    {"stretch-pull", &PullFigures::stretch_pull},
    {"stretch-rest", &PullFigures::stretch_rest},
    {"stretch-over", &PullFigures::stretch_over},
    {"gap-pull", &PullFigures::gap_pull},
    {"gap-over", &PullFigures::gap_over},
    {"kappa-rest", &PullFigures::kappa_rest},
    {"kappa-least", &PullFigures::kappa_least},
    {"lag", &PullFigures::lag},
    {"knot-kept", &PullFigures::knot_kept},
    {"pass-throughs", &PullFigures::pass_throughs},
}};

/// `rope` lies along `start`, an overhand of def's links.
PullFigures pull(Rope& rope, const PullDef& def, const std::vector<Vec3>& start);

}  // namespace bench::lab
