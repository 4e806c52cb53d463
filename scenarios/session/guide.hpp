#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scenarios/drill/drill.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::session {

/// Watches a session and says which of the drill's steps is to be done now. It reads the world and changes nothing in
/// it; the knot is the one that the world has named beside its ticks. A copy goes on by itself.
///
/// A step is done when all of its conditions hold at once, one step a tick at most. A step that asks for a knot or
/// bites is done also while an earlier one is not: the work is there, so what was to lead to it is passed over. Steps
/// once done stay done.
/// Cost: one to three microseconds a tick.
class Guide {
  public:
    /// How a step was left behind.
    struct Mark {
        double at_s = 0;           ///< When [s].
        bool passed_over = false;  ///< A later step was done first.
    };

    /// For a session of this drill from its first tick.
    explicit Guide(const drill::Drill& drill) : steps_(drill.steps) {}

    /// Call after every tick.
    void after_tick(const world::World& world);

    /// Number of the step that is to be done now, from 0; as many as there are steps: all are done, or there are none.
    std::size_t step() const { return marks_.size(); }
    /// The step that is to be done now; none after the last.
    const drill::Step* now() const { return step() < steps_.size() ? &steps_[step()] : nullptr; }
    /// All of the drill's steps.
    std::span<const drill::Step> steps() const { return steps_; }
    /// One for each step that is behind.
    std::span<const Mark> marks() const { return marks_; }

  private:
    bool is_done(const drill::Done& done, const world::World& world) const;

    std::vector<drill::Step> steps_;
    std::vector<Mark> marks_;
    std::size_t events_seen_ = 0;
    bool event_came_ = false;  // the one that the step asks for, since it began
};

}  // namespace scenarios::session
