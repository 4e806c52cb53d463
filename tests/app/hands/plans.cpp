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

}  // namespace app::hands
