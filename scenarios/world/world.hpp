#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "instruments/tool_world.hpp"
#include "scenarios/world/defs.hpp"
#include "scenarios/world/event.hpp"
#include "scenarios/world/knot_watch.hpp"
#include "scenarios/world/measure.hpp"
#include "scenarios/world/needle.hpp"
#include "scenarios/world/tool.hpp"
#include "scenarios/world/walls.hpp"
#include "sim/thread/thread.hpp"

namespace scenarios::world {

struct JawRoom;

/// The worst of a whole session so far.
struct Worst {
    double stretch = 0;          ///< Largest |l / l0 - 1| of a link.
    double separation = 1e300;   ///< Smallest distance of links that are no neighbours [diameters].
    double step_over_bound = 0;  ///< Largest move of a node in a substep over its bound; at most 1.
    int contacts = 0;            ///< Most contacts in a tick.
};

/// A scene: a thread or several, their needles, vessels, tools. Everything that a tick depends on is in here, so two
/// worlds made of the same definition and fed the same inputs are the same bit for bit. So is a copy: fed the same
/// inputs, it goes on as the original does, whatever becomes of that.
class World {
  public:
    /// `surface`: the rigid vessels' triangles in the world frame [m]. `start`: where the tools are, one per
    /// instrument.
    World(const WorldDef& def, std::vector<sim::geometry::Triangle> surface, std::span<const ToolInput> start);

    /// One tick of def.tick_s; one input per instrument. scenarios/world/tick.cpp shows what happens in it.
    void tick(std::span<const ToolInput> inputs);

    /// Simulated time since the scene began [s].
    double time_s() const { return static_cast<double>(ticks_) * def_.tick_s; }
    std::uint64_t ticks() const { return ticks_; }          ///< So far.
    std::uint64_t substeps() const { return substeps_; }    ///< Of the thread, in all ticks so far.
    const WorldDef& def() const { return def_; }            ///< What it was made of.
    std::span<const Tool> tools() const { return tools_; }  ///< One per instrument.
    std::span<const sim::geometry::Vec3> thread() const { return thread_.nodes(); }  ///< Nodes of all threads [m].
    const sim::thread::Thread& thread_state() const { return thread_; }              ///< All threads.
    std::vector<Vec3> curve_of(const sim::thread::Piece& piece) const;               ///< Its nodes [m].
    std::span<const double> rest_of(const sim::thread::Piece& piece) const;          ///< Lengths of its links [m].
    std::vector<std::vector<Vec3>> curves() const;                                   ///< Of all pieces [m].
    sim::thread::Piece tied_piece() const;  ///< The knot in measures() is in it.
    /// The vessels that give way, in the order of the definition.
    std::span<const SoftVessel> vessels() const { return walls_.vessels(); }
    /// One for each thread, or none.
    std::span<const Needle> needles() const { return needles_; }
    /// The needle that walls feel: the last that was taken, once no other is in one. There must be one.
    const Needle& needle_in_use() const { return needles_[in_use_]; }
    const Arc& needle() const { return needle_in_use().now; }  ///< Where it is.
    const Measures& measures() const { return measures_; }     ///< So far; judge() finds the rest.
    std::span<const Event> events() const { return events_; }  ///< All so far, in the order of their time.
    const Worst& worst() const { return worst_; }              ///< So far.
    double tension_now() const { return tension_now_; }        ///< Largest of the thread after the last tick [N].
    double stretch_now() const { return stretch_now_; }        ///< Largest |l / l0 - 1| after the last tick.

    /// FNV-1a over what a recording holds against a replay. Its words and their order stay, so that earlier recordings
    /// still verify.
    std::uint64_t hash() const;
    /// FNV-1a over every bit that is carried from tick to tick: two worlds of one definition with the same one go on
    /// alike. Waits for a naming in flight; some milliseconds.
    std::uint64_t hash_of_all_carried() const;

    /// Names the knot as the thread lies now; for the end of a session. Before that, ten times a second, the name of 20
    /// ticks ago is in measures().
    void name_knot_now();

  private:
    friend struct ForTests;
    void reserve();
    void move_instruments(std::span<const ToolInput> inputs);
    void report_lag(Tool& tool, const std::string& by);
    void list_held();
    void fit_links();
    void update_grasps();
    sim::thread::TickReport move_thread();
    void let_tools_wait();
    void let_grasps_slip();
    double trusted_share() const;
    void move_walls();
    void measure(const sim::thread::TickReport& report);
    void part_thread();
    void break_where_pulled_too_hard();
    void close_blades(Tool& tool);
    bool cut(int link, double share);
    void hold_pieces();
    void hold_pieces(Tool& tool, std::span<const int> held);
    double place_mm(int link, double share) const;
    void watch_knot();
    void note_knot();

    bool take_needle(int number, const JawRoom& room);
    bool take(Needle& needle, int number, const JawRoom& room);
    void let_needle_go(int number);
    void watch_needle();
    int wall_crossed_by(const Tool& tool);
    void watch_tools_in_walls();
    void drop_second_grip(Needle& needle);
    void hold_thread_on(Needle& needle);
    void take_hold(Tool& tool);
    void close_onto_strands(int number);
    void take_wall(Tool& tool, const JawRoom& room);
    bool is_held(int node) const;
    bool slip(Tool& tool, Grasp& grasp);
    bool is_elastic() const { return thread_.def().elastic.has_value(); }
    double tension_at(int node) const;
    double tension_before(const Grasp& grasp) const;
    double tension_after(const Grasp& grasp) const;
    double pull_on(const Grasp& grasp) const;
    struct Strand {        // of thread that leaves a tool
        int inner = -1;    // the last node that the tool holds; none: -1
        int outwards = 0;  // from there to the next node, 1 or -1
        double pull = 0;   // [N]
    };
    Strand hardest_pulling(int tool) const;
    double stretch_by(double excess, int link, int outwards, double least) const;
    ToolInput force_limited(int number, ToolInput next) const;
    Vec3 slide_by_lag(const Tool& tool, const Grasp& grasp) const;
    Vec3 slide_by_stretch(const Tool& tool, const Grasp& grasp) const;
    double most_pull() const;
    void log(EventKind kind, const std::string& what, double value);

    WorldDef def_;
    sim::thread::Thread thread_;
    Walls walls_;
    instruments::ToolWorld tool_world_;
    std::vector<Tool> tools_;
    std::vector<Needle> needles_;
    std::size_t taken_ = 0;           // index of the needle that was taken last
    std::size_t in_use_ = 0;          // index of the needle that walls feel
    sim::thread::Strength strength_;  // of the thread
    std::vector<Event> events_;
    Measures measures_;
    Worst worst_;
    std::uint64_t ticks_ = 0, substeps_ = 0;
    double tension_now_ = 0;  // [N]
    double stretch_now_ = 0;
    KnotWatch knot_watch_;

    // Scratch of one tick.
    std::vector<int> swages_;  // links that needles lead
    std::vector<int> held_;    // nodes that tools and needles hold
    std::vector<int> near_;    // triangles of walls near a tool
    std::vector<Grasp> flat_;  // a tool's grasps, laid flat; never shorter than before, so that room is kept
    Grasp before_slip_;        // what slides, as it was held
    std::vector<sim::thread::Hold> holds_;
    std::vector<int> hold_owners_;  // one per hold
    std::vector<sim::thread::MovingCapsule> capsules_;
};

}  // namespace scenarios::world
