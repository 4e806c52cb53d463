#pragma once
#include "app/draw/picture.hpp"
#include "scenarios/session/session.hpp"

namespace app {

using scenarios::session::Snapshot;

/// Where a drill's scene is looked at from at a snapshot: the operative field with all jaws, or what the snapshot says
/// is to be seen from near. aspect: the picture's width over its height.
draw::Camera camera_of(const scenarios::world::WorldDef& world, const Snapshot& snapshot, double aspect);

/// The scene of a drill at a snapshot, seen by this camera, in so many pixels. Reads nothing but these. Some 0.1 ms.
draw::Picture picture_of(const scenarios::world::WorldDef& world, const Snapshot& snapshot, const draw::Camera& camera,
                         int width, int height);

}  // namespace app
