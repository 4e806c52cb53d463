#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/bench/drill_play.hpp"
#include "app/bench/trace.hpp"
#include "sim/geometry/triangle_tree.hpp"

namespace app::bench {

using sim::thread::Hold;
using sim::thread::MovingCapsule;
using sim::thread::Thread;

// Times in files are decimal and so is the tick: their quotient may miss a whole number by rounding alone.
constexpr double rounding = 1e-6;  // [ticks]

WayKey Way::at(double t) const {
    if (keys.empty()) return {};
    if (t <= keys.front().t) return keys.front();
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const WayKey &a = keys[i - 1], &b = keys[i];
        if (t > b.t) continue;
        const double share = (t - a.t) / (b.t - a.t);
        return {t, a.by + share * (b.by - a.by), a.turn + share * (b.turn - a.turn)};
    }
    return keys.back();
}

bool HoldPlan::held_at(double t) const {
    if (t < from || t > to) return false;
    return chatter_period == 0 || std::fmod(t + chatter_phase, chatter_period) < chatter_period / 2;
}

namespace {

Vec3 moved(const Vec3& p, const Vec3& pivot, const Way& way, const WayKey& from, const WayKey& to) {
    return pivot + to.by - from.by + Eigen::AngleAxisd(to.turn - from.turn, way.axis) * (p - pivot);
}

/// What one plan holds now, and from where.
struct Grasp {
    const HoldPlan* plan;
    bool holds = false;
    std::vector<Vec3> anchors;
    Vec3 pivot;
    WayKey since;

    void take(const Thread& thread, double t) {
        anchors.clear();
        for (const int node : plan->nodes) anchors.push_back(thread.nodes()[static_cast<std::size_t>(node)]);
        pivot = std::accumulate(anchors.begin(), anchors.end(), Vec3(Vec3::Zero())) / static_cast<double>(anchors.size());
        since = plan->way.at(t);
    }
};

/// Tools and held nodes of a scene, tick by tick.
struct Stage {
    const Scene& scene;
    std::vector<Grasp> grasps;
    std::vector<Capsule> tools;
    std::vector<Hold> holds;
    std::vector<int> owners;
    std::vector<MovingCapsule> capsules;

    explicit Stage(const Scene& of) : scene(of) {
        for (const HoldPlan& plan : scene.holds) grasps.push_back({&plan, false, {}, Vec3::Zero(), {}});
        for (const ToolPlan& plan : scene.tools) tools.push_back(plan.capsule);
    }

    void ask(const Thread& thread, double t) {
        holds.clear();
        owners.clear();
        capsules.clear();
        for (Grasp& grasp : grasps) ask(grasp, thread, t);
        for (std::size_t i = 0; i < tools.size(); ++i) {
            const ToolPlan& plan = scene.tools[i];
            const Vec3 pivot = (plan.capsule.a + plan.capsule.b) / 2;
            const WayKey now = plan.way.at(t);
            capsules.push_back({tools[i],
                                {moved(plan.capsule.a, pivot, plan.way, {}, now), moved(plan.capsule.b, pivot, plan.way, {}, now), plan.capsule.radius},
                                plan.tool});
        }
        for (const Fault& fault : scene.faults)
            if (fault.from <= t && t <= fault.to) spoil(fault);
    }

    void ask(Grasp& grasp, const Thread& thread, double t) {
        const HoldPlan& plan = *grasp.plan;
        const bool held = plan.held_at(t);
        if (held && !grasp.holds) grasp.take(thread, t - scene.tick);
        grasp.holds = held;
        for (std::size_t k = 0; held && k < plan.nodes.size(); ++k) {
            holds.push_back({plan.nodes[k], moved(grasp.anchors[k], grasp.pivot, plan.way, grasp.since, plan.way.at(t))});
            owners.push_back(plan.tool);
        }
    }

    void spoil(const Fault& fault) {
        const double bad = fault.kind == Fault::Kind::nan ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
        if (fault.input == "holds")
            for (Hold& hold : holds) hold.target.y() = bad;
        else
            for (MovingCapsule& c : capsules) c.to.b.z() = bad;
    }

    // A tool goes only as far as the thread let it; a tool whose input was not finite stays.
    void answer(const Thread& thread, const sim::thread::TickReport& report) {
        for (std::size_t i = 0; i < tools.size() && !report.not_finite; ++i) {
            const double share = thread.progress(capsules[i].owner);
            tools[i].a += share * (capsules[i].to.a - tools[i].a);
            tools[i].b += share * (capsules[i].to.b - tools[i].b);
        }
    }

    double lag(const Thread& thread) const {
        double most = 0;
        for (const Hold& hold : holds) {
            const double lag = (hold.target - thread.nodes()[static_cast<std::size_t>(hold.node)]).norm();
            if (std::isfinite(lag)) most = std::max(most, lag);
        }
        return most;
    }
};

Frame frame_of(const Thread& thread, const Stage& stage, const sim::thread::TickReport& report) {
    const auto tension = thread.tension();
    return {{thread.nodes().begin(), thread.nodes().end()},
            stage.tools,
            report,
            stage.lag(thread),
            *std::max_element(tension.begin(), tension.end()),
            tension.front(),
            tension.back()};
}

}  // namespace

Trace play(const Scene& scene) {
    if (!scene.drill.empty()) return play_drill(scene);
    const sim::geometry::TriangleTree surface(scene.surface);
    Thread thread(scene.thread, scene.nodes);
    Stage stage(scene);
    Trace trace{scene.tick, 2 * scene.thread.radius, scene.nodes, {thread.rest_lengths().begin(), thread.rest_lengths().end()}, {}, 0, 0};
    const int ticks = static_cast<int>(std::ceil(scene.duration / scene.tick - rounding));
    for (int tick = 1; tick <= ticks; ++tick) {
        stage.ask(thread, tick * scene.tick);
        const auto report = thread.tick({stage.holds, stage.owners, stage.capsules, scene.surface.empty() ? nullptr : &surface, scene.tick});
        stage.answer(thread, report);
        trace.frames.push_back(frame_of(thread, stage, report));
    }
    trace.hash = thread.hash();
    return trace;
}

}  // namespace app::bench
