#pragma once
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/pull.hpp"

namespace bench::lab {

/// Our thread, held by two tools that go where the hands are as far as the thread lets them.
class ThreadRope : public Rope {
  public:
    ThreadRope(const PullDef& def, const std::vector<Vec3>& start)
        : ThreadRope(def, start, {.axial_over_bending = 0}) {}
    /// `rod`: what it is made of where it is elastic.
    ThreadRope(const PullDef& def, const std::vector<Vec3>& start, const sim::thread::RodDef& rod)
        : thread_(thread_def(def, rod), start), last_(def.links), grip_(def.elastic ? def.link() : 0) {}

    void tick(const Vec3& left, const Vec3& right) override {
        const Vec3 in = grip_ * (right - left).normalized();
        const sim::thread::Hold holds[] = {{0, left}, {last_, right}, {1, left + in}, {last_ - 1, right - in}};
        constexpr int owners[] = {0, 1, 0, 1};
        const std::size_t held = grip_ > 0 ? 4 : 2;
        pass_throughs_ += thread_.tick({{holds, held}, {owners, held}, {}, nullptr}).pass_throughs;
    }
    void read(std::vector<Vec3>& nodes) const override { nodes.assign(thread_.nodes().begin(), thread_.nodes().end()); }
    int pass_throughs() const override { return pass_throughs_; }

  private:
    static sim::thread::ThreadDef thread_def(const PullDef& def, const sim::thread::RodDef& rod) {
        sim::thread::ThreadDef thread{.radius = 0.5 * def.thickness(), .friction = def.friction};
        if (def.elastic) thread.elastic = rod;
        return thread;
    }

    sim::thread::Thread thread_;
    int last_;
    double grip_;  ///< How far in a hand's second node is [m]; 0: it holds one.
    int pass_throughs_ = 0;
};

}  // namespace bench::lab
