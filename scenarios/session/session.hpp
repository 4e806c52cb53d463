#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenarios/drill/result.hpp"
#include "scenarios/session/scene.hpp"

namespace scenarios::session {

/// A ball about what is to be seen from near.
struct CloseUp {
    sim::geometry::Vec3 centre;  ///< Its middle [m].
    double radius;               ///< Its radius [m], above zero.
};

/// The scene at one moment, for a picture of it.
struct Snapshot {
    double t_s;                                             ///< Simulated time since the drill's start [s].
    std::string caption;                                    ///< What is to be seen, in a few words.
    std::vector<std::vector<sim::geometry::Vec3>> thread;   ///< Nodes of each of its pieces, in order [m].
    std::vector<instruments::ToolInput> tools;              ///< Pose and jaw of each tool, in the drill's order.
    std::vector<assets::Mesh> vessels;                      ///< What is shown of each, in the drill's order [m].
    std::vector<std::vector<sim::geometry::Vec3>> clamps;   ///< Lines of the approximators: an arm and a ring each [m].
    std::vector<std::vector<sim::geometry::Vec3>> needles;  ///< Line of each needle, from tail to tip [m].
    std::optional<CloseUp> close_up;  ///< What to look at from near. None: the whole field is of interest.
};

/// Reads a clock [us]. What a tick costs is the difference of two readings.
using Stopwatch = std::function<double()>;

/// One drill being played: what comes in at each tick decides everything; the rest is looking on.
class Session {
  public:
    /// `start`: where the tools are before the first tick. Without a stopwatch no tick is timed.
    Session(scenarios::drill::Drill drill, std::span<const instruments::ToolInput> start, Stopwatch stopwatch = {});

    /// One tick; times it.
    void tick(std::span<const instruments::ToolInput> inputs);

    /// Scores and figures as they stand, but for the machine's name; call once, after the last tick.
    scenarios::drill::Result finish();

    /// The drill that is played.
    const scenarios::drill::Drill& drill() const { return drill_; }
    /// The world after the last tick.
    const scenarios::world::World& world() const { return world_; }
    /// The whole scene as it stands.
    Snapshot snapshot(std::string caption) const;
    /// The same from near the knot that is named now; where there is none from near what the needle has bitten, if it
    /// has.
    std::optional<Snapshot> close_snapshot();
    /// What was worth a picture so far, in the order of time: first grasps, bites, knots and the like.
    const std::vector<Snapshot>& key_moments() const { return key_moments_; }

  private:
    std::optional<Snapshot> knot_snapshot(std::string caption);
    Snapshot bite_snapshot(const std::string& vessel_name, std::string caption) const;
    std::optional<Snapshot> bites_snapshot(std::string caption) const;
    void sample();
    void watch_events();

    scenarios::drill::Drill drill_;
    Stopwatch stopwatch_;
    std::vector<assets::Mesh> rigid_;
    scenarios::world::World world_;
    std::vector<scenarios::drill::Sample> samples_;
    std::vector<Snapshot> key_moments_;
    std::vector<double> tick_us_;
    std::vector<instruments::ToolInput> last_inputs_;
    std::size_t events_seen_ = 0;
};

}  // namespace scenarios::session
