#include "app/bench/accuracy.hpp"

#include <cmath>

#include "app/bench/core.hpp"
#include "app/bench/rod_cases.hpp"
#include "sim/thread/rod.hpp"

namespace app::bench {

namespace {

using sim::thread::Rod;
using sim::thread::RodDef;
using sim::thread::Vec3;

void add_case(Suite& suite, const RodCase& c, const std::vector<int>& resolutions) {
    double coarser = 0, order = 0;
    for (const int links : resolutions) {
        const double begin = processor_time(), error = 100 * c.at(links).error(), seconds = processor_time() - begin;
        Row row{.id = c.id + "-n" + std::to_string(links), .what = c.what + ", " + std::to_string(links) + " links: error", .value = std::abs(error),
                .unit = "%", .bound = {}, .error = {}, .seconds = seconds};
        if (links >= c.bound_links) row.bound = 100 * c.bound;
        suite.rows.push_back(row);
        order = std::log2(coarser / std::abs(error));
        coarser = std::abs(error);
    }
    suite.rows.push_back({.id = c.id + "-order", .what = c.what + ": order of the last halving of links", .value = order, .unit = "order", .bound = {}, .error = {}});
}

// A rod bent and twisted in space between two clamps.
std::vector<Vec3> shape(double scale, bool mirrored) {
    constexpr int links = 60;
    constexpr double turn = 3;
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.push_back(scale * Vec3(i / 60.0, 0, 0));
    const double r = 1e-3 * scale;
    Rod rod({.radius = r, .young = 1, .poisson = 0.3, .density = 0}, nodes);
    const double z = mirrored ? -1 : 1;
    const Vec3 end = scale * Vec3(0.6, 0.2, 0.3 * z), along = scale / 60 * Vec3(0.6, 0, 0.8 * z);
    const Vec3 first = nodes[0], second = nodes[1];
    constexpr int steps = 20;
    for (int s = 1; s <= steps; ++s) {
        const double u = static_cast<double>(s) / steps;
        const Vec3 last = nodes.back() + u * (end - nodes.back()), before = last - scale / 60 * ((1 - u) * Vec3(1, 0, 0) + u * along / along.norm()).normalized();
        const sim::thread::Hold holds[] = {{0, first}, {1, second}, {links - 1, before}, {links, last}};
        for (int i = 0; i < 10 && !rod.step({.holds = holds, .turn = u * turn * z}, 0).settled; ++i) {}
    }
    std::vector<Vec3> found;
    for (const Vec3& p : rod.nodes()) found.push_back(Vec3(p.x(), p.y(), z * p.z()) / scale);
    return found;
}

double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

void add_laws(Suite& suite) {
    const auto add = [&](const char* id, const char* what, double value, double bound) {
        suite.rows.push_back({.id = id, .what = what, .value = value, .unit = "L", .bound = bound, .error = {}});
    };
    const auto plain = shape(1, false);
    add("mirrored-apart", "bent and twisted rod and its mirror image: apart", apart(plain, shape(1, true)), 1e-6);
    add("scaled-1024-apart", "the same 1024 times as large: apart", apart(plain, shape(1024, false)), 1e-6);
    add("scaled-1e-3-apart", "a thousandth as large: apart", apart(plain, shape(1e-3, false)), 1e-6);
}

}  // namespace

Suite accuracy_suite(bool quick, const Progress& progress) {
    Suite suite{"accuracy", {}};
    const std::vector<int> resolutions = quick ? std::vector{20, 40} : std::vector{20, 40, 80, 160};
    for (const RodCase& c : rod_cases()) {
        if (progress) progress(c.what);
        add_case(suite, c, resolutions);
    }
    add_laws(suite);
    return suite;
}

}  // namespace app::bench
