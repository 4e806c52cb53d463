#pragma once
#include <cstdlib>
#include <exception>
#include <iostream>

#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/peers/pull_json.hpp"

namespace bench::peers {

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

/// Links nearer along the rope than half a turn of the tightest bend may not collide; lab::Gauge leaves out the
/// same.
inline int neighbours(const lab::PullDef& def) {
    return static_cast<int>(std::ceil(0.5 * M_PI * def.thickness() / def.link())) + 1;
}

/// PROGRAM LINKS SPEED [ITERATIONS]: pulls and prints the figures as one line of JSON.
template <class PeerRope>
int run(int argc, char** argv) try {
    if (argc < 3) throw std::runtime_error("expected: LINKS SPEED [ITERATIONS]");
    const lab::PullDef def{.links = std::atoi(argv[1]), .speed = std::atof(argv[2])};
    Settings settings;
    if (argc > 3) settings.iterations = std::atoi(argv[3]);
    if (def.links < 50 || !(def.speed > 0) || settings.iterations < 1)
        throw std::runtime_error("expected at least 50 links, the others above 0");
    const lab::OneCore pinned;
    const auto start = lab::overhand(def.links, def.length);
    PeerRope rope(def, settings, start);
    std::cout << to_json(lab::pull(rope, def, start)) << '\n';
    return 0;
} catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << '\n';
    return 2;
}

}  // namespace bench::peers
