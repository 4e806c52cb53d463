#include <algorithm>
#include <chrono>

#include "app/bench/trace.hpp"

namespace app::bench {

static double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Outcome> examine(const HardCase& hard_case, bool quick) {
    std::vector<Outcome> outcomes;
    for (const Condition& condition : hard_case.conditions) outcomes.push_back({condition, 0, 0});
    const std::size_t scenes = quick ? 1 : hard_case.scenes.size();
    for (std::size_t s = 0; s < scenes; ++s) {
        const auto start = std::chrono::steady_clock::now();
        const Scene& scene = hard_case.scenes[s];
        const Trace trace = play(scene);
        const double share = seconds_since(start) / static_cast<double>(outcomes.size());  // playing serves all alike
        for (Outcome& outcome : outcomes) {
            const auto measuring = std::chrono::steady_clock::now();
            const double value = condition_kind(outcome.condition.is).measure(scene, trace, outcome.condition);
            const bool most = outcome.condition.must == Must::be_at_most;
            outcome.value = s == 0 ? value : most ? std::max(outcome.value, value) : std::min(outcome.value, value);
            outcome.seconds += share + seconds_since(measuring);
        }
    }
    return outcomes;
}

}  // namespace app::bench
