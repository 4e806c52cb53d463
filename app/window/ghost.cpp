#include "app/window/ghost.hpp"

#include <algorithm>
#include <cmath>

namespace app::window {

using instruments::ToolInput;

namespace {

bool moves(const scenarios::drill::Motion& motion, std::size_t tool, double from_s, double to_s, std::size_t count) {
    constexpr double least = 0.5e-3, arm = 10e-3;  // [m]
    std::vector<ToolInput> first(count), now(count);
    motion.at(from_s, first);
    for (int part = 1; part <= 10; ++part) {
        motion.at(from_s + (to_s - from_s) * part / 10, now);
        if (instruments::distance_between(first[tool].pose, now[tool].pose, arm) > least ||
            std::abs(first[tool].jaw - now[tool].jaw) > 0.2)
            return true;
    }
    return false;
}

}  // namespace

std::vector<draw::ToolPicture> Ghost::tools(const scenarios::drill::Drill& drill,
                                            const scenarios::drill::Motion& reference, std::size_t step, double now_s) {
    constexpr double rest_s = 1;  // at the step's end, so that it is seen where it leads
    if (step >= drill.steps.size() || !drill.steps[step].reference_s) return {};
    if (step_ != step) step_ = step, begin_s_ = now_s;
    const auto [from_s, to_s] = *drill.steps[step].reference_s;
    const double at_s = from_s + std::min(std::fmod(now_s - begin_s_, to_s - from_s + rest_s), to_s - from_s);
    std::vector<ToolInput> inputs(drill.world.instruments.size());
    reference.at(at_s, inputs);
    std::vector<draw::ToolPicture> ghosts;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (moves(reference, i, from_s, to_s, inputs.size()))
            ghosts.push_back({drill.world.instruments[i].kind, inputs[i].pose, inputs[i].jaw});
    return ghosts;
}

}  // namespace app::window
