#pragma once
#include "tissue/tissue.hpp"
#include "tissue/tube.hpp"

// A vessel whose far end is held and whose wall is pulled at a bite next to the cut, within about a millimetre of it.
namespace bench::lab {

struct VesselPull {
    explicit VesselPull(const tissue::TubeDef& def, bool locks = false);

    /// This force [N], shared as a thread's would be by a bite that is two millimetres wide and long and strongest in
    /// its middle.
    std::vector<tissue::PointForce> forces(const tissue::Vec3& force) const;
    /// What a thread does in a second: pulls along the axis, stays, turns aside, lets go; at most 1.
    static tissue::Vec3 pull_at(double seconds);

    tissue::Mesh mesh;
    std::vector<tissue::Hold> holds;
    int edge;    ///< The node of the cut's outer edge next to the bite,
    int behind;  ///< and that straight behind it, where the bite ends.
    std::vector<tissue::MaterialPoint> points;
    std::vector<double> shares;
};

/// The vessel of a drill, `finer` times as fine; 0.5: half as fine.
tissue::TubeDef vessel(double finer = 1);

/// What this pull along the axis [N] comes to in the end.
struct PulledVessel {
    tissue::Vec3 edge;  ///< How far the edge goes [m].
    double opening;     ///< By how much the outer wall between edge and bite's end is longer [m].
};
PulledVessel pulled(const VesselPull& pull, double force);

/// A second of the pull, step by step.
struct Played {
    std::vector<tissue::Vec3> edge;  ///< After each step [m].
    std::vector<double> us;          ///< Processor time of each.
    double iterations = 0;           ///< Mean.
};
Played play(const VesselPull& pull, const tissue::Solver& solver, double force, double seconds);

/// Mean processor time of a step at rest with so many stiff forces on the wall's faces, which stick it fast to where it
/// is [us].
double stiff_step(int forces);

/// How far one is from another at most, and its root mean square, over how far that one goes.
struct Lag {
    double most, mean;
};
Lag apart(const Played& a, const Played& b);

}  // namespace bench::lab
