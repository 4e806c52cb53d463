#include "scenarios/session/view.hpp"

#include <algorithm>

namespace scenarios::session {

std::string held_by(const scenarios::world::World& world, std::size_t number) {
    const auto& tool = world.tools()[number];
    const bool has_needle = std::ranges::any_of(
        world.needles(), [&](const auto& needle) { return needle.is_held_by(static_cast<int>(number)); });
    std::string held;
    for (const auto& [is_held, what] : {std::pair(!tool.grasps.empty(), "thread"), std::pair(has_needle, "needle"),
                                        std::pair(!tool.walls.empty(), "wall")})
        if (is_held) held += (held.empty() ? "" : " and ") + std::string(what);
    return held;
}

void look_at(const Session& session, std::size_t first_event, View& view) {
    const scenarios::world::World& world = session.world();
    view.tick = world.ticks();
    view.t_s = world.time_s();
    view.scene = session.snapshot("");
    view.tension_N = world.tension_now();
    view.tension_max_N = world.measures().tension_max_N.value;
    view.tools.clear();
    for (std::size_t i = 0; i < world.tools().size(); ++i) {
        const auto& tool = world.tools()[i];
        view.tools.push_back({tool.def.name, tool.def.kind, held_by(world, i), 1e3 * tool.lag()});
    }
    view.knot = world.measures().knot.called();
    const auto events = world.events().subspan(first_event);
    view.events.assign(events.begin(), events.end());
    view.first_event = first_event;
}

}  // namespace scenarios::session
