#include "tests/bench/lab/loose_overhand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/resample.hpp"
#include "sim/thread/thread.hpp"

namespace bench::lab {

namespace {

using sim::thread::Hold;
using sim::thread::Thread;
using sim::thread::Vec3;

using std::numbers::pi;

constexpr double loose_radius = 0.5e-3;  // [m]
constexpr double first_loop = 1.1,
                 loose_tail = 6;  // of R: the loop to begin with, and of that how far it is to either end
constexpr double within = 0.02;   // of what it takes up in the end: where it is measured

// A circle that rests on the x axis with its strands twisted about each other there, as far to either side as leaves
// them apart and turns no link by more than a radian: strands that overlapped would be pushed through each other.
std::vector<Vec3> start_shape(const LooseOverhand& knot) {
    const double loop = first_loop * knot.loop * loose_radius, link = 2 * pi * knot.loop * loose_radius / knot.links,
                 twist = knot.half_turns * pi;
    const double clear = (knot.half_turns > 3 ? 2.2 : 2.1) * loose_radius,
                 span = std::max(std::sqrt(2 * loop * clear), 0.5 * twist * link);
    const double lift = loop - std::sqrt(loop * loop - span * span), lifted = std::asin(span / loop);
    constexpr int fine = 4000;
    std::vector<Vec3> path{{-loose_tail * loop, 0, 0}};
    const auto twisted = [&](double from) {
        for (int i = 0; i <= fine; ++i) {
            const double u = static_cast<double>(i) / fine, angle = from + u * twist;
            path.emplace_back((2 * u - 1) * span, 0.5 * lift * (1 + std::sin(angle)), 0.5 * lift * std::cos(angle));
        }
    };
    twisted(-pi / 2);
    for (int i = 1; i < fine; ++i) {
        const double angle = lifted + i * (2 * pi - 2 * lifted) / fine;
        path.emplace_back(loop * std::sin(angle), loop * (1 - std::cos(angle)), 0);
    }
    twisted(pi / 2);
    path.emplace_back(loose_tail * loop, 0, 0);
    return path;
}

// So heavy that its own bending moves a loop by about the thread's radius in a millisecond: strands do not leap off
// each other's corners.
sim::thread::RodDef material(double loop) {
    constexpr double tick = 1e-3;
    sim::thread::RodDef def{.radius = loose_radius, .young = 1e9, .density = 1};
    def.density = def.bending_stiffness() * tick * tick / (loose_radius * loop * loop * loop) / def.mass_per_length();
    return def;
}

Thread thread_of(const LooseOverhand& knot) {
    const double loop = knot.loop * loose_radius;
    const auto path = start_shape(knot);
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
    const int links = static_cast<int>(std::lround(length / (2 * pi * loop) * knot.links));
    sim::thread::ThreadDef def{.radius = loose_radius,
                               .friction = knot.friction,
                               .axial_stiffness = material(loop).axial_stiffness(length / links)};
    if (knot.elastic) def.elastic = material(loop);
    return {def, sim::geometry::resample(path, links)};
}

class LoopDrawing {
  public:
    LoopDrawing(const LooseOverhand& knot, Cost& cost)
        : loop_(knot.loop * loose_radius),
          tick_(knot.tick),
          cost_(cost),
          thread_(thread_of(knot)),
          last_(static_cast<int>(thread_.nodes().size()) - 1),
          was_(middle()) {
        for (const double link : thread_.rest_lengths()) length_ += link;
        cost_.links = last_;
    }

    double mean_pull() {
        constexpr double rest = 0.3, longest = 8;  // [s]; it takes 1.6, or twice that where links are coarse
        const double ring = 2 * pi * loop_, speed = 0.25 * loop_;
        double pulls = 0;
        int count = 0;
        for (int i = ticks_in(rest, tick_); i > 0; --i) move(0);
        for (int i = ticks_in(longest, tick_); i > 0 && taken_up() > (1 - within) * ring; --i) {
            move(speed * tick_);
            if (std::abs(taken_up() / ring - 1) < within) pulls += pull(), ++count;
        }
        return pulls / count * loose_radius * loose_radius / bending_stiffness();
    }

  private:
    double middle() const { return thread_.nodes()[static_cast<std::size_t>(last_ / 2)].x(); }
    double taken_up() const { return length_ - (thread_.nodes().back() - thread_.nodes().front()).norm(); }
    double pull() const {
        return 0.5 * (thread_.tension()[1] + thread_.tension()[static_cast<std::size_t>(last_ - 2)]);
    }
    double bending_stiffness() const { return material(loop_).bending_stiffness(); }

    // Either end by so much [m]. Nothing but a weak spring keeps the loop from going along the thread to a hand and
    // over it.
    void move(double by) {
        const std::span<const Vec3> x = thread_.nodes();
        const auto held = [&](int node, double way) {
            return Hold{node, x[static_cast<std::size_t>(node)] + way * Vec3::UnitX()};
        };
        const Hold holds[] = {held(0, -by), held(1, -by), held(last_ - 1, by), held(last_, by)};
        constexpr int owners[] = {0, 0, 1, 1};
        const double spring = bending_stiffness() / (loop_ * loop_ * loop_), now = middle();
        loads_.assign(x.size(), Vec3::Zero());
        loads_[static_cast<std::size_t>(last_ / 2)].x() = -spring * (now + (now - was_));
        was_ = now;
        cost_.of([&] { return thread_.tick({holds, owners, {}, nullptr, tick_, loads_}); });
    }

    double loop_, tick_;  // [m], [s]
    Cost& cost_;
    Thread thread_;
    int last_;
    double was_, length_ = 0;
    std::vector<Vec3> loads_;
};

}  // namespace

double LooseOverhand::eps() const {
    return std::sqrt(1 / loop);
}
double LooseOverhand::law() const {
    return std::pow(eps(), 4) / 2 + 0.492 * friction * std::pow(eps(), 3);
}

double drawn_with(const LooseOverhand& knot, Cost& cost) {
    return LoopDrawing(knot, cost).mean_pull();
}

}  // namespace bench::lab
