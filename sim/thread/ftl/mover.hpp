#pragma once
#include <vector>

#include "sim/thread/contact/detection.hpp"
#include "sim/thread/ftl/step_control.hpp"
#include "sim/thread/ftl/substep.hpp"
#include "sim/thread/ftl/tension.hpp"

namespace sim::thread::ftl {

/// A thread that moves by its geometry alone: Follow-The-Leader, with contacts and friction.
class Mover {
  public:
    /// Makes it of what contact::State's constructor takes.
    Mover(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts);

    /// What is carried from tick to tick.
    const State& state() const { return state_; }
    /// What is carried from tick to tick, for who changes links between ticks.
    State& state() { return state_; }

    /// Makes a tick with State::input: tools go where they are asked to be, as far as the thread can follow. O(n +
    /// contacts) a pass, and never more than a tick may cost.
    void tick(TickReport& report);
    /// After the tick: puts into State::surface_forces what both links pull where a taut strand is turned by resting on
    /// a wall.
    void find_surface_forces();

    /// Whether links must stay as they are in this tick: all is at rest, or a substep is unfinished.
    bool keeps_links() const { return state_.settled || state_.unfinished.step_control >= 0; }
    /// Takes note that a node more has come between those of `link`, at `share` of it, 0..1.
    void split(std::size_t link, double share);
    /// Takes note that a node, neither end of its piece, is left out.
    void join_at(std::size_t node);
    /// Takes note that the nodes between these two are left out.
    void leave_out(std::size_t first, std::size_t second);
    /// After links have changed: resizes what has one entry a link, and forgets what was known of the surroundings.
    void renew();
    /// Takes note that the thread was cut: what was jammed may be free.
    void forget_jams();
    /// Keeps the nodes of pieces that sleep from moving: here no piece sleeps.
    void hold_what_sleeps() {}
    /// Wakes the piece that a link is of: here no piece sleeps.
    void wake_at(std::size_t) {}

  private:
    void begin();
    void follow_tools(TickReport& report);
    void move(const Movers& movers, int may_cost, TickReport& report);
    bool substep(const Movers& movers, bool jammed, TickReport& report);
    void learn_from_refusal(const Movers& movers, double share);
    double progress_of(const Movers& movers) const;
    void set_progress(const Movers& movers, double progress);

    State state_;
    contact::Detection detection_;
    Stepper stepper_;
    TensionEstimate tension_;
    Asked asked_;                          // of the tools that move
    int wasted_ = 0;                       // in this tick, of the work: on substeps that were refused
    std::vector<double> progress_before_;  // State::progress as a substep began
};

}  // namespace sim::thread::ftl
