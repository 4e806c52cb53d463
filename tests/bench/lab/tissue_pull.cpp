#include "tests/bench/lab/tissue_pull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/tissue_cases.hpp"

namespace bench::lab {

namespace {

using tissue::Tissue;
using tissue::TubeDef;
using tissue::Vec3;

constexpr double reach = 1e-3;  // of the bite each way from its middle, which is as far from the cut [m]

double window(double from_middle) {
    if (std::abs(from_middle) >= reach) return 0;
    const double cosine = std::cos(0.5 * std::numbers::pi * from_middle / reach);
    return cosine * cosine;
}

}  // namespace

TubeDef vessel(double finer) {
    const TubeDef def;
    const auto times = [&](int count) { return std::max(1, static_cast<int>(std::lround(finer * count))); };
    return {.around = times(def.around), .through = times(def.through), .near = times(def.near), .far = times(def.far)};
}

VesselPull::VesselPull(const TubeDef& def, bool locks) : mesh(make_tube(def)), edge(def.through) {
    const int nodes = static_cast<int>(mesh.nodes.size()), section = def.around * (def.through + 1);
    behind = edge + section * static_cast<int>(std::lround(2 * reach / def.near_length * def.near));
    for (int i = nodes - section; i < nodes; ++i) holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
    double sum = 0;
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t) {
        const tissue::Tetrahedron& tet = mesh.tetrahedra[static_cast<std::size_t>(t)];
        Vec3 middle = Vec3::Zero();
        for (const int i : tet) middle += 0.25 * mesh.nodes[static_cast<std::size_t>(i)];
        const double share =
            middle.y() > 0 ? window(middle.x() - reach) * window(middle.z()) * tissue::volume(tet, mesh.nodes) : 0;
        if (share == 0) continue;
        points.push_back({t, {0.25, 0.25, 0.25, 0.25}});
        shares.push_back(share);
        sum += share;
    }
    for (double& share : shares) share /= sum;
    if (locks) mesh = with_own_volumes(mesh);
}

std::vector<tissue::PointForce> VesselPull::forces(const Vec3& force) const {
    std::vector<tissue::PointForce> found;
    for (std::size_t i = 0; i < points.size(); ++i) found.push_back({points[i], shares[i] * force});
    return found;
}

Vec3 VesselPull::pull_at(double seconds) {
    constexpr double turns = 0.4, lets_go = 0.7, ramp = 0.1;
    const Vec3 along(-1, 0, 0), aside(0, 0.6, 0.8);
    const auto share = [&](double since) { return std::clamp((seconds - since) / ramp, 0.0, 1.0); };
    return (share(0) - share(turns)) * along + (share(turns) - share(lets_go)) * aside;
}

PulledVessel pulled(const VesselPull& pull, double force) {
    Tissue tissue({}, pull.mesh, {.iterations = 50, .steps_per_factor = 0, .tolerance = 1e-7 * force});
    constexpr int steps = 10;
    for (int s = 1; s <= steps; ++s)
        tissue.step({.holds = pull.holds, .forces = pull.forces(s * force / steps * VesselPull::pull_at(0.2))},
                    std::numeric_limits<double>::infinity());
    const auto edge = static_cast<std::size_t>(pull.edge), behind = static_cast<std::size_t>(pull.behind);
    const auto nodes = tissue.nodes();
    return {nodes[edge] - pull.mesh.nodes[edge],
            (nodes[edge] - nodes[behind]).norm() - (pull.mesh.nodes[edge] - pull.mesh.nodes[behind]).norm()};
}

Played play(const VesselPull& pull, const tissue::Solver& solver, double force, double seconds) {
    Tissue tissue({}, pull.mesh, solver);
    Played played;
    const int steps = ticks_in(1, seconds);
    for (int s = 1; s <= steps; ++s) {
        const auto forces = pull.forces(force * VesselPull::pull_at(s * seconds));
        const double begin = processor_time();
        const auto report = tissue.step({.holds = pull.holds, .forces = forces}, seconds);
        played.us.push_back(1e6 * (processor_time() - begin));
        played.edge.push_back(tissue.nodes()[static_cast<std::size_t>(pull.edge)]);
        played.iterations += static_cast<double>(report.iterations) / steps;
    }
    played.us.erase(played.us.begin());  // the first step factors at once
    return played;
}

double stiff_step(int count) {
    const VesselPull pull(vessel());
    Tissue tissue({}, pull.mesh);
    std::vector<tissue::PointForce> forces;
    for (int i = 0; i < count; ++i)
        forces.push_back(
            {{i * static_cast<int>(pull.mesh.tetrahedra.size()) / std::max(1, count), {0.25, 0.25, 0.25, 0.25}},
             Vec3::Zero(),
             1000});
    tissue.step({.holds = pull.holds, .forces = forces}, 2e-3);
    constexpr int steps = 400;
    const double begin = processor_time();
    for (int i = 0; i < steps; ++i) tissue.step({.holds = pull.holds, .forces = forces}, 2e-3);
    return 1e6 * (processor_time() - begin) / steps;
}

Lag apart(const Played& a, const Played& b) {
    double way = 0, most = 0, squares = 0;
    for (std::size_t i = 0; i < a.edge.size(); ++i) {
        const double far = (a.edge[i] - b.edge[i]).norm();
        way = std::max(way, (b.edge[i] - b.edge.back()).norm());
        most = std::max(most, far);
        squares += far * far;
    }
    return {most / way, std::sqrt(squares / static_cast<double>(a.edge.size())) / way};
}

}  // namespace bench::lab
