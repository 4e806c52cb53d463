// Are the drills' motions staged? Each key of a motion is moved by up to 0.05 mm and turned by up to 0.5 degrees, the
// whole is played at half, full and double pace, and the knot must still come out. One line a run; exit 3 when fewer
// than 95 of 100 runs are named right, or anything passed through anything.
//   shaken DRILL NAME FIRST_SEED LAST_SEED
#include <cstdio>
#include <cstdlib>

#include "scenarios/session/scene.hpp"
#include "tests/drills/shake.hpp"

namespace {

using instruments::ToolInput;
using scenarios::drill::Motion;

struct Outcome {
    bool right;
    std::uint64_t pass_throughs;
};

Outcome play(const scenarios::drill::Drill& drill, const Motion& motion, const std::string& name, unsigned seed,
             double pace) {
    std::vector<ToolInput> inputs(drill.world.instruments.size());
    motion.at(0, inputs);
    auto world = scenarios::session::make_world(drill.world, scenarios::session::vessel_meshes(drill.world), inputs);
    const double tick_s = drill.world.tick_s, settling_s = 0.5;
    const auto ticks = static_cast<std::uint64_t>((motion.duration() + settling_s) / tick_s);
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        motion.at(static_cast<double>(tick) * tick_s, inputs);
        world.tick(inputs);
    }
    world.name_knot_now();
    const auto& knot = world.measures().knot;
    const Outcome outcome{knot.surgical == name && knot.certain, world.measures().pass_throughs};
    std::printf(
        "seed %2u pace %.1f: %-10s %-8s %-14s pass-throughs %llu, stretch at most %.3f %%, at rest %.3f %%, step/bound "
        "%.3f\n",
        seed, pace, knot.surgical.c_str(), knot.throws.c_str(), knot.knot.c_str(),
        static_cast<unsigned long long>(outcome.pass_throughs), 100 * world.worst().stretch, 100 * world.stretch_now(),
        world.worst().step_over_bound);
    std::fflush(stdout);
    return outcome;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) return std::fprintf(stderr, "usage: shaken DRILL NAME FIRST_SEED LAST_SEED\n"), 2;
    const auto drill = scenarios::drill::load_drill(argv[1]);
    const Motion motion = scenarios::drill::load_motion(drill.motion, scenarios::drill::instrument_names(drill));
    int runs = 0, right = 0;
    std::uint64_t pass_throughs = 0;
    for (unsigned seed = static_cast<unsigned>(std::atoi(argv[3])); seed <= static_cast<unsigned>(std::atoi(argv[4]));
         ++seed)
        for (const double pace : {0.5, 1.0, 2.0}) {
            const Outcome outcome = play(drill, shake::shaken(motion, seed, pace), argv[2], seed, pace);
            ++runs;
            right += outcome.right;
            pass_throughs += outcome.pass_throughs;
        }
    std::printf("%d of %d named %s, %llu pass-throughs\n", right, runs, argv[2],
                static_cast<unsigned long long>(pass_throughs));
    return right * 100 >= runs * 95 && pass_throughs == 0 ? 0 : 3;
}
