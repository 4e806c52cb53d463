#pragma once
#include <cstdlib>
#include <exception>
#include <iostream>

#include "app/bench/core.hpp"
#include "app/bench/pull_json.hpp"
#include "app/bench/shape.hpp"

namespace peer {

using app::bench::PullDef;
using app::bench::Rope;
using sim::geometry::Vec3;

/// Peers of the overhand pull are ropes of rigid capsules, one a link, joined by ball joints. What they share:
struct Settings {
    double scale = 100;           ///< Their units in a metre: both are tuned for bodies about one unit big.
    double mass = 0.02;           ///< Of the rope [kg].
    double linear_damping = 0.1;  ///< [1/s] Enough for the rope to come to rest.
    double angular_damping = 1;   ///< [1/s]
    double error_reduction =
        0.5;              ///< Share of a joint's error undone in a tick; at the usual 0.2 links grow twice as long.
    int iterations = 10;  ///< Bullet's own number, half of ODE's. Fifty halve the stretch for thrice the cost.
};

/// Links nearer along the rope than half a turn of the tightest bend may not collide; app::bench::Gauge leaves out the
/// same.
inline int neighbours(const PullDef& def) {
    return static_cast<int>(std::ceil(0.5 * M_PI * def.thickness() / def.link())) + 1;
}

/// PROGRAM LINKS SPEED [ITERATIONS]: pulls and prints the figures as one line of JSON.
template <class PeerRope>
int run(int argc, char** argv) try {
    if (argc < 3) throw std::runtime_error("expected: LINKS SPEED [ITERATIONS]");
    const PullDef def{.links = std::atoi(argv[1]), .speed = std::atof(argv[2])};
    Settings settings;
    if (argc > 3) settings.iterations = std::atoi(argv[3]);
    if (def.links < 50 || !(def.speed > 0) || settings.iterations < 1)
        throw std::runtime_error("expected at least 50 links, the others above 0");
    const app::bench::OneCore pinned;
    const auto start = app::bench::overhand(def.links, def.length);
    PeerRope rope(def, settings, start);
    std::cout << app::bench::to_json(app::bench::pull(rope, def, start)) << '\n';
    return 0;
} catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << '\n';
    return 2;
}

}  // namespace peer
