#include "scenarios/drill/motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scenarios/drill/shape.hpp"
#include "sim/geometry/portable_math.hpp"

namespace scenarios::drill {

using instruments::ToolInput;

Motion::Motion(std::vector<std::vector<MotionKey>> keys) : keys_(std::move(keys)) {
    for (const auto& list : keys_) {
        assert(!list.empty() && "each instrument has a key");
        assert(std::adjacent_find(list.begin(), list.end(), [](auto& a, auto& b) { return !(a.t_s < b.t_s); }) ==
                   list.end() &&
               "keys increase in time");
    }
}

static ToolInput between(const MotionKey& from, const MotionKey& to, double t) {
    const double u = (t - from.t_s) / (to.t_s - from.t_s);
    const auto mix = [u](const auto& a, const auto& b) { return (a + u * (b - a)); };
    ToolInput input;
    input.pose.position = mix(from.input.pose.position, to.input.pose.position);
    input.pose.rotation = sim::geometry::portable_slerp(from.input.pose.rotation, to.input.pose.rotation, u);
    input.jaw = std::clamp(mix(from.input.jaw, to.input.jaw), 0.0, 1.0);
    return input;
}

void Motion::at(double t, std::span<ToolInput> tools) const {
    assert(tools.size() == keys_.size() && "one tool per instrument");
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const auto& list = keys_[i];
        const auto next =
            std::upper_bound(list.begin(), list.end(), t, [](double x, const MotionKey& key) { return x < key.t_s; });
        if (next == list.begin())
            tools[i] = list.front().input;
        else if (next == list.end())
            tools[i] = list.back().input;
        else
            tools[i] = between(*(next - 1), *next, t);
    }
}

double Motion::duration() const {
    double last = 0;
    for (const auto& list : keys_) last = std::max(last, list.back().t_s);
    return last;
}

std::string Motion::cut_short_at(double limit_s) const {
    if (duration() + settling_s < limit_s) return "";
    return "/time_limit_s: " + shown(limit_s) + " s end the drill before its motion, which takes " +
           shown(std::ceil(1e2 * duration()) / 1e2) + " s and " + shown(settling_s) + " s of rest";
}

}  // namespace scenarios::drill
