#pragma once
#include "app/hands/sight.hpp"

namespace app::hands {

constexpr double shut_below = 0.25;  ///< Jaws that are to be less open than this (0 to 1) shut, as the world has it.

/// An instrument as its hand leads it.
struct Led {
    ToolInput at;          ///< Where it is asked to be.
    double jaw_goal = 1;   ///< Where its jaws are going, 0 to 1.
    double opening = 0.7;  ///< How far they open next, 0 to 1.
    bool waits = false;    ///< Its jaws stay as they are while it glides to what they are to take.

    /// Whether its jaws are to shut.
    bool shuts() const { return jaw_goal < shut_below; }
    /// Whether its jaws are open.
    bool is_open() const { return at.jaw >= shut_below; }
};

/// The rotation by a vector's length [rad] about its direction.
Quat rotation_of(const Vec3& turn);

/// Turned from `from` towards `to`, by `most` [rad]; `to` itself where that is enough, and `from`, bit for bit, where
/// they are the same.
Quat turned_towards(const Quat& from, const Quat& to, double most);

}  // namespace app::hands
