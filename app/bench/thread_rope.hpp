#pragma once
#include "app/bench/pull.hpp"
#include "sim/thread/thread.hpp"

namespace app::bench {

/// Our thread, held by two tools that go where the hands are as far as the thread lets them.
class ThreadRope : public Rope {
  public:
    ThreadRope(const PullDef& def, const std::vector<Vec3>& start)
        : thread_({.radius = 0.5 * def.thickness(), .friction = def.friction}, start), last_(def.links) {}

    void tick(const Vec3& left, const Vec3& right) override {
        const sim::thread::Hold holds[] = {{0, left}, {last_, right}};
        constexpr int owners[] = {0, 1};
        pass_throughs_ += thread_.tick({holds, owners, {}, nullptr}).pass_throughs;
    }
    void read(std::vector<Vec3>& nodes) const override { nodes.assign(thread_.nodes().begin(), thread_.nodes().end()); }
    int pass_throughs() const override { return pass_throughs_; }

  private:
    sim::thread::Thread thread_;
    int last_;
    int pass_throughs_ = 0;
};

}  // namespace app::bench
