#include <algorithm>

#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/trace.hpp"

// Conditions on walls that give way, on what a needle did to them and on the thread that followed it.
namespace bench::lab {

namespace {

bool is_due(const Condition& condition, double t) {
    return t >= condition.from && t <= condition.to;
}

double smallest_tetrahedron(const Trace& trace, const Condition& condition) {
    double least = 1;
    for (std::size_t i = 0; i < trace.frames.size(); ++i)
        if (is_due(condition, static_cast<double>(i + 1) * trace.tick))
            least = std::min(least, trace.frames[i].smallest_tetrahedron);
    return least;
}

double events(const Trace& trace, const Condition& condition) {
    return static_cast<double>(std::count_if(trace.events.begin(), trace.events.end(), [&](const auto& e) {
        return e.name() == condition.event && is_due(condition, e.t_s);
    }));
}

double wall_apart(const Frame& frame, int vessel) {
    double value = 0;
    for (std::size_t v = 0; v < frame.off_rest.size(); ++v)
        if (vessel < 0 || vessel == static_cast<int>(v)) value = std::max(value, frame.off_rest[v]);
    return value;
}

template <typename Is>
double bites(const Trace& trace, Is is) {
    return static_cast<double>(std::count_if(trace.bites.begin(), trace.bites.end(), is));
}

double needle_way(const Trace& trace, const Condition& condition) {
    const auto tick = static_cast<std::size_t>(condition.from / trace.tick);
    return (trace.frames.back().needle_tip - trace.frames[std::min(tick, trace.frames.size() - 1)].needle_tip).norm();
}

// Of holes that the thread is in then and in the end.
double reordered(const Trace& trace, const Condition& condition) {
    const std::vector<Threaded>* then = nullptr;
    for (std::size_t i = 0; i < trace.frames.size() && !then; ++i)
        if (is_due(condition, static_cast<double>(i + 1) * trace.tick) && !trace.frames[i].threaded.empty())
            then = &trace.frames[i].threaded;
    if (!then) return 0;
    const auto place = [&](const Threaded& of) {
        return std::find_if(trace.threaded.begin(), trace.threaded.end(),
                            [&](const Threaded& now) { return now.vessel == of.vessel && now.hole == of.hole; });
    };
    double count = 0;
    for (std::size_t a = 0; a < then->size(); ++a)
        for (std::size_t b = a + 1; b < then->size(); ++b) {
            const auto at_a = place((*then)[a]), at_b = place((*then)[b]);
            count += at_a != trace.threaded.end() && at_b != trace.threaded.end() && at_b < at_a;
        }
    return count;
}

using S = const Scene&;
using T = const Trace&;
using C = const Condition&;
using tissue::Bite;
using tissue::BiteState;

}  // namespace

const std::vector<ConditionKind>& wall_kinds() {
    static const std::vector<ConditionKind> kinds{
        {"events", "count", "events of a drill of the kind named", [](S, T t, C c) { return events(t, c); }},
        {"tetrahedron_min", "share",
         "smallest tetrahedron of a wall, over its volume at rest; below 0 it is turned over",
         [](S, T t, C c) { return smallest_tetrahedron(t, c); }},
        {"wall_apart", "mm", "farthest node of a wall from where it is at rest",
         [](S, T t, C c) { return most(t, c, [&](const Frame& f) { return wall_apart(f, c.vessel); }) / mm; }},
        {"wall_contacts", "count", "nodes of walls that are behind a wall, every tenth tick",
         [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.wall_contacts; }); }},
        {"bites_open", "count", "bites through both skins in the end",
         [](S, T t, C) { return bites(t, [](const Bite& b) { return b.state == BiteState::open; }); }},
        {"bites_pricked", "count", "bites with the needle's tip in the wall in the end",
         [](S, T t, C) { return bites(t, [](const Bite& b) { return b.state == BiteState::pricked; }); }},
        {"bites_empty", "count", "bites that the needle left the way it came",
         [](S, T t, C) { return bites(t, [](const Bite& b) { return b.state == BiteState::empty; }); }},
        {"bites_partial", "count", "bites out of the skin that they went into",
         [](S, T t, C) { return bites(t, [](const Bite& b) { return b.partial(); }); }},
        {"bites_in_one_triangle", "count", "bites whose ends are in one triangle of the mesh",
         [](S, T t, C) {
             return bites(
                 t, [](const Bite& b) { return b.exit.hole >= 0 && b.entry.at.tetrahedron == b.exit.at.tetrahedron; });
         }},
        {"bites_on_needle", "count", "bites that the needle has not left in the end",
         [](S, T t, C) { return bites(t, [](const Bite& b) { return b.on_needle; }); }},
        {"holes_threaded", "count", "holes that the thread goes through in the end",
         [](S, T t, C) { return static_cast<double>(t.threaded.size()); }},
        {"holes_reordered", "count", "pairs of them that come in another order along the thread than from_s",
         [](S, T t, C c) { return reordered(t, c); }},
        {"thread_in_walls", "mm", "thread within walls in the end", [](S, T t, C) { return t.in_walls / mm; }},
        {"needle_moved", "mm", "the needle's tip in the end from where it was",
         [](S, T t, C c) { return needle_way(t, c) / mm; }},
        {"off_needle", "D", "the thread's first node from the needle's tail at any tick",
         [](S, T t, C c) { return most(t, c, [](const Frame& f) { return f.off_needle; }) / t.diameter; }},
    };
    return kinds;
}

}  // namespace bench::lab
