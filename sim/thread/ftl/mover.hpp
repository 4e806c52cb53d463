#pragma once
#include <vector>

#include "sim/thread/contact/detection.hpp"
#include "sim/thread/ftl/pace.hpp"
#include "sim/thread/ftl/substep.hpp"
#include "sim/thread/ftl/tension.hpp"

namespace sim::thread::ftl {

/// A thread that moves by its geometry alone: Follow-The-Leader, with contacts and friction.
class Mover {
  public:
    /// As contact::State.
    Mover(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts);

    /// What is carried from tick to tick.
    const State& state() const { return state_; }
    /// What is carried from tick to tick, for who changes links between ticks.
    State& state() { return state_; }

    /// Tools to where they are asked to be, as far as the thread can follow; State::input is known. O(n + contacts) a
    /// pass, and never more than a tick may cost.
    void tick(TickReport& report);
    /// Into State::surface_forces, after the tick: where a taut strand is turned by resting on a wall both its links
    /// pull.
    void find_surface_forces();

    /// Whether links must stay as they are in this tick: all is at rest, or a substep is unfinished.
    bool keeps_links() const { return state_.settled || state_.unfinished.pace >= 0; }
    /// A node more has come between those of `link`, at `share` of it.
    void split(std::size_t link, double share);
    /// A node, neither end of its piece, is no more.
    void join_at(std::size_t node);
    /// Nodes between these two are no more.
    void leave_out(std::size_t first, std::size_t second);
    /// Links have changed: what there is one of per link, and what was known of the surroundings, is begun anew.
    void renew();
    /// The thread was cut: what was jammed may be free.
    void forget_jams();
    /// Nodes that do not move by themselves but for holds: none.
    void hold_what_sleeps() {}
    /// The piece of a link is about to change: nothing sleeps.
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
    int wasted_ = 0;                       // in this tick, of the work: on answers that were refused
    std::vector<double> progress_before_;  // State::progress as a substep began
};

}  // namespace sim::thread::ftl
