#include <algorithm>

#include "app/bench/stopwatch.hpp"
#include "app/bench/trace.hpp"

namespace app::bench {

std::vector<Outcome> examine(const HardCase& hard_case, bool quick) {
    std::vector<Outcome> outcomes;
    for (const Condition& condition : hard_case.conditions) outcomes.push_back({condition, 0, 0});
    const std::size_t scenes = quick ? 1 : hard_case.scenes.size();
    for (std::size_t s = 0; s < scenes; ++s) {
        const Stopwatch playing;
        const Scene& scene = hard_case.scenes[s];
        const Trace trace = play(scene);
        const double share = playing.seconds() / static_cast<double>(outcomes.size());  // playing serves all alike
        for (Outcome& outcome : outcomes) {
            const Stopwatch measuring;
            const double value = condition_kind(outcome.condition.is).measure(scene, trace, outcome.condition);
            const bool most = outcome.condition.must == Must::be_at_most;
            outcome.value = s == 0 ? value : most ? std::max(outcome.value, value) : std::min(outcome.value, value);
            outcome.seconds += share + measuring.seconds();
        }
    }
    return outcomes;
}

}  // namespace app::bench
