#include "tests/bench/lab/pull.hpp"

#include <algorithm>
#include <cmath>

#include "sim/knot/namer.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/gauge.hpp"

namespace bench::lab {

namespace {

constexpr double waiting = 0.5;     // [s] before the pull, when it is nearly tight, and in the end
constexpr double far_apart = 1.05;  // of the rope's length: where the hands end

enum class Phase { pull, rest, over };

class Run {
  public:
    Run(Rope& rope, const PullDef& def, const std::vector<Vec3>& start)
        : rope_(rope),
          def_(def),
          gauge_(std::vector(start.size() - 1, def.link()), def.thickness()),
          nodes_(start),
          left_(start.front()),
          right_(start.back()) {}

    PullFigures figures() {
        const std::string knot = sim::knot::name_knot(nodes_).knot;
        for (double t = 0; t < waiting; t += def_.tick) rope_.tick(left_, right_);
        while (distance() < def_.length - def_.waits_at * def_.thickness()) tick(Phase::pull, def_.speed);
        for (double t = 0; t < waiting; t += def_.tick) tick(Phase::rest, 0);
        while (distance() < far_apart * def_.length) tick(Phase::over, def_.speed);
        for (double t = 0; t < waiting; t += def_.tick) tick(Phase::over, 0);
        measured_.knot_kept = std::isfinite(gauge_.stretch(nodes_)) && sim::knot::name_knot(nodes_).knot == knot;
        measured_.pass_throughs = rope_.pass_throughs();
        add_times();
        return measured_;
    }

  private:
    double distance() const { return (right_ - left_).norm(); }

    void tick(Phase phase, double speed) {
        const Vec3 step = speed * def_.tick * Vec3::UnitX();
        left_ -= step;
        right_ += step;
        const double begin = processor_time();
        rope_.tick(left_, right_);
        const double us = 1e6 * (processor_time() - begin);
        rope_.read(nodes_);
        measure(phase);
        if (phase == Phase::rest) return;
        all_.push_back(us);
        if (gauge_.kappa(nodes_) < def_.tight_below) tight_.push_back(us);
    }

    void measure(Phase phase) {
        PullFigures& m = measured_;
        // A rope that once was no number stays known as such.
        const auto raise = [](double& most, double value) { most = value > most || std::isnan(value) ? value : most; };
        const auto lower = [](double& least, double value) {
            least = value < least || std::isnan(value) ? value : least;
        };
        const double stretch = gauge_.stretch(nodes_), kappa = gauge_.kappa(nodes_);
        if (phase == Phase::pull) raise(m.stretch_pull, stretch);
        if (phase == Phase::rest) m.stretch_rest = stretch, m.kappa_rest = kappa;  // the last one stays
        if (phase == Phase::over) raise(m.stretch_over, stretch);
        lower(phase == Phase::over ? m.gap_over : m.gap_pull, gauge_.gap(nodes_));
        lower(m.kappa_least, kappa);
        const double behind = std::max((nodes_.front() - left_).norm(), (nodes_.back() - right_).norm());
        raise(m.lag, behind / def_.thickness());
    }

    void add_times() {
        PullFigures& m = measured_;
        m.tick_p50 = percentile(all_, 0.5), m.tick_p99 = percentile(all_, 0.99), m.tick_max = percentile(all_, 1);
        m.tight_p50 = percentile(tight_, 0.5), m.tight_p99 = percentile(tight_, 0.99),
        m.tight_max = percentile(tight_, 1);
        m.tick_mean = 0;
        for (const double us : all_) m.tick_mean += us / static_cast<double>(all_.size());
    }

    Rope& rope_;
    PullDef def_;
    Gauge gauge_;
    std::vector<Vec3> nodes_;
    Vec3 left_, right_;
    std::vector<double> all_, tight_;  // [us]
    PullFigures measured_{};
};

}  // namespace

PullFigures pull(Rope& rope, const PullDef& def, const std::vector<Vec3>& start) {
    return Run(rope, def, start).figures();
}

}  // namespace bench::lab
