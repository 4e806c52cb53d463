#include "app/hands/assist_steady.hpp"

#include <cmath>

#include "sim/geometry/portable_math.hpp"

namespace app::hands {

Pose Steady::next(const Pose& asked, double seconds, double tau) {
    const double share = 1 - std::exp(-seconds / tau);
    if (at_.position != asked.position) at_.position += share * (asked.position - at_.position);
    if (at_.rotation.coeffs() != asked.rotation.coeffs())
        at_.rotation = sim::geometry::portable_slerp(at_.rotation, asked.rotation, share);
    return at_;
}

}  // namespace app::hands
