#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "scenarios/world/event.hpp"
#include "tests/bench/lab/hard_case.hpp"
#include "tissue/bite.hpp"

namespace bench::lab {

/// A hole in a wall, and where along the thread it is.
struct Threaded {
    int vessel, hole;
    double along;  ///< [m]
};

/// The scene after one tick.
struct Frame {
    std::vector<Vec3> nodes;     ///< [m]
    std::vector<Capsule> tools;  ///< Where the thread let them come to, in order of Scene::tools.
    sim::thread::TickReport report;
    double lag = 0;                                           ///< Of the held node that is farthest behind [m].
    double tension = 0, tension_first = 0, tension_last = 0;  ///< Most, of the first and of the last link [N].
    std::vector<int> cuts = {};                               ///< Links that are no more.

    // Of walls that give way, in a drill:
    double smallest_tetrahedron = 1;      ///< Over its volume at rest.
    std::vector<double> off_rest = {};    ///< Of each vessel's node that is farthest from there [m].
    Vec3 needle_tip = Vec3::Zero();       ///< [m]
    double off_needle = 0;                ///< The thread's first node from the needle's tail [m].
    int wall_contacts = 0;                ///< Every tenth tick ...
    std::vector<Threaded> threaded = {};  ///< ... as this, in order along the thread.
};

/// All that was seen of one scene.
struct Trace {
    double tick = 0, diameter = 0;  ///< [s], [m]
    std::vector<Vec3> start;
    std::vector<double> rest;   ///< [m]
    std::vector<Frame> frames;  ///< One a tick.
    std::uint64_t hash = 0;     ///< In the end.
    int inputs_dropped = 0;     ///< Events of a drill.
    int breaks = 0;
    double broke_off = 0;  ///< How far along the thread from where strands touch it broke, the last time [m].
    std::vector<std::vector<Vec3>> pieces = {};        ///< In the end.
    double lost = 0;                                   ///< Of its length, by cuts and breaks [m].
    std::vector<scenarios::world::Event> events = {};  ///< Of a drill.
    std::vector<tissue::Bite> bites = {};              ///< Of all its vessels in the end.
    std::vector<Threaded> threaded = {};               ///< In the end.
    double in_walls = 0;                               ///< Of the thread in the end [m].

    const std::vector<Vec3>& nodes() const { return frames.back().nodes; }
};

/// Plays a scene.
Trace play(const Scene& scene);

/// The same scene in a world mapped by `linear` (a scale times a rotation or reflection).
Scene mapped(const Scene& scene, const Eigen::Matrix3d& linear);
/// The same scene with its nodes numbered from the other end.
Scene reversed(Scene scene);

/// One kind of condition.
struct ConditionKind {
    const char* name;
    const char* unit;
    const char* words;
    double (*measure)(const Scene& scene, const Trace& trace, const Condition& condition);
};
const std::vector<ConditionKind>& condition_kinds();
const ConditionKind& condition_kind(const std::string& name);

/// Those that play the scene again in another way.
const std::vector<ConditionKind>& twin_kinds();
/// Those that look at the energy of an elastic thread.
const std::vector<ConditionKind>& energy_kinds();
/// Those that look at walls that give way, and at needles in them.
const std::vector<ConditionKind>& wall_kinds();
/// Those that look at the shape of the thread and at what it touches.
const std::vector<ConditionKind>& shape_kinds();

/// The most of what a frame says, within the condition's time; 0 where nothing is above.
template <typename Figure>
double most(const Trace& trace, const Condition& condition, Figure figure) {
    double value = 0;
    for (std::size_t i = 0; i < trace.frames.size(); ++i) {
        const double t = static_cast<double>(i + 1) * trace.tick;
        if (t >= condition.from && t <= condition.to)
            value = std::max(value, static_cast<double>(figure(trace.frames[i])));
    }
    return value;
}

}  // namespace bench::lab
