#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "tests/bench/lab/drill_play.hpp"
#include "tests/bench/lab/trace.hpp"

namespace bench::lab {

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
    std::vector<int> nodes;  ///< By their numbers now; -1: no more.
    bool holds = false;
    std::vector<Vec3> anchors;
    Vec3 pivot;
    WayKey since;

    void take(const Thread& thread, double t) {
        anchors.clear();
        for (const int node : nodes) anchors.push_back(thread.nodes()[static_cast<std::size_t>(std::max(node, 0))]);
        pivot =
            std::accumulate(anchors.begin(), anchors.end(), Vec3(Vec3::Zero())) / static_cast<double>(anchors.size());
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
        for (const HoldPlan& plan : scene.holds) grasps.push_back({&plan, plan.nodes, false, {}, Vec3::Zero(), {}});
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
                                {moved(plan.capsule.a, pivot, plan.way, {}, now),
                                 moved(plan.capsule.b, pivot, plan.way, {}, now), plan.capsule.radius},
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
        for (std::size_t k = 0; held && k < grasp.nodes.size(); ++k) {
            if (grasp.nodes[k] < 0) continue;
            holds.push_back(
                {grasp.nodes[k], moved(grasp.anchors[k], grasp.pivot, plan.way, grasp.since, plan.way.at(t))});
            owners.push_back(plan.tool);
        }
    }

    bool cut(Thread& thread, int link, double share) {
        std::vector<int> held;
        for (const Grasp& grasp : grasps) held.insert(held.end(), grasp.nodes.begin(), grasp.nodes.end());
        if (!thread.cut(link, share, held)) return false;
        auto next = held.begin();
        for (Grasp& grasp : grasps)
            for (int& node : grasp.nodes) node = *next++;
        return true;
    }

    void cut_before(Thread& thread, double t) {
        for (const CutPlan& plan : scene.cuts) {
            if (std::abs(t - plan.t) > scene.tick / 2) continue;
            double place = plan.place;
            int link = 0;
            for (; link + 1 < static_cast<int>(thread.rest_lengths().size()) && place > rest(thread, link); ++link)
                place -= rest(thread, link);
            cut(thread, link, std::min(1.0, place / rest(thread, link)));
        }
    }

    static double rest(const Thread& thread, int link) { return thread.rest_lengths()[static_cast<std::size_t>(link)]; }

    void spoil(const Fault& fault) {
        const double bad = fault.kind == Fault::Kind::nan ? std::numeric_limits<double>::quiet_NaN()
                                                          : std::numeric_limits<double>::infinity();
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

std::vector<int> cuts_of(const Thread& thread) {
    std::vector<int> cuts;
    for (const auto& piece : thread.pieces()) cuts.push_back(piece.last);
    cuts.pop_back();  // the thread's own end
    return cuts;
}

Frame frame_of(const Thread& thread, const Stage& stage, const sim::thread::TickReport& report) {
    const auto tension = thread.tension();
    return {{thread.nodes().begin(), thread.nodes().end()},    stage.tools,     report,         stage.lag(thread),
            *std::max_element(tension.begin(), tension.end()), tension.front(), tension.back(), cuts_of(thread)};
}

double length_before(const Thread& thread, int node) {
    return std::accumulate(thread.rest_lengths().begin(), thread.rest_lengths().begin() + node, 0.0);
}

// From the nearest link that touches another strand: one within 1.2 thicknesses of it, and farther off than 5 along the
// thread.
double off_touching(const Thread& thread, int link) {
    const double thickness = 2 * thread.def().radius, place = length_before(thread, link);
    const auto nodes = thread.nodes();
    double least = length_before(thread, static_cast<int>(nodes.size()) - 1);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        for (std::size_t j = i + 1; j + 1 < nodes.size(); ++j) {
            const double at_i = length_before(thread, static_cast<int>(i)),
                         at_j = length_before(thread, static_cast<int>(j));
            if (at_j - at_i < 5 * thickness) continue;
            const double d2 =
                sim::geometry::closest_points(nodes[i], nodes[i + 1], nodes[j], nodes[j + 1]).distance_squared;
            if (d2 < 1.44 * thickness * thickness)
                least = std::min({least, std::abs(at_i - place), std::abs(at_j - place)});
        }
    return least;
}

}  // namespace

Trace play(const Scene& scene) {
    if (!scene.drill.empty()) return play_drill(scene);
    const sim::geometry::TriangleTree surface(scene.surface);
    Thread thread(scene.thread, scene.nodes);
    Stage stage(scene);
    Trace trace{scene.tick,
                2 * scene.thread.radius,
                scene.nodes,
                {thread.rest_lengths().begin(), thread.rest_lengths().end()},
                {},
                0,
                0};
    const int ticks = static_cast<int>(std::ceil(scene.duration / scene.tick - rounding));
    sim::thread::Strength strength{scene.break_force};
    for (int tick = 1; tick <= ticks; ++tick) {
        stage.cut_before(thread, tick * scene.tick);
        stage.ask(thread, tick * scene.tick);
        const auto report = thread.tick(
            {stage.holds, stage.owners, stage.capsules, scene.surface.empty() ? nullptr : &surface, scene.tick});
        stage.answer(thread, report);
        trace.frames.push_back(frame_of(thread, stage, report));
        if (!strength.gives_way(trace.frames.back().tension, scene.tick, scene.thread.elastic.has_value())) continue;
        const int link = thread.most_loaded();
        const double off = off_touching(thread, link);
        if (!stage.cut(thread, link, 0.5)) continue;
        ++trace.breaks;
        trace.broke_off = off;
    }
    trace.hash = thread.hash();
    const auto nodes = thread.nodes();
    for (const auto& [first, last] : thread.pieces())
        trace.pieces.emplace_back(nodes.begin() + first, nodes.begin() + last + 1);
    trace.lost = std::accumulate(trace.rest.begin(), trace.rest.end(), 0.0) -
                 length_before(thread, static_cast<int>(nodes.size()) - 1);
    return trace;
}

}  // namespace bench::lab
