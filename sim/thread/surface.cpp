#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/thread/elastic/press.hpp"

namespace sim::thread {

static void find_pressed(State& state) {
    const auto force_of = [](const Row& row) -> SurfaceForce { return {row.other, row.fixed, -row.push(), row.link}; };
    for (const Row& row : state.pressed) {
        if (row.against != Against::surface) continue;
        state.surface_forces.push_back(force_of(row));
        state.surface_forces.back().deeper = give_of_wall(state, row) * (row.began - row.push());
    }
    for (const SleepingPress& press : state.sleeping) {
        if (press.row.against != Against::surface) continue;
        state.surface_forces.push_back(force_of(press.row));
        state.surface_forces.back().asleep = press.wall;
    }
}

// Nodes that turn a taut strand by resting on a wall: both links pull there.
static void find_turned(State& state) {
    for (int i = 1; i < state.links(); ++i) {
        const double before = state.tension[at(i - 1)], after = state.tension[at(i)];
        if (before == 0 && after == 0) continue;
        const Vec3& node = state.nodes[at(i)];
        const auto towards = [&](int other) { return Vec3((state.nodes[at(other)] - node).normalized()); };
        const Row* nearest = nullptr;
        for (const Row& row : state.rows)
            if (row.against == Against::surface && (row.link == i || row.link == i - 1) &&
                (!nearest || row.distance < nearest->distance))
                nearest = &row;
        if (nearest && nearest->distance < 1.5 * nearest->thickness)
            state.surface_forces.push_back(
                {nearest->other, nearest->fixed, before * towards(i - 1) + after * towards(i + 1), i});
    }
}

void find_surface_forces(State& state) {
    state.surface_forces.clear();
    if (!state.input.surface) return;
    if (state.rod)
        find_pressed(state);
    else
        find_turned(state);
}

}  // namespace sim::thread
