#include <algorithm>

#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/trace.hpp"

namespace bench::lab {

bool is_asked_of(const Scene& scene, const Condition& condition) {
    const std::string model = !scene.drill.empty() ? scene.model : scene.thread.elastic ? "elastic" : "ftl";
    return condition.model.empty() || condition.model == model;
}

std::vector<Outcome> examine(const HardCase& hard_case, bool quick) {
    std::vector<Outcome> outcomes;
    for (const Condition& condition : hard_case.conditions) outcomes.push_back({condition});
    const std::size_t scenes = quick ? 1 : hard_case.scenes.size();
    for (std::size_t s = 0; s < scenes; ++s) {
        const Stopwatch playing;
        const Scene& scene = hard_case.scenes[s];
        const Trace trace = play(scene);
        const double share = playing.seconds() / static_cast<double>(outcomes.size());  // playing serves all alike
        for (Outcome& outcome : outcomes) {
            if (!is_asked_of(scene, outcome.condition)) continue;
            const Stopwatch measuring;
            const double value = condition_kind(outcome.condition.is).measure(scene, trace, outcome.condition);
            const bool most = outcome.condition.must == Must::be_at_most;
            outcome.value = !outcome.measured ? value
                            : most            ? std::max(outcome.value, value)
                                              : std::min(outcome.value, value);
            outcome.measured = true;
            outcome.seconds += share + measuring.seconds();
        }
    }
    std::erase_if(outcomes, [](const Outcome& outcome) { return !outcome.measured; });
    return outcomes;
}

}  // namespace bench::lab
