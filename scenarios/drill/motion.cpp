#include "scenarios/drill/motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scenarios/drill/schema.hpp"
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

// Time between rows that half of them keep [s]; 0 where they do not come evenly, or are few.
static double usual_step(const std::vector<MotionKey>& list) {
    constexpr std::size_t fewest = 10;
    constexpr double even = 2, share = 0.9;  // so many of them are no longer than that, in usual steps
    std::vector<double> steps;
    for (std::size_t i = 1; i < list.size(); ++i) steps.push_back(list[i].t_s - list[i - 1].t_s);
    if (steps.size() < fewest) return 0;
    std::sort(steps.begin(), steps.end());
    const double usual = steps[steps.size() / 2];
    const auto most = static_cast<std::size_t>(share * static_cast<double>(steps.size() - 1));
    return steps[most] <= even * usual ? usual : 0;
}

static bool is_same(const ToolInput& a, const ToolInput& b) {
    return a.pose.position == b.pose.position && a.pose.rotation.coeffs() == b.pose.rotation.coeffs() && a.jaw == b.jaw;
}

std::vector<std::string> Motion::gaps(std::span<const std::string> instruments) const {
    assert(instruments.size() == keys_.size() && "one name per instrument");
    constexpr double shortest_s = 0.25, usual_steps = 4;
    const auto rounded = [](double value) { return shown(std::round(1e3 * value) / 1e3); };
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const auto& list = keys_[i];
        const double usual = usual_step(list);
        std::size_t longest = 0, count = 0;
        const auto length = [&](std::size_t k) { return k == 0 ? 0 : list[k].t_s - list[k - 1].t_s; };
        for (std::size_t k = 1; usual > 0 && k < list.size(); ++k) {
            if (length(k) <= std::max(shortest_s, usual_steps * usual) || is_same(list[k - 1].input, list[k].input))
                continue;
            ++count;
            if (length(k) > length(longest)) longest = k;
        }
        if (count == 0) continue;
        const MotionKey &from = list[longest - 1], &to = list[longest];
        sentences.push_back("\"" + instruments[i] + "\" has no row between " + rounded(from.t_s) + " and " +
                            rounded(to.t_s) + " s, where others are " + rounded(usual) +
                            " s apart, and goes straight over the gap, by " +
                            rounded(1e3 * (to.input.pose.position - from.input.pose.position).norm()) + " mm" +
                            (count > 1 ? "; it has " + std::to_string(count) + " such gaps" : ""));
    }
    return sentences;
}

}  // namespace scenarios::drill
