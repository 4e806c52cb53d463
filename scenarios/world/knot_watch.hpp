#pragma once
#include <cstdint>
#include <future>
#include <vector>

#include "scenarios/world/defs.hpp"
#include "sim/geometry/hash.hpp"
#include "sim/knot/namer.hpp"

namespace scenarios::world {

/// A piece of thread and what it is tied to.
struct NamedPiece {
    std::vector<Vec3> curve;  ///< Its nodes when it was named [m].
    sim::knot::Tied tied;     ///< Its knot, and the vessel that it is hitched to.
};

/// Names the thread's knots ten times a second, faster than anyone reads them, each time from a copy on another
/// processor core: no tick waits for the 2 ms that a name takes. Names are fetched at a tick that is known beforehand,
/// so that a session is the same however busy the machine is. A copy shares a naming in flight and fetches it at the
/// same tick.
class KnotWatch {
  public:
    /// `def`: its vessels are what thread may be hitched to.
    explicit KnotWatch(const WorldDef& def);

    /// The thread has moved, so its names may be out of date.
    void note_motion() { moved_ = true; }
    /// Takes the names that are due at this tick, if any; true when it did. Waits for them where they are not done.
    bool fetch(std::uint64_t tick);
    /// Whether a naming is to be started at this tick.
    bool is_due(std::uint64_t tick) const { return tick % period == 0 && moved_; }
    /// Names these pieces beside the ticks.
    void start(std::vector<std::vector<Vec3>> curves);
    /// Names these pieces at once. What is in flight is dropped.
    void name_now(std::vector<std::vector<Vec3>> curves);

    /// The pieces as last named, in their order along the thread; none before the first fetch.
    const std::vector<NamedPiece>& named() const { return named_; }
    /// Index of the piece that is tied most, the first of those that are tied alike; `named()` must not be empty.
    std::size_t most_tied() const;
    /// Adds all that is carried from tick to tick; waits for a naming in flight.
    friend void add_to(sim::geometry::Hash& hash, const KnotWatch& watch);

  private:
    friend struct ForTests;
    static constexpr std::uint64_t period = 100, delay = 20;  // [ticks]

    bool moved_ = true;  // the thread has, since it was last named
    std::shared_future<std::vector<NamedPiece>> naming_;
    std::vector<NamedPiece> named_;
    std::vector<std::vector<Vec3>> cores_;  // of the vessels
};

}  // namespace scenarios::world
