#pragma once
#include <array>
#include <functional>
#include <string>

#include "sim/thread/thread.hpp"
#include "tests/bench/lab/cost.hpp"

namespace bench::lab {

using sim::geometry::Vec3;
using sim::thread::Thread;
using sim::thread::ThreadDef;
using sim::thread::TickReport;

/// Two hands, each at one node of a thread or nowhere. A hand that the thread cannot follow waits where it got to.
struct Hands {
    struct Hand {
        int node = -1;  ///< -1: lets go.
        Vec3 at = Vec3::Zero();
    };

    explicit Hands(const Thread& thread);  ///< At both ends.

    void grasp(const Thread& thread, int hand, int node);
    void let_go(int hand) { hands[static_cast<std::size_t>(hand)].node = -1; }
    bool holds(int hand) const { return hands[static_cast<std::size_t>(hand)].node >= 0; }

    /// Thread::fit_links, and hands find what they hold by its new numbers.
    bool fit_links(Thread& thread);

    /// fit_links and one tick; hand 0 and 1 try to go by these ways [m].
    TickReport move(Thread& thread, const Vec3& by0, const Vec3& by1);

    std::array<Hand, 2> hands;
};

/// Hands at both ends that pull apart along the line between them.
struct Apart {
    explicit Apart(const Thread& thread);

    TickReport by(Thread& thread, double step) {
        return cost.of([&] { return hands.move(thread, -step * away, step * away); });
    }

    Hands hands;
    Vec3 away;  ///< From the first end to the last.
    Cost cost;
};

/// Pulls both ends at `speed` [m/s] in ticks of 1 ms until a hundred ticks brought them no farther apart than a
/// hundredth of the thread's thickness; returns the least that the knot took up after any tick [D]. `each` sees every
/// report.
double tighten(Thread& thread, Apart& pull, double speed, int most_ticks,
               const std::function<void(const TickReport&)>& each = {});

/// What the knot takes up, in thread diameters: Gauge::kappa.
double taken_up(const Thread& thread);

/// Named with its ends led out far beyond the nodes `first` and `last` along the line between them; empty if not
/// certain.
std::string name_between(const Thread& thread, int first, int last);

}  // namespace bench::lab
