#pragma once
#include <vector>

#include "sim/thread/contact/audit.hpp"
#include "sim/thread/ftl/relaxation.hpp"
#include "sim/thread/ftl/slide.hpp"

namespace sim::thread::ftl {

/// How the thread responds when held nodes move. Least motion first: all nodes together move as little as the lengths
/// allow, so slack is taken up before anything is dragged (plain Follow-The-Leader drags the far end of a slack thread
/// as if it were taut). A taut thread that must slide round things is found quickly only by letting it follow its
/// leader. Drawn over walls, through ten bites, it must slide along itself: neither is found. Where strands are jammed
/// in each other and no solution is found for them, what presses stays where it is and the slack around it moves: a
/// knot pulled tight must not hold up the hands that let go of it. What is unfinished is gone on with.
enum class Method {
    drift,              ///< All nodes move as little as the lengths allow.
    follow_the_leader,  ///< Every node follows the one before it from the hold outwards.
    slide,              ///< The thread moves along itself.
    keep_what_presses,  ///< What presses stays, the rest moves as little as the lengths allow.
    go_on,              ///< The unfinished substep is worked at further.
};

/// What an attempt came to.
struct Substep {
    bool accepted = false;  ///< Whether it stands; else all is as it was before.
    double over_bound = 0;  ///< Largest move of a node over its bound; at most 1.
    int pass_throughs = 0;  ///< Pass-throughs that the audit found.
};

/// Takes substeps, each whole or not at all.
class Stepper {
  public:
    /// Makes room for the links that the thread may come to have.
    explicit Stepper(const State& state);
    /// Measures bends anew, after links have changed.
    void resize(const State& state) { relaxation_.resize(state); }

    /// Moves tools and held nodes to where they are at State::progress, by at most `path` [m], and lets the thread
    /// respond. It is undone unless the result is within tolerance or no worse than what was there: so a thread that
    /// cannot follow stays as it is and the tools wait.
    Substep attempt(State& state, double path, Method method, Effort effort);
    /// What attempts have cost since it was last set to 0, in passes over contacts and lengths.
    int& work() { return relaxation_.work; }

  private:
    void keep_what_presses(State& state);
    void let_go_of_kept(State& state);
    void begin_with(State& state, double path, Method method);
    double try_method(State& state, double path, Method method, Effort effort);

    Relaxation relaxation_;
    FollowLeader leader_;
    Slide slide_;
    contact::Audit audit_;
    std::vector<int> kept_;  // nodes that are held in this attempt because they press
};

}  // namespace sim::thread::ftl
