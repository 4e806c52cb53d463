#include "sim/thread/contact/tools.hpp"

#include "sim/geometry/at.hpp"

namespace sim::thread::contact {

Motion longest_asked(const State& state) {
    Motion motion;
    for (std::size_t h = 0; h < state.hold_from.size(); ++h)
        motion.of_holds = std::max(motion.of_holds, (state.input.holds[h].target - state.hold_from[h]).norm());
    for (const MovingCapsule& c : state.input.capsules)
        motion.of_capsules = std::max({motion.of_capsules, (c.to.a - c.from.a).norm(), (c.to.b - c.from.b).norm()});
    return motion;
}

static Vec3 mix(const Vec3& a, const Vec3& b, double t) {
    return a + t * (b - a);
}

void place_capsules(State& state) {
    state.capsules.resize(state.input.capsules.size());
    for (std::size_t c = 0; c < state.capsules.size(); ++c) {
        const MovingCapsule& moving = state.input.capsules[c];
        const double progress = state.progress[at(moving.owner + 1)];
        state.capsules[c] = {mix(moving.from.a, moving.to.a, progress), mix(moving.from.b, moving.to.b, progress),
                             moving.from.radius};
    }
}

double largest_capsule_move(const State& state) {
    double moved = 0;
    for (std::size_t c = 0; c < state.capsules.size(); ++c)
        moved = std::max({moved, (state.capsules[c].a - state.capsules_before[c].a).norm(),
                          (state.capsules[c].b - state.capsules_before[c].b).norm()});
    return moved;
}

double unseen_room(const State& state) {
    return std::max(state.def.radius, state.reach - 2 * state.moved - state.def.radius);
}

double share_beside(const State& state, const Contact& c) {
    const MovingCapsule& tool = state.input.capsules[static_cast<std::size_t>(c.other)];
    const Vec3 displacement = tool.to.a - tool.from.a + c.place * (tool.to.b - tool.to.a - tool.from.b + tool.from.a);
    return std::max(state.def.radius, c.gap - c.thickness) / displacement.norm();
}

}  // namespace sim::thread::contact
