#pragma once
#include <vector>

#include "sim/thread/contact/audit.hpp"
#include "sim/thread/contact/detection.hpp"
#include "sim/thread/elastic/advance.hpp"
#include "sim/thread/elastic/contact_solver.hpp"
#include "sim/thread/elastic/find_contacts.hpp"

namespace sim::thread::elastic {

/// A thread that moves by forces: an elastic rod with contacts and Coulomb friction.
class Mover {
  public:
    /// Makes it of what contact::State's constructor takes; `def` is elastic, and there are at least 3 nodes.
    Mover(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts);

    /// What is carried from tick to tick.
    const State& state() const { return state_; }
    /// What is carried from tick to tick, for who changes links between ticks.
    State& state() { return state_; }

    /// Makes a tick with State::input, all but its report's figures of the whole thread. Eight steps at most, each
    /// O(n + m^2) for m contacts that touch.
    void tick(TickReport& report);
    /// After the tick: puts the pushes and the friction of what presses on the surface into State::surface_forces.
    void find_surface_forces();

    /// Whether links must stay as they are in this tick: never.
    bool keeps_links() const { return false; }
    /// Takes note that a node more has come between those of `link`, at `share` of it, 0..1.
    void split(std::size_t link, double share);
    /// Takes note that a node, neither end of its piece, is left out.
    void join_at(std::size_t node);
    /// Takes note that the nodes between these two are left out, and with them what pressed on their links.
    void leave_out(std::size_t first, std::size_t second);
    /// After links have changed: resizes what has one entry a link, and forgets what was known of the surroundings.
    void renew();
    /// Takes note that the thread was cut: an elastic thread carries no jams to forget.
    void forget_jams() {}
    /// Keeps the nodes of pieces that sleep from moving, as holds do.
    void hold_what_sleeps();
    /// Wakes the piece that a link is of.
    void wake_at(std::size_t link);

  private:
    /// Of a tick.
    struct Left {
        double motion = 1;     // share that tools have still to make
        bool is_taut = false;  // they wait: they pulled as hard as any may
    };
    void respond(double left, double tools, const Motion& motion, TickReport& report);
    Left step(double left, const Motion& motion, TickReport& report);
    void end_step(TickReport& report);
    void add_changes();
    double share_within_bounds() const;
    void set_progress(double progress);

    State state_;
    contact::Detection detection_;
    contact::Audit audit_;
    Advance advance_;
    ContactFinder finder_;
    IslandSolver solver_;
    ContactSet set_;             // of this step
    std::vector<Hold> targets_;  // of held nodes in this step
    std::vector<Vec3> forces_;   // per node: what pushes have become since the rod's step was found [N]
    std::vector<int> stirred_;   // links of pieces that wake
};

}  // namespace sim::thread::elastic
