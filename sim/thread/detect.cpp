#include "sim/geometry/closest_points.hpp"
#include "sim/thread/state.hpp"

namespace sim::thread {

using geometry::closest_points;

static std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A link with both ends in a tool's jaws is inside that tool; every other link must keep out of it.
static bool is_held_by(const State& state, int link, int owner) {
    int ends = 0;
    for (std::size_t h = 0; h < state.input.holds.size(); ++h)
        if (state.input.hold_owners[h] == owner)
            ends += state.input.holds[h].node == link || state.input.holds[h].node == link + 1;
    return ends == 2;
}

static void add(State& state, Against against, int link, int other, double thickness, double friction, double gap) {
    state.contacts.push_back({against, link, other, gap, thickness, friction});
}

static void detect_self(State& state) {
    const double reach2 = state.reach * state.reach;
    state.tree.self_pairs(state.reach, state.skip, [&](int i, int j) {
        const auto pair = closest_points(state.nodes[at(i)], state.nodes[at(i + 1)], state.nodes[at(j)], state.nodes[at(j + 1)]);
        if (pair.distance_squared < reach2)
            add(state, Against::thread, i, j, 2 * state.def.radius, state.def.friction, std::sqrt(pair.distance_squared));
    });
}

static void detect_capsules(State& state) {
    for (std::size_t c = 0; c < state.capsules.size(); ++c) {
        const Capsule& capsule = state.capsules[c];
        const double reach = state.reach + capsule.radius;
        Box box;
        box.include(capsule.a);
        box.include(capsule.b);
        state.tree.near(box.grown(reach), [&](int i) {
            const auto pair = closest_points(state.nodes[at(i)], state.nodes[at(i + 1)], capsule.a, capsule.b);
            if (pair.distance_squared < reach * reach && !is_held_by(state, i, state.input.capsules[c].owner))
                add(state, Against::capsule, i, static_cast<int>(c), state.def.radius + capsule.radius,
                    state.def.friction_tool, std::sqrt(pair.distance_squared));
        });
    }
}

static void detect_surface(State& state) {
    if (!state.input.surface) return;
    const auto& surface = *state.input.surface;
    state.tree.leaves([&](const Box& box, int first, int last) {
        state.found.clear();
        surface.near(box.grown(state.reach), state.found);
        for (const int triangle : state.found)
            for (int i = first; i < last; ++i) {
                const auto pair = closest_points(state.nodes[at(i)], state.nodes[at(i + 1)], surface[triangle]);
                if (pair.distance_squared < state.reach * state.reach)
                    add(state, Against::surface, i, triangle, state.def.radius, state.def.friction, std::sqrt(pair.distance_squared));
            }
    });
}

void detect(State& state, double reach) {
    state.reach = reach;
    state.moved = 0;
    state.contacts.clear();
    state.tree.refit(state.nodes);
    detect_self(state);
    detect_capsules(state);
    detect_surface(state);
}

geometry::ClosestPair nearest(const State& state, const Contact& c) {
    const Vec3 &a0 = state.nodes[at(c.link)], &a1 = state.nodes[at(c.link + 1)];
    if (c.against == Against::surface) {
        // Within a substep the wall is the plane through the point that was nearest when it began: the link moves by less
        // than the thread's radius meanwhile, and the next substep looks again.
        const Vec3 on_link = a0 + c.link_place * (a1 - a0);
        const double height = std::max(0.0, (on_link - c.wall).dot(c.normal));
        return {c.link_place, 0, on_link, on_link - height * c.normal, height * height};
    }
    if (c.against == Against::capsule) return closest_points(a0, a1, state.capsules[at(c.other)].a, state.capsules[at(c.other)].b);
    return closest_points(a0, a1, state.nodes[at(c.other)], state.nodes[at(c.other + 1)]);
}

// Most triangles about a link are out of its reach: the nearer of its ends' heights over their plane says so at once, and
// is a gap on the safe side.
static void find_wall(const State& state, Contact& c) {
    const Vec3 &a0 = state.nodes[at(c.link)], &a1 = state.nodes[at(c.link + 1)];
    const geometry::Triangle& triangle = (*state.input.surface)[c.other];
    const Vec3 up = (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalized();
    const double h0 = up.dot(a0 - triangle.a), h1 = up.dot(a1 - triangle.a);
    c.gap = (h0 > 0) == (h1 > 0) ? std::min(std::abs(h0), std::abs(h1)) : 0;
    if (c.gap > 3 * c.thickness) return;
    const auto pair = closest_points(a0, a1, triangle);
    c.gap = std::sqrt(pair.distance_squared);
    if (c.gap > 0) c.normal = (pair.on_a - pair.on_b) / c.gap;
    c.link_place = pair.s;
    c.wall = pair.on_b;
}

// A node may use `bound_share` of the distance from either of its links to whatever they are not joined to. Things not
// among the contacts were farther than `reach` and have come nearer by twice `moved` at most.
void measure_gaps(State& state) {
    const double unseen = std::max(0.0, state.reach - 2 * state.moved);
    std::fill(state.bound.begin(), state.bound.end(), bound_share * unseen);
    const auto tighten = [&](int link, double room) {
        state.bound[at(link)] = std::min(state.bound[at(link)], room);
        state.bound[at(link + 1)] = std::min(state.bound[at(link + 1)], room);
    };
    for (Contact& c : state.contacts) {
        if (c.against == Against::surface) {
            find_wall(state, c);
        } else {
            const auto pair = nearest(state, c);
            c.gap = std::sqrt(pair.distance_squared);
            c.place = pair.t;
        }
        // A surface stands still, so the thread may use both shares.
        tighten(c.link, c.against == Against::surface ? 2 * bound_share * c.gap : bound_share * c.gap);
        if (c.against == Against::thread) tighten(c.other, bound_share * c.gap);
    }
    state.active.clear();
    for (std::size_t k = 0; k < state.contacts.size(); ++k) {
        Contact& c = state.contacts[k];
        c.normal_push = 0;
        c.tangent_push.setZero();
        // No more overlap is undone at once than leaves the nodes most of their bound: clipped moves would stretch links.
        constexpr double for_parting = 0.25;
        c.target = std::min(c.thickness, c.gap + for_parting * std::min(state.bound[at(c.link)], state.bound[at(c.link + 1)]));
        // A substep moves what touches by less than a radius; what is missed now is met next time, outside its bound still.
        const double closing = 2 * std::min(state.def.radius, std::max(state.bound[at(c.link)], state.bound[at(c.link + 1)]));
        if (c.gap < c.thickness + closing) state.active.push_back(static_cast<int>(k));
    }
}

}  // namespace sim::thread
