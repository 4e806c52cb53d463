#include "tests/bench/lab/hitches.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sim/geometry/resample.hpp"
#include "sim/knot/namer.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/curves.hpp"

namespace bench::lab {

namespace {

using sim::geometry::Vec3;
using sim::thread::Thread;

// In the units of the curve.
struct Bar {
    Vec3 at, along;
    double radius, thread_radius;
};

struct BarScene {
    const char *curve, *name;
    bool by_both_ends;
};
constexpr BarScene scenes[] = {{"p129", "bowline", false},    {"p135", "clove hitch", true},
                               {"p136", "constrictor", true}, {"p137", "cow hitch", true},
                               {"p138", "prusik", true},      {"p139", "prusik", true}};

// Hitches are drawn round a pole of radius 1 whose middle is at the origin; the bowline has none, so one is put through
// its eye.
Bar bar_of(const LabelledCurve& curve) {
    if (curve.components.size() == 1) return {{-5, -1.75, 0.5}, Vec3(0, 0.54, 0.84).normalized(), 0.5, 0.07};
    const auto& pole = curve.components[1].vertices;
    return {Vec3::Zero(), (pole[2] - pole[1]).normalized(), 1, 0.085};
}

struct BarPlay {
    BarPlay(const LabelledCurve& curve, const BarScene& the_scene)
        : scene(the_scene), bar(bar_of(curve)), scale(def.radius / bar.thread_radius), thread(def, nodes(curve)) {
        const int last = static_cast<int>(thread.nodes().size()) - 1;
        hold(0, 1);
        if (scene.by_both_ends) hold(last, last - 1);
    }

    void hold(int end, int before) {
        const auto p = thread.nodes();
        held.push_back(end);
        ways.push_back((p[static_cast<std::size_t>(end)] - p[static_cast<std::size_t>(before)]).normalized());
    }

    std::vector<Vec3> nodes(const LabelledCurve& curve) const {
        std::vector<Vec3> path;
        double length = 0;
        for (const Vec3& p : curve.components[0].vertices) {
            if (!path.empty()) length += (scale * p - path.back()).norm();
            path.push_back(scale * p);
        }
        return sim::geometry::resample(path, static_cast<int>(length / (2 * def.radius)));
    }

    // What the ends came out by [m].
    double move(double step) {
        const Vec3 middle = scale * bar.at, half = 1000 * scale * bar.along;
        const sim::geometry::Capsule steel{middle - half, middle + half, scale * bar.radius};
        const sim::thread::MovingCapsule capsules[] = {{steel, steel, 0}};
        std::vector<sim::thread::Hold> holds;
        std::vector<int> owners;
        std::vector<Vec3> before;
        for (std::size_t i = 0; i < held.size(); ++i) {
            before.push_back(thread.nodes()[static_cast<std::size_t>(held[i])]);
            holds.push_back({held[i], before.back() + step * ways[i]});
            owners.push_back(static_cast<int>(i) + 1);
        }
        tied.pass_throughs += thread.tick({holds, owners, capsules, nullptr}).pass_throughs;
        double out = 0;
        for (std::size_t i = 0; i < held.size(); ++i)
            out += (thread.nodes()[static_cast<std::size_t>(held[i])] - before[i]).dot(ways[i]);
        return out;
    }

    void name() {
        const Vec3 middle = scale * bar.at, half = 100 * scale * bar.along;
        const auto now = sim::knot::name_among({thread.nodes().begin(), thread.nodes().end()},
                                               {{middle - half, middle, middle + half}});
        ++tied.names;
        tied.last = now.name.surgical;
        tied.other += tied.last != tied.expected;
    }

    // Until a hundred ticks bring less than a fiftieth of the thread's thickness.
    OnBar until_tight() {
        constexpr int patience = 100, period = 20, most_ticks = 3000;
        constexpr double step = 0.02e-3;  // [m] a tick of 1 ms
        tied.curve = scene.curve, tied.expected = scene.name;
        double lately = 0, all = 0;
        for (int i = 0; i < most_ticks; ++i) {
            if (i % period == 0) name();
            const double out = move(step);
            lately += out, all += out;
            if ((i + 1) % patience == 0 && std::exchange(lately, 0) < 0.04 * def.radius) break;
        }
        tied.drawn_out = all / (2 * def.radius);
        return tied;
    }

    BarScene scene;
    sim::thread::ThreadDef def;
    Bar bar;
    double scale;
    Thread thread;
    std::vector<int> held;
    std::vector<Vec3> ways;
    OnBar tied;
};

}  // namespace

std::vector<std::string> curves_on_bar() {
    std::vector<std::string> all;
    for (const BarScene& scene : scenes) all.emplace_back(scene.curve);
    return all;
}

OnBar hitch_on_bar(const std::filesystem::path& folder, const std::string& curve) {
    const auto* scene =
        std::find_if(std::begin(scenes), std::end(scenes), [&](const BarScene& s) { return s.curve == curve; });
    return BarPlay(labelled_curves(folder, curve).front(), *scene).until_tight();
}

}  // namespace bench::lab
