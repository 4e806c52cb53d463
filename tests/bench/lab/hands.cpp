#include "tests/bench/lab/hands.hpp"

#include <algorithm>

#include "sim/knot/namer.hpp"
#include "tests/bench/lab/gauge.hpp"

namespace bench::lab {

using sim::thread::Hold;

Hands::Hands(const Thread& thread) {
    grasp(thread, 0, 0);
    grasp(thread, 1, static_cast<int>(thread.nodes().size()) - 1);
}

void Hands::grasp(const Thread& thread, int hand, int node) {
    hands[static_cast<std::size_t>(hand)] = {node, thread.nodes()[static_cast<std::size_t>(node)]};
}

bool Hands::fit_links(Thread& thread) {
    std::array<int, 2> held{};
    std::size_t count = 0;
    for (const Hand& hand : hands)
        if (hand.node >= 0) held[count++] = hand.node;
    if (!thread.fit_links({held.data(), count})) return false;
    count = 0;
    for (Hand& hand : hands)
        if (hand.node >= 0) hand.node = held[count++];
    return true;
}

TickReport Hands::move(Thread& thread, const Vec3& by0, const Vec3& by1) {
    fit_links(thread);
    const std::array by{by0, by1};
    const Hold none{0, Vec3::Zero()};
    std::array holds{none, none};
    std::array<int, 2> owners{};
    std::size_t count = 0;
    for (std::size_t h = 0; h < 2; ++h) {
        if (hands[h].node < 0) continue;
        holds[count] = {hands[h].node, hands[h].at + by[h]};
        owners[count++] = static_cast<int>(h);
    }
    const TickReport report = thread.tick({{holds.data(), count}, {owners.data(), count}, {}, nullptr});
    for (Hand& hand : hands)
        if (hand.node >= 0) hand.at = thread.nodes()[static_cast<std::size_t>(hand.node)];
    return report;
}

Apart::Apart(const Thread& thread)
    : hands(thread), away((thread.nodes().back() - thread.nodes().front()).normalized()) {}

double tighten(Thread& thread, Apart& pull, double speed, int most_ticks,
               const std::function<void(const TickReport&)>& each) {
    constexpr int patience = 100;
    constexpr double tick = 1e-3, little = 0.01;
    double least = taken_up(thread), was = least;
    for (int i = 1; i <= most_ticks; ++i) {
        const TickReport report = pull.by(thread, speed * tick);
        if (each) each(report);
        const double now = taken_up(thread);
        least = std::min(least, now);
        if (i % patience != 0) continue;
        if (now > was - little) break;
        was = now;
    }
    return least;
}

double taken_up(const Thread& thread) {
    return Gauge(thread).kappa(thread.nodes());
}

std::string name_between(const Thread& thread, int first, int last) {
    std::vector<Vec3> curve(thread.nodes().begin() + first, thread.nodes().begin() + last + 1);
    const Vec3 out = 10 * Gauge(thread).length() * (curve.back() - curve.front()).normalized();
    curve.insert(curve.begin(), curve.front() - out);
    curve.push_back(curve.back() + out);
    const auto name = sim::knot::name_knot(curve);
    return name.certain ? name.knot : "";
}

}  // namespace bench::lab
