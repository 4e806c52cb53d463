#pragma once
#include <span>
#include <vector>

#include "sim/geometry/vec.hpp"
#include "sim/thread/thread.hpp"

namespace bench::lab {

using sim::geometry::Vec3;

/// How right a rope is, read from its nodes alone: the same for ours and for others', and no code of the solver's.
class Gauge {
  public:
    /// `rest`: lengths of the links [m]; `diameter` of the rope [m].
    Gauge(std::vector<double> rest, double diameter);
    Gauge(const sim::thread::Thread& thread);

    /// Of the longest link, its length over that at rest, less 1.
    double stretch(std::span<const Vec3> nodes) const;

    /// Smallest distance between two links' centre lines over the diameter; 3 when it is more. Links nearer along the
    /// rope than half a turn of the tightest bend, pi R, are left out, as in sim/thread: a bend cannot be told from a
    /// touch there.
    double gap(std::span<const Vec3> nodes) const;

    /// Rope length less the distance of the ends, over the diameter: what a knot takes up. An ideal overhand
    /// takes 10.1.
    double kappa(std::span<const Vec3> nodes) const;

    double length() const { return arc_.back(); }  ///< At rest [m].

  private:
    std::vector<double> rest_, arc_;  ///< Arc: length of rope before each node.
    double diameter_;
};

/// Entry of `values`, sorted here, below which this share of them lies; NaN when there are none, or one of them is.
double percentile(std::vector<double> values, double share);

}  // namespace bench::lab
