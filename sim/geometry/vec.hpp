#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sim::geometry {

using Vec3 = Eigen::Vector3d;     ///< A point or a vector of space, in [m] unless its name says otherwise.
using Quat = Eigen::Quaterniond;  ///< A rotation as a unit quaternion; q and -q are the same.

}  // namespace sim::geometry
