#include "scenarios/drill/tie.hpp"

#include <algorithm>
#include <array>

namespace scenarios::drill {

namespace {

// A tie that is a stack of throws: the first, and what every further one adds.
struct Stack {
    const char *tie, *first, *further;
    int least, most;
};
constexpr std::array<Stack, 4> stacks{{{"overhand", "1", "", 1, 1},
                                       {"square", "1", "=1", 2, 20},
                                       {"granny", "1", "x1", 2, 20},
                                       {"surgeons", "2", "=1", 2, 20}}};

const Stack* stack_of(const std::string& tie) {
    const auto* found = std::find_if(stacks.begin(), stacks.end(), [&](const Stack& s) { return tie == s.tie; });
    return found == stacks.end() ? nullptr : found;
}

std::string notation(const Stack& stack, int throws) {
    std::string text = stack.first;
    for (int i = 1; i < throws; ++i) text += stack.further;
    return text;
}

}  // namespace

int throw_count(const std::string& notation) {
    return static_cast<int>(
        std::count_if(notation.begin(), notation.end(), [](char c) { return c >= '1' && c <= '9'; }));
}

bool is_hitch(const std::string& tie) {
    return tie == "clove hitch" || tie == "constrictor" || tie == "cow hitch" || tie == "prusik";
}

GoalFault fault_of(const Goal& goal, bool has_vessel) {
    if (is_hitch(goal.tie) && !has_vessel)
        return {"tie", "a " + goal.tie + " needs a vessel to be tied round, and there is none"};
    if (goal.times > 1 && is_hitch(goal.tie)) return {"times", "hitches are looked for in one thread, expected a knot"};
    if (goal.times > 1 && !goal.around.empty())
        return {"around", "knots in several threads are not looked for round a vessel, expected no such key"};
    const Stack* stack = stack_of(goal.tie);
    const int asked = goal.notation.empty() ? goal.throws : throw_count(goal.notation);
    if (asked == 0) return {};
    if (!stack) return {"throws", "a " + goal.tie + " has no throws, expected no such key"};
    if (asked < stack->least || asked > stack->most)
        return {"throws", "expected " + std::string(stack->most == 1 ? "1" : "2 or more") + " for \"" + goal.tie +
                              "\", found " + std::to_string(asked)};
    if (const std::string right = notation(*stack, asked); !goal.notation.empty() && goal.notation != right)
        return {"throws", "expected \"" + right + "\" for \"" + goal.tie + "\", found \"" + goal.notation + "\""};
    return {};
}

std::string throws_asked(const Goal& goal) {
    const Stack* stack = stack_of(goal.tie);
    return !goal.notation.empty() || !stack || goal.throws == 0 ? goal.notation : notation(*stack, goal.throws);
}

}  // namespace scenarios::drill
