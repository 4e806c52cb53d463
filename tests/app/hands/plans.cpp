#include "tests/app/hands/plans.hpp"

namespace app::hands {

std::vector<Goal> square_knot(const scenarios::drill::Motion& motion, bool pulls_both) {
    std::vector<Goal> goals = goals_of(motion, {{1, 6.1e-3}, {1, -1}, {1, 12e-3}});
    for (const std::size_t k : {23, 24}) goals[k].at[1] = Vec3(-15e-3, 16.5e-3, 3e-3);
    for (const std::size_t k : {25, 26}) goals[k].at[1] = Vec3(7e-3, 16.5e-3, 11.8e-3);
    for (const std::size_t k : {20, 21, 22, 46, 47, 48, 49, 50, 51, 52}) goals[k].pulls = true, goals[k].care = 0.35;
    // Once a throw is tight the forceps stay where they are until the strand is to be carried.
    for (const std::size_t k : {23, 24, 25, 26}) goals[k].at[0].reset();
    for (const std::size_t k : {51, 52}) goals[k].at = {{}, {}};
    if (!pulls_both) return goals;
    goals[48].deed = Deed::pull_both;
    goals.erase(goals.begin() + 49, goals.begin() + 51);
    return goals;
}

std::vector<Goal> single_bite() {
    constexpr double degree = 0.0174533;
    using Place = std::optional<Vec3>;
    const auto mm = [](double x, double y, double z) { return Place(Vec3(1e-3 * x, 1e-3 * y, 1e-3 * z)); };
    std::vector<Goal> goals;
    const auto go = [&](Place left, bool left_shut, Place right, bool right_shut, double care) {
        goals.push_back({{left, right}, {{}, {}}, {left_shut, right_shut}, care});
    };
    const auto turn = [&](Deed deed, double by) {
        goals.push_back(goals.back());
        goals.back().deed = deed, goals.back().turn = by * degree;
    };
    go(mm(-2, 1, 1.75), false, {}, true, 0.5);
    goals.back().is_fine = true;
    go({}, true, {}, true, 1);
    turn(Deed::turn_needle, 135);
    go({}, false, {}, true, 1);
    go(mm(2, 6, 8), false, {}, true, 1);
    turn(Deed::roll, 75);
    go(mm(7.7, 3, 3.44), false, {}, true, 0.5);
    go(mm(2.75, -0.72, 3.44), false, {}, true, 0.3);
    go({}, true, {}, true, 1);
    go({}, true, {}, false, 1);
    go({}, true, mm(-2.8, -8, 2), false, 0.5);
    turn(Deed::swap, 0);
    turn(Deed::turn_needle, 130);
    go(mm(6, -1.5, 20), true, {}, false, 1);
    go(mm(12, -1.5, 34), true, {}, false, 1);
    return goals;
}

}  // namespace app::hands
