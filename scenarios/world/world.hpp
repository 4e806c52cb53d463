#pragma once
#include <array>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "instruments/needle.hpp"
#include "instruments/tool_world.hpp"
#include "scenarios/world/defs.hpp"
#include "scenarios/world/event.hpp"
#include "scenarios/world/measure.hpp"
#include "scenarios/world/moving_wall.hpp"
#include "scenarios/world/soft_vessel.hpp"
#include "sim/thread/thread.hpp"
#include "tissue/contact.hpp"

namespace scenarios::world {

using instruments::Arc;
using instruments::ToolInput;

struct JawRoom;

/// One strand between a tool's jaws: the nodes `first` to `first + count - 1`, fixed to the tool.
struct Grasp {
    static constexpr int most = 16;
    int first = 0, count = 0;
    std::array<Vec3, most> anchor;  ///< Where the tool holds each, in the tool's frame [m].

    int middle() const { return first + count / 2; }
};

/// A point of a wall between a tool's jaws.
struct WallGrip {
    int vessel;  ///< Of World::vessels().
    tissue::MaterialPoint at;
    Vec3 anchor;  ///< Where the tool draws it, in the tool's frame [m].
};

struct Tool {
    InstrumentDef def;
    instruments::ToolShape shape;
    ToolInput asked;        ///< Last good input.
    ToolInput before, now;  ///< Where the simulated tool was and is; behind `asked` when it must wait.
    std::vector<Grasp> grasps;
    bool closed = false;    ///< Jaws are shut on whatever they hold; with hysteresis.
    bool stopped = false;   ///< By another tool or a vessel, in this tick.
    bool slipping = false;  ///< The thread slid between the jaws in the last tick.
    std::vector<WallGrip> walls = {};
    bool held_up = false;  ///< Farther behind its hand than a jaw is thick, by what stands in its way; told once.

    /// How far it is behind its hand, a turn taken at its jaws' length [m].
    double lag() const { return instruments::way_between(now.pose, asked.pose, shape.jaw_length); }
};

/// Who holds the needle, and how.
struct Holder {
    int tool = -1;     ///< None: -1.
    Arc seen = {};     ///< The needle in the tool's frame.
    double along = 0;  ///< Where the jaws have it, from its tail [m].
};

/// Goes where its holder goes and stays where it is let go. `next` has closed on it too, and leads it when the other
/// lets go.
struct Needle {
    int node;  ///< Of the thread that it is swaged to, its first.
    Arc before, now;
    Holder holder, next;
    bool bent = false;  ///< It was pushed harder than its wire bears; it stays as it is here.

    Arc led_by(const instruments::Pose& tool) const;
};

/// A piece of thread and what it is tied to.
struct NamedPiece {
    std::vector<sim::geometry::Vec3> curve;
    sim::knot::Tied tied;
};

/// Worst of the whole session so far; a drill's result quotes them.
struct Worst {
    double stretch = 0, separation = 1e300, step_over_bound = 0;
    int contacts = 0;
};

/// A scene: a thread or several, their needles, vessels, tools. Everything a tick depends on is in here, so two worlds
/// made of the same definition and fed the same inputs are the same bit for bit.
class World {
  public:
    /// `surface`: the rigid vessels' triangles in the world frame. `start`: where the tools are, one per instrument.
    /// `record_events` false saves time when only the state matters.
    World(const WorldDef& def, std::vector<sim::geometry::Triangle> surface, std::span<const ToolInput> start);

    /// One tick of def.tick_s; one input per instrument. scenarios/world/tick.cpp shows what happens in it.
    void tick(std::span<const ToolInput> inputs);

    double time_s() const { return static_cast<double>(ticks_) * def_.tick_s; }
    std::uint64_t ticks() const { return ticks_; }
    std::uint64_t substeps() const { return substeps_; }
    const WorldDef& def() const { return def_; }
    std::span<const Tool> tools() const { return tools_; }
    std::span<const sim::geometry::Vec3> thread() const { return thread_.nodes(); }
    const sim::thread::Thread& thread_state() const { return thread_; }
    std::vector<std::vector<Vec3>> curves() const;  ///< Of its pieces.
    sim::thread::Piece tied_piece() const;          ///< That the knot in measures() is in.
    /// Those that give way, in the order of the definition.
    std::span<const SoftVessel> vessels() const { return vessels_; }
    /// One for each thread, or none.
    std::span<const Needle> needles() const { return needles_; }
    const Needle& needle_in_use() const {
        return needles_[in_use_];
    }  ///< That walls feel: the last that was taken, once no other is in one.
    const Arc& needle() const { return needle_in_use().now; }
    const Measures& measures() const { return measures_; }
    std::span<const Event> events() const { return events_; }
    const Worst& worst() const { return worst_; }
    double tension_now() const { return tension_now_; }
    double stretch_now() const { return stretch_now_; }

    /// Of everything the next tick depends on.
    std::uint64_t hash() const;

    /// Names the knot as the thread lies now; for the end of a session. Before that, ten times a second, the name of 20
    /// ticks ago is in measures().
    void name_knot_now();
    /// Where that knot is and how it lies: tails, loop, the vessels it goes round, how far from them. Names many pieces
    /// of the thread: for the end of a session.
    void locate_knot();
    /// The knot of each piece, likewise.
    void judge_ties();
    /// Bites, and the join of two cut ends: for the end of a session too.
    void judge_sewing();

  private:
    void move_instruments(std::span<const ToolInput> inputs);
    void tell_what_holds_up(Tool& tool, const std::string& by);
    void list_held();
    void fit_links();
    void update_grasps();
    sim::thread::TickReport move_thread();
    void let_tools_wait();
    void let_grasps_slip();
    double believed_share() const;
    void push_walls(int vessel);
    void press_walls_together();
    void clamp(SoftVessel& vessel);
    void lead_clamps(SoftVessel& vessel);
    void load_vessels();
    void move_vessels();
    void move(SoftVessel& vessel, double seconds);
    void pull_at_bites(SoftVessel& vessel, double seconds);
    void renew_wall();
    void show_vessels();
    void measure(const sim::thread::TickReport& report);
    void part_thread();
    void break_where_pulled_too_hard();
    void close_blades(Tool& tool);
    bool cut(int link, double share);
    void hold_pieces();
    void hold_pieces(Tool& tool, std::span<const int> held);
    double place_mm(int link, double share) const;
    void name_beside();
    void take_names(std::vector<NamedPiece> pieces);
    std::vector<Vec3> curve_of(const sim::thread::Piece& piece) const;
    std::span<const double> rest_of(const sim::thread::Piece& piece) const;
    void locate_hitch(const VesselDef& vessel, const sim::thread::Piece& piece);
    void measure_knot(const std::vector<sim::geometry::Vec3>& curve, std::size_t first, std::size_t last);

    bool take_needle(int number, const JawRoom& room);
    bool take(Needle& needle, int number, const JawRoom& room);
    void let_needle_go(int number);
    bool is_needle_in_wall() const;
    void watch_needle();
    void drop_second_grip(Needle& needle);
    void hold_thread_on(Needle& needle);
    void take_hold(Tool& tool);
    void close_onto_strands(int number);
    void take_wall(Tool& tool, const JawRoom& room);
    void look_for_walls(Tool& tool, const JawRoom& room, int vessel, const std::vector<int>& near, double z) const;
    void pull_walls(int vessel);
    bool is_held(int node) const;
    bool slip(Tool& tool, Grasp& grasp);
    bool is_elastic() const { return thread_.def().elastic.has_value(); }
    double tension_at(int node) const;
    double tension_before(const Grasp& grasp) const;
    double tension_after(const Grasp& grasp) const;
    double pull_on(const Grasp& grasp) const;
    /// From the last node that a tool holds to the next, one of them up or down the thread.
    struct Strand {
        int inner = -1, outwards = 0;
        double pull = 0;  ///< [N]
    };
    Strand hardest_pulling(int tool) const;
    double stretch_by(double excess, int link, int outwards, double least) const;
    ToolInput by_feel(int number, ToolInput next) const;
    Vec3 slide_by_lag(const Tool& tool, const Grasp& grasp) const;
    Vec3 slide_by_stretch(const Tool& tool, const Grasp& grasp) const;
    double most_pull() const;
    static int turns_around(const VesselDef& vessel, const std::vector<Vec3>& curve, std::size_t first,
                            std::size_t last);
    void log(EventKind kind, const std::string& what, double value);

    WorldDef def_;
    sim::thread::Thread thread_;
    std::vector<SoftVessel> vessels_;
    tissue::CapsuleContact tool_contact_{{}};
    tissue::WallContact wall_contact_;
    MovingWall wall_;                            // of all vessels, the rigid ones first
    std::vector<Triangle> targets_;              // where it should be
    std::vector<double> rooms_;                  // scratch,
    std::vector<sim::thread::SurfaceGap> gaps_;  // and this
    bool wall_is_new_ = false;                   // its triangles have other numbers than the thread knows
    double wall_moved_ = 0;                      // since the last tick [m]
    instruments::ToolWorld tool_world_;
    std::vector<Tool> tools_;
    std::vector<Needle> needles_;
    std::size_t taken_ = 0, in_use_ = 0;    // of them: the last that was, and that walls feel
    std::vector<int> swages_;               // links that needles lead, in this tick
    std::vector<int> held_;                 // nodes; scratch
    std::vector<Grasp> flat_;               // scratch
    std::vector<sim::thread::Hold> holds_;  // of this tick
    std::vector<int> hold_owners_;
    std::vector<sim::thread::MovingCapsule> capsules_;
    std::vector<Event> events_;
    Measures measures_;
    Worst worst_;
    std::uint64_t ticks_ = 0, substeps_ = 0;
    double tension_now_ = 0, stretch_now_ = 0;
    sim::thread::Strength strength_;
    bool moved_since_named_ = true;
    std::future<std::vector<NamedPiece>> naming_;
    std::vector<NamedPiece> named_;                        // last; of pieces that are tied alike the first counts
    std::vector<std::vector<sim::geometry::Vec3>> cores_;  // of the vessels
};

}  // namespace scenarios::world
