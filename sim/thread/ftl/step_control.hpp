#pragma once
#include <vector>

#include "sim/thread/contact/tools.hpp"
#include "sim/thread/ftl/state.hpp"

// Step-size control: how far tools dare to go in a substep, and when they wait.
namespace sim::thread::ftl {

using contact::Motion;

/// Which tools move: one group, or all. Tools are numbered from 0; what nobody holds is -1.
struct Movers {
    std::size_t first;         ///< Index of the group's first tool in State::progress.
    std::size_t past;          ///< Index past the group's last tool in State::progress.
    std::size_t step_control;  ///< Index of the group's step-size control in State::step_controls.

    /// Whether the group has the tool `owner`, from -1.
    bool include(int owner) const {
        const auto group = static_cast<std::size_t>(owner + 1);
        return group >= first && group < past;
    }
};

/// What tools ask for in a tick.
struct Asked {
    std::vector<Vec3> displacements;  ///< Displacements of what is held, then of the ends of tools' own parts [m].
    Motion motion;                    ///< The longest of them.

    /// Collects what these tools ask for in this tick.
    void collect(const State& state, const Movers& movers);
    /// Whether what is asked for is much the same as what was refused: a hand that trembles or pulls harder asks for
    /// the same, one that turns or stops does not.
    bool is_much_the_same(const State& state, const std::vector<Vec3>& refused) const;
};

/// Share of the whole tick's motion that one substep may make, 0..1: no node farther than its own bound, no tool part
/// into the thread by more than the thread's radius. O(n + contacts).
double admissible_share(const State& state, const Movers& movers, const Motion& motion);

/// Whether what is jammed waits in this tick; counts down the ticks that it still waits.
bool waits(const State& state, StepControl& step_control, const Asked& asked);
/// Shortens steps after a substep that was refused. What is jammed is tried again after 1, 3, 7 ... ticks, a second at
/// last: nothing has changed meanwhile.
void shorten_steps(StepControl& step_control);
/// Lengthens steps after a substep that was accepted. A hard step costs the same however short it is, so it too may
/// become longer; more slowly, for a refused one quarters it again.
void lengthen_steps(StepControl& step_control, bool was_easy);
/// Lets what is jammed try again: the thread has moved, and may grant now what it refused a while ago.
void wake(State& state);
/// Whether steps are so short that one is worked at for several ticks.
inline bool creeps(const StepControl& step_control) {
    return step_control.trust_region < 0.125;
}

}  // namespace sim::thread::ftl
