#include "sim/thread/ftl/slide.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/thread/ftl/clip.hpp"
#include "sim/thread/ftl/resolve.hpp"
#include "sim/thread/ftl/rubbed.hpp"

// A strand that is drawn over walls, its other end free, follows itself: each node goes where the next one was. Least
// motion would rather draw it into the wall at one corner than all that follows round the next. Follow-The-Leader along
// the thread's own line, then passes over contacts: O(n) a pass.
namespace sim::thread::ftl {

// Every piece is led by one tool at most, away from what follows. What lies on itself may be knotted, and a knot comes
// along as a whole.
bool may_slide(const State& state) {
    const auto touches = [&](Against what) {
        return std::any_of(state.rows.begin(), state.rows.end(),
                           [&](const Row& row) { return row.against == what && is_touched(state, row); });
    };
    if (!touches(Against::surface) || touches(Against::thread)) return false;
    bool is_led = false;
    std::size_t last = state.nodes.size();  // that is held in this piece
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        if (state.is_first(i)) last = state.nodes.size();
        if (state.inverse_mass[i] > 0) continue;
        if (last < i && last + 1 != i) return false;
        last = i;
    }
    for (std::size_t h = 0; h < state.hold_from.size(); ++h) {
        const auto i = at(state.input.holds[h].node);
        const Vec3 displacement = state.input.holds[h].target - state.hold_from[h];
        const auto pulls = [&](std::size_t follower) {
            return state.inverse_mass[follower] == 0 || displacement.dot(state.nodes[i] - state.nodes[follower]) >= 0;
        };
        if ((!state.is_first(i) && !pulls(i - 1)) || (!state.is_last(i) && !pulls(i + 1))) return false;
        is_led = is_led || !displacement.isZero(0);
    }
    return is_led;
}

// What rims give back one step draws the tail ahead, and takes up the next. Asked to follow by half the path all the
// time ten bites let half as much through; by a twentieth from the first, slack is dragged along.
void note_whether_it_slides(State& state) {
    const double followed = state.slides ? 0.05 : 0.5;  // of the path
    bool is_led = false, follows = true;
    for_each_tail(state, [&](const Tail& tail) {
        if (state.nodes[tail.held] == state.before[tail.held]) return;
        is_led = true;
        follows = follows && state.last.following[tail.end] >= followed;
    });
    state.slides = may_slide(state) && (is_led ? follows : state.slides);
}

// The point of the path from the follower's old place to its leader's that is at rest length from the leader's new one.
static Vec3 along_itself(const Vec3& leader, const Vec3& leader_was, const Vec3& was, double rest) {
    const Vec3 displacement = leader_was - was, off = was - leader;
    const double a = displacement.squaredNorm(), b = displacement.dot(off), c = off.squaredNorm() - rest * rest,
                 root2 = b * b - a * c;
    const double share = root2 > 0 && a > 0 ? (-b - std::sqrt(root2)) / a : -1;
    return share >= 0 && share <= 1 ? Vec3(was + share * displacement) : Vec3(leader + rest * off.stableNormalized());
}

Slide::Slide(std::size_t most_links) {
    rubbed_.reserve(most_links);
}

// As far as it lies over something; beyond, each follows its leader.
void Slide::follow_along(State& state, FollowLeader& leader) {
    find_rubbed(state, rubbed_);
    for_each_tail(state, [&](const Tail& tail) {
        const std::size_t last = last_rubbed(rubbed_, tail);
        for (std::size_t node = tail.held; node != last; node = tail.next(node)) {
            const std::size_t to = tail.next(node);
            state.nodes[to] = along_itself(state.nodes[node], state.before[node], state.before[to],
                                           state.rest_length[tail.link_to(to)]);
        }
    });
    leader.follow(state);
}

double share_of_slide(const State& state, double path) {
    constexpr double for_following =
        0.3;  // of the bound: a node at a rim is pushed as well, by as much as all rims before it give back
    double share = 1;
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        if (state.inverse_mass[i] > 0) share = std::min(share, for_following * state.bound[i] / path);
    return share;
}

// Corners that walls are deep in are given back little by little: what all of them push draws on all that follows.
static double hold_walls_back(State& state) {
    constexpr double a_step = 0.006;  // of the radius; 0.003 and 0.02 draw the thread through ten bites half as fast
    double deepest = 0;
    for (Row& row : state.rows) {
        deepest = std::max(deepest, over_limit(state, row));
        row.target = std::min(row.target, row.distance + a_step * state.def.radius);
    }
    return deepest;
}

double Slide::slide_along(State& state, FollowLeader& leader, const BendLimit& bends, int& work) {
    constexpr int most_passes = 16;
    constexpr double deep_enough = 0.5;  // of what walls may be in the thread
    const double enough = std::max(deep_enough, hold_walls_back(state));
    follow_along(state, leader);
    clip(state);
    for (int pass = 0; pass < most_passes && (aim(state) > enough || pass == 0); ++pass) {
        ++work;
        resolve_contacts(state);
        bends.limit(state);
        leader.follow(state);
        clip(state);
    }
    return std::max(worst_stretch(state, state.nodes) / stretch_tolerance, aim(state));
}

}  // namespace sim::thread::ftl
