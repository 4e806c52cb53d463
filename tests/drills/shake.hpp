#pragma once
#include <random>

#include "scenarios/drill/motion.hpp"

// A motion as another hand makes it: each key is moved by up to 0.05 mm and turned by up to 0.5 degrees.
namespace shake {

/// Evenly in the ball of radius 1, by rejection: the same numbers with every standard library.
inline sim::geometry::Vec3 in_ball(std::mt19937& random) {
    const auto number = [&] { return 2.0 * random() / 4294967295.0 - 1; };
    for (;;) {
        const double x = number(), y = number(), z = number();
        if (x * x + y * y + z * z <= 1) return {x, y, z};
    }
}

/// The motion, shaken, at `pace` times its speed.
inline scenarios::drill::Motion shaken(const scenarios::drill::Motion& motion, unsigned seed, double pace = 1) {
    constexpr double by_m = 0.05e-3, by_rad = 0.5 * 3.14159265358979 / 180;
    std::mt19937 random(seed);
    std::vector<std::vector<scenarios::drill::MotionKey>> keys(motion.keys().begin(), motion.keys().end());
    for (auto& tool : keys)
        for (auto& key : tool) {
            key.t_s /= pace;
            key.input.pose.position += by_m * in_ball(random);
            const sim::geometry::Vec3 turn = by_rad * in_ball(random);
            key.input.pose.rotation =
                (sim::geometry::Quat(1, turn.x() / 2, turn.y() / 2, turn.z() / 2) * key.input.pose.rotation)
                    .normalized();
        }
    return scenarios::drill::Motion(keys);
}

}  // namespace shake
