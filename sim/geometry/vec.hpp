#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sim::geometry {

using Vec3 = Eigen::Vector3d;     ///< [m] unless its name says otherwise.
using Quat = Eigen::Quaterniond;  ///< Unit; q and -q are the same rotation.

}  // namespace sim::geometry
