#include "scenarios/session/script.hpp"

#include <algorithm>
#include <cmath>

#include "scenarios/session/scene.hpp"

namespace scenarios::session {

Script::Script(const std::filesystem::path& file) : Script(drill::load_drill(file)) {}

Script::Script(drill::Drill of)
    : drill(std::move(of)), motion(drill::load_motion(drill.motion, drill::instrument_names(drill))) {}

std::uint64_t Script::ticks() const {
    const double length_s = std::min(motion.duration() + drill::settling_s, drill.time_limit_s);
    return static_cast<std::uint64_t>(std::ceil(length_s / drill.world.tick_s));
}

std::vector<instruments::ToolInput> Script::inputs(std::uint64_t tick) const {
    std::vector<instruments::ToolInput> inputs(drill.world.instruments.size());
    motion.at(static_cast<double>(tick) * drill.world.tick_s, inputs);
    return inputs;
}

world::World Script::start() const {
    return make_world(drill.world, vessel_meshes(drill.world), inputs(0));
}

}  // namespace scenarios::session
