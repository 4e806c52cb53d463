#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scenarios/world/event.hpp"
#include "scenarios/world/moving_wall.hpp"
#include "scenarios/world/needle.hpp"
#include "scenarios/world/soft_vessel.hpp"
#include "scenarios/world/tool.hpp"
#include "tissue/contact.hpp"

namespace scenarios::world {

/// What acts on the walls of a scene in one tick.
struct WallLoads {
    const sim::thread::Thread& thread;  ///< After it has moved in this tick.
    std::span<const Tool> tools;        ///< After they have moved in this tick.
    const Needle* needle;               ///< The one that walls feel; none: nullptr.
    double trusted_share;               ///< How much of the thread's pressure counts, above 0 to 1.
    std::uint64_t tick;                 ///< Its number, from 1.
    double tick_s;                      ///< How long each tick is [s].
};

/// All walls of a scene: the vessels that give way, the contact between them, and what of them, and of rigid ones, is
/// shown to the thread. Each vessel is stepped in turn, one a tick, by as long as it takes until its turn comes again.
class Walls {
  public:
    /// `rigid`: the other vessels' triangles in the world frame [m].
    Walls(const WorldDef& def, std::vector<Triangle> rigid);

    /// Once, before the first tick: vessels that a tool holds by their clamps learn where its jaws are.
    void clamp(std::span<const Tool> tools);
    /// One tick; appends what happened to `events`.
    void tick(const WallLoads& loads, std::vector<Event>& events);

    /// The vessels that give way, in the order of the definition.
    std::span<const SoftVessel> vessels() const { return vessels_; }
    /// A needle touches one of them or is in one.
    bool hold_needle() const;
    /// What the thread meets: triangles of the rigid vessels and then of those that give way.
    const sim::geometry::TriangleTree& tree() const { return shown_.tree(); }
    /// Number of the first triangle that gives way; as many as there are where none does.
    int soft_from() const { return vessels_.empty() ? shown_.size() : vessels_.front().first; }
    /// How far what is shown went since the last tick at most [m]; infinite where triangles have other numbers.
    double moved() const { return moved_; }
    /// Adds all that is carried from tick to tick.
    friend void add_to(sim::geometry::Hash& hash, const Walls& walls);

  private:
    friend struct ForTests;
    void take_pressure(const WallLoads& loads);
    void press_together();
    void move(SoftVessel& vessel, double seconds, const WallLoads& loads, std::vector<Event>& events);
    void push_out_of_tools(SoftVessel& vessel, std::span<const Tool> tools);
    void follow_needle(SoftVessel& vessel, const WallLoads& loads);
    void renew();
    void show(const sim::thread::Thread& thread);
    int index_of(const SoftVessel& vessel) const { return static_cast<int>(&vessel - vessels_.data()); }

    std::vector<SoftVessel> vessels_;
    tissue::CapsuleContact tool_contact_{{}};
    tissue::WallContact wall_contact_;
    MovingWall shown_;                           // of all vessels, the rigid ones first
    std::vector<Triangle> targets_;              // where what is shown should be
    std::vector<double> rooms_;                  // scratch: of each triangle, what Thread::surface_room() tells [m]
    std::vector<sim::thread::SurfaceGap> gaps_;  // scratch: of each link near it, likewise
    bool is_new_ = false;                        // the shown triangles have other numbers than the thread knows
    double moved_ = 0;                           // since the last tick [m]
};

}  // namespace scenarios::world
