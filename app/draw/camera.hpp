#pragma once
#include "app/draw/picture.hpp"

namespace app::draw {

/// The camera's axes as rows: right, up, back (towards the eye), orthonormal.
Eigen::Matrix3d axes_of(const Camera& camera);

/// Half the height of what is seen one metre before the eye [m].
double half_height(const Camera& camera);

/// What is nearer or farther than these is not drawn [m].
double near_plane(const Camera& camera);
double far_plane(const Camera& camera);

/// World to OpenGL's clip space, for a picture of this width over height.
Eigen::Matrix4d clip_from_world(const Camera& camera, double aspect);

}  // namespace app::draw
