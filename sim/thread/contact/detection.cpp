#include "sim/thread/contact/detection.hpp"

#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/contact/tolerances.hpp"

namespace sim::thread::contact {

using geometry::closest_points;

// A link with both ends in a tool's jaws is inside that tool; every other link must keep out of it.
static bool is_held_by(const State& state, int link, int owner) {
    int ends = 0;
    for (std::size_t h = 0; h < state.input.holds.size(); ++h)
        if (state.input.hold_owners[h] == owner)
            ends += state.input.holds[h].node == link || state.input.holds[h].node == link + 1;
    return ends == 2;
}

Detection::Detection(std::size_t most_links) : tree_(static_cast<int>(most_links)) {
    middles_.reserve(most_links);
}

static void add(State& state, Against against, int link, int other, double thickness,
                const geometry::ClosestPair& pair) {
    state.contacts.push_back({against, link, other, thickness, std::sqrt(pair.distance_squared), 0, pair.t});
}

// Links nearer along the thread than half a turn of its tightest bend cannot be told from the bend itself.
void Detection::detect_self(State& state) {
    constexpr double pi = 3.14159265358979;
    const double reach2 = state.reach * state.reach, half_turn = pi * state.def.radius;
    middles_.resize(state.rest_length.size());
    for (std::size_t k = 0; k < state.rest_length.size(); ++k) {
        const Vec3 &from = state.nodes[k], &to = state.nodes[k + 1];
        middles_[k] = {0.5 * (from + to), 0.5 * (to - from).norm()};
    }
    const auto is_out_of_reach = [&](const Middle& a, const Middle& b) {
        const double far = state.reach + a.half + b.half;
        return (a.place - b.place).squaredNorm() > far * far;
    };
    tree_.self_pairs(state.reach, 2, [&](int i, int j) {
        if (is_out_of_reach(middles_[at(i)], middles_[at(j)])) return;
        if (state.arc[at(j)] - state.arc[at(i + 1)] < half_turn || state.is_cut(at(i)) || state.is_cut(at(j)) ||
            (state.sleeps(i) && state.sleeps(j)))
            return;
        const auto pair =
            closest_points(state.nodes[at(i)], state.nodes[at(i + 1)], state.nodes[at(j)], state.nodes[at(j + 1)]);
        if (pair.distance_squared < reach2)
            add(state, Against::thread, i, j, (1 + margin) * 2 * state.def.radius, pair);
    });
}

void Detection::detect_capsules(State& state) {
    for (std::size_t c = 0; c < state.capsules.size(); ++c) {
        const Capsule& capsule = state.capsules[c];
        const double reach = state.reach + capsule.radius;
        Box box;
        box.include(capsule.a);
        box.include(capsule.b);
        tree_.near(box.grown(reach), [&](int i) {
            if (state.is_cut(at(i))) return;
            const auto pair = closest_points(state.nodes[at(i)], state.nodes[at(i + 1)], capsule.a, capsule.b);
            if (pair.distance_squared < reach * reach && !is_held_by(state, i, state.input.capsules[c].owner))
                add(state, Against::capsule, i, static_cast<int>(c), state.def.radius + capsule.radius, pair);
        });
    }
}

static bool is_sheathed(const State& state, int link) {
    const auto& sheathed = state.input.sheathed;
    return std::find(sheathed.begin(), sheathed.end(), link) != sheathed.end();
}

void Detection::detect_surface(State& state) {
    if (!state.input.surface) return;
    const auto& surface = *state.input.surface;
    tree_.leaves([&](const Box& box, int first, int last) {
        found_.clear();
        surface.near(box.grown(state.reach), found_);
        for (int i = first; i < last; ++i) {
            if (state.is_cut(at(i)) || is_sheathed(state, i)) continue;
            const Vec3 &a0 = state.nodes[at(i)], &a1 = state.nodes[at(i + 1)];
            const Box near_link = Box{a0.cwiseMin(a1), a0.cwiseMax(a1)}.grown(state.reach);
            for (const int triangle : found_) {
                if (!surface.box(triangle).overlaps(near_link) || surface.plane_gap(triangle, a0, a1) >= state.reach)
                    continue;
                const auto pair = closest_points(a0, a1, surface[triangle]);
                if (pair.distance_squared < state.reach * state.reach)
                    add(state, Against::surface, i, triangle, state.def.radius, pair);
            }
        }
    });
}

// Who holds what decides which links a tool may touch.
bool Detection::scene_changed(State& state) {
    std::vector<int>& now = found_;
    now.assign(1, static_cast<int>(state.input.capsules.size()));
    for (std::size_t h = 0; h < state.input.holds.size(); ++h) {
        now.push_back(state.input.holds[h].node);
        now.push_back(state.input.hold_owners[h]);
    }
    for (const MovingCapsule& c : state.input.capsules) now.push_back(c.owner);
    now.push_back(state.input.surface ? state.input.surface->size() : -1);
    const bool changed = now != state.seen;
    state.seen = now;
    return changed;
}

// What was beyond reach cannot touch before something has moved by half the rest. Held nodes and tools that are asked
// to go `path` need that much room besides, for what has not been looked at bounds every node.
bool Detection::is_due(State& state, double path) {
    const double touching = 2 * state.def.radius, unseen = looked_around * state.def.radius - 2 * state.moved;
    const bool roomy = unseen > touching && (state.moved == 0 || bound_share * unseen > 2 * path);
    return scene_changed(state) || !roomy;
}

bool Detection::look_at_tools(State& state, double path) {
    if (!is_due(state, path)) return false;
    state.reach = looked_around * state.def.radius;
    state.moved = 0;
    state.contacts.clear();
    tree_.resize(state.links());
    tree_.refit(state.nodes);
    detect_capsules(state);
    return state.is_rest_due = true;
}

// Strands first, then tools, then walls.
bool Detection::look_around(State& state, double path) {
    const bool looked = look_at_tools(state, path);
    if (!state.is_rest_due) return looked;
    state.is_rest_due = false;
    const auto of_tools = static_cast<std::ptrdiff_t>(state.contacts.size());
    detect_self(state);
    std::rotate(state.contacts.begin(), state.contacts.begin() + of_tools, state.contacts.end());
    detect_surface(state);
    return true;
}

}  // namespace sim::thread::contact
