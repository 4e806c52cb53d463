#include <algorithm>

#include "tests/bench/lab/trace.hpp"

// Conditions on the energy of an elastic thread that swings, by its motion and its bends alone: what stretch holds of
// it is next to nothing where nobody pulls.
namespace bench::lab {

namespace {

/// As half the mass is of the nodes at either end of a link, and half the bend's length that of the links beside it.
double energy(const Scene& scene, const Trace& trace, std::size_t frame) {
    if (!scene.thread.elastic) return 0;
    sim::thread::RodDef def = *scene.thread.elastic;
    def.radius = scene.thread.radius;
    const std::vector<Vec3>&was = frame == 0 ? trace.start : trace.frames[frame - 1].nodes,
          &now = trace.frames[frame].nodes;
    const auto along = [&](std::size_t k) { return Vec3((now[k + 1] - now[k]).normalized()); };
    double sum = 0;
    for (std::size_t k = 0; k < trace.rest.size(); ++k) {
        const double moved2 = 0.5 * ((now[k] - was[k]).squaredNorm() + (now[k + 1] - was[k + 1]).squaredNorm());
        sum += 0.5 * def.mass_per_length() * trace.rest[k] * moved2 / (trace.tick * trace.tick);
        if (k > 0)
            sum +=
                def.bending_stiffness() / (trace.rest[k - 1] + trace.rest[k]) * (along(k) - along(k - 1)).squaredNorm();
    }
    return sum;
}

/// Of every tick within the condition's time, from its first.
std::vector<double> energies(const Scene& scene, const Trace& trace, const Condition& condition) {
    std::vector<double> all;
    for (std::size_t i = 0; i < trace.frames.size(); ++i) {
        const double t = static_cast<double>(i + 1) * trace.tick;
        if (t >= condition.from && t <= condition.to) all.push_back(energy(scene, trace, i));
    }
    return all;
}

double of_first(double energy, const std::vector<double>& energies) {
    return energies.empty() || energies.front() == 0 ? 0 : energy / energies.front();
}

double rise(const std::vector<double>& energies) {
    double most = 0;
    for (std::size_t i = 1; i < energies.size(); ++i) most = std::max(most, energies[i] - energies[i - 1]);
    return of_first(most, energies);
}

double left(const std::vector<double>& energies) {
    return energies.empty() ? 0 : of_first(energies.back(), energies);
}

using S = const Scene&;
using T = const Trace&;
using C = const Condition&;

}  // namespace

const std::vector<ConditionKind>& energy_kinds() {
    static const std::vector<ConditionKind> kinds{
        {"energy_rise", "share", "most that motion and bends gain from tick to tick, of what they had at from_s",
         [](S s, T t, C c) { return rise(energies(s, t, c)); }},
        {"energy_left", "share", "what is left of it in the end",
         [](S s, T t, C c) { return left(energies(s, t, c)); }},
    };
    return kinds;
}

}  // namespace bench::lab
