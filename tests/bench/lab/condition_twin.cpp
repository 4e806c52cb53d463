#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/knot/namer.hpp"
#include "tests/bench/lab/trace.hpp"

// Conditions that play the scene again, and again in a world that is the same seen otherwise.
namespace bench::lab {

namespace {

using Eigen::Matrix3d;

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

// Bits, so that -0 is not 0 and what is not a number is not lost.
bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

double mapped_apart(const Scene& scene, const Trace& trace, const Matrix3d& linear) {
    const double scale = linear.col(0).norm();
    std::vector<Vec3> expected = trace.nodes();
    for (Vec3& p : expected) p = linear * p;
    return farthest(expected, play(mapped(scene, linear)).nodes()) / (scale * trace.diameter);
}

Matrix3d quarter_turn() {
    return (Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
}
Matrix3d mirror() {
    return Eigen::Vector3d(1, 1, -1).asDiagonal();
}

double reversed_apart(const Scene& scene, const Trace& trace) {
    const std::vector<Vec3> expected(trace.nodes().rbegin(), trace.nodes().rend());
    return farthest(expected, play(reversed(scene)).nodes()) / trace.diameter;
}

double ticked_apart(Scene scene, const Trace& trace, double factor) {
    scene.tick *= factor;
    return farthest(play(scene).nodes(), trace.nodes()) / trace.diameter;
}

std::string knot_after_nudge(Scene scene, double towards) {
    for (Vec3& p : scene.nodes)
        for (int c = 0; c < 3; ++c) p[c] = std::nextafter(p[c], towards);
    return sim::knot::name_knot(play(scene).nodes()).knot;
}

double nudged_knot_differs(const Scene& scene, const Trace& trace) {
    const std::string knot = sim::knot::name_knot(trace.nodes()).knot;
    return (knot_after_nudge(scene, 1) != knot) + (knot_after_nudge(scene, -1) != knot);
}

Trace without_faults(Scene scene) {
    scene.faults.clear();
    return play(scene);
}

Way mapped(Way way, const Matrix3d& linear, double scale) {
    for (WayKey& key : way.keys) key.by = linear * key.by;
    // A turn seen in a mirror goes the other way round.
    way.axis = (linear.determinant() < 0 ? -1 : 1) / scale * (linear * way.axis);
    return way;
}

using S = const Scene&;
using T = const Trace&;
using C = const Condition&;

}  // namespace

Scene mapped(const Scene& scene, const Matrix3d& linear) {
    const double scale = linear.col(0).norm();
    const auto map = [&](const Vec3& p) { return Vec3(linear * p); };
    Scene image = scene;
    image.thread.radius *= scale;
    for (CutPlan& cut : image.cuts) cut.place *= scale;
    for (Vec3& p : image.nodes) p = map(p);
    for (HoldPlan& hold : image.holds) hold.way = mapped(hold.way, linear, scale);
    for (ToolPlan& tool : image.tools) {
        tool.capsule = {map(tool.capsule.a), map(tool.capsule.b), scale * tool.capsule.radius};
        tool.way = mapped(tool.way, linear, scale);
    }
    for (auto& t : image.surface) t = {map(t.a), map(t.b), map(t.c)};
    if (linear.determinant() < 0)
        for (auto& t : image.surface) std::swap(t.b, t.c);
    return image;
}

Scene reversed(Scene scene) {
    double length = 0;
    for (std::size_t i = 1; i < scene.nodes.size(); ++i) length += (scene.nodes[i] - scene.nodes[i - 1]).norm();
    for (CutPlan& cut : scene.cuts) cut.place = length - cut.place;
    std::reverse(scene.cuts.begin(), scene.cuts.end());
    std::reverse(scene.nodes.begin(), scene.nodes.end());
    for (HoldPlan& hold : scene.holds)
        for (int& node : hold.nodes) node = static_cast<int>(scene.nodes.size()) - 1 - node;
    return scene;
}

const std::vector<ConditionKind>& twin_kinds() {
    static const std::vector<ConditionKind> kinds{
        {"hash_differs", "count", "1 where the same input gave other bits",
         [](S s, T t, C) { return play(s).hash == t.hash ? 0.0 : 1.0; }},
        {"mirrored_apart", "D", "farthest node from where the mirrored scene has it",
         [](S s, T t, C) { return mapped_apart(s, t, mirror()); }},
        {"turned_apart", "D", "farthest node from where the scene turned by a quarter has it",
         [](S s, T t, C) { return mapped_apart(s, t, quarter_turn()); }},
        {"scaled_apart", "D", "farthest node from where the scene so many times as large has it",
         [](S s, T t, C c) { return mapped_apart(s, t, c.factor * Matrix3d::Identity()); }},
        {"reversed_apart", "D", "farthest node from where the scene numbered from the other end has it",
         [](S s, T t, C) { return reversed_apart(s, t); }},
        {"ticked_apart", "D", "farthest node from where ticks so many times as long have it",
         [](S s, T t, C c) { return ticked_apart(s, t, c.factor); }},
        {"nudged_knot_differs", "count", "of two starts moved by the last bit, those that end in another knot",
         [](S s, T t, C) { return nudged_knot_differs(s, t); }},
        {"unbroken_differs", "count", "1 where the scene without its faults ends in other bits",
         [](S s, T t, C) { return same_bits(without_faults(s).nodes(), t.nodes()) ? 0.0 : 1.0; }},
        {"unbroken_apart", "D", "farthest node from where the scene without its faults has it",
         [](S s, T t, C) { return farthest(without_faults(s).nodes(), t.nodes()) / t.diameter; }},
    };
    return kinds;
}

}  // namespace bench::lab
