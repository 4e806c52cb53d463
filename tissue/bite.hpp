#pragma once
#include <limits>

#include "sim/geometry/arc.hpp"
#include "tissue/contact.hpp"
#include "tissue/rim.hpp"

namespace tissue {

using sim::geometry::Arc;

/// How a needle meets a wall. SI.
struct BiteDef {
    /// Force at which the tip goes through the skin, out of the wall as into it [N]; by tissue and needle. Does not
    /// depend on speed. Tapered tips of 6-0 to 8-0 in vessels: 0.05 to 0.5. But an end of 0.1 MPa that nobody holds
    /// caves in at 5 mN: it needs something held against it, or a sharper needle. A wall that caves in so far that the
    /// tip is out on its other side, or that is met so flat that the tip is a wall's thickness beyond, is pierced by
    /// less.
    double puncture = 3e-3;
    /// Of a metre of wire in the wall [N/m]. No source; with much more, a soft free end is drawn along, not through.
    double friction = 1;
    double stiffness = 500;  ///< Of the wall about the wire, across it, and of what friction holds [N/m].
    /// Of the dimple that the mesh does not resolve [N/m]. A cone of 10 degrees each side goes in deeper still
    /// (Sneddon: 2/pi E / (1 - nu^2) d^2 tan 10, 25 N/m at 10 mN in 0.1 MPa); stiffer, a quick needle's step of 40 um
    /// overshoots the threshold. Where the threshold asks for more than 0.6 of the wall it is as stiff as that takes.
    double tip_stiffness = 120;
    double grip = 1;  ///< Friction over pressure, of the tip on skin that it has not pierced. No source.
    /// Radius of what is left for the thread, 1.3 times its own: the wall closes about it behind the needle [m].
    double hole = 0.055e-3;
    Vec3 axis = Vec3::UnitX();  ///< The vessel's, unit.
    double wall = 0.5e-3;       ///< Thickness of the wall [m].
    /// What a hole bears before it tears out to the cut, for a metre of wall and a metre from there [N/m^2]: mammary
    /// arteries, 0.4 mm thick, bitten 2 mm from the edge, held 1.35 +- 0.49 N. Taken as linear in both, up to 3 mm.
    double retention = 1.35 / (0.4e-3 * 2e-3);
};

/// Where a needle, or the thread behind it, goes through a skin.
struct BiteEnd {
    int hole = -1;            ///< Its number in the skin; none: -1.
    MaterialPoint at;         ///< Which point of the wall it is.
    Side side = Side::outer;  ///< Which skin it is in.
    double force = 0;         ///< That pierced it; through an old hole 0 [N].
    bool caved_in = false;    ///< It was pierced by less than BiteDef::puncture.
};

/// How far a needle has come.
enum class BiteState {
    pricked,  ///< The tip is in the wall.
    open,     ///< Through both skins: the needle's wire is in it, or what follows it.
    empty,    ///< The needle left the way it came.
};

/// One passage through a wall, from skin to skin.
struct Bite {
    BiteState state = BiteState::pricked;  ///< How far the needle has come.
    BiteEnd entry;                         ///< Where it went in.
    BiteEnd exit;                          ///< Where it came out, if it is open.
    double depth = 0;                      ///< Of the wire below the skin at the entry, at the deepest [m].
    /// Between needle and skin where the skin was first touched, 0 to a quarter turn [rad].
    double angle_to_wall = 0;
    /// Between the plane of the needle, where it cuts the skin, and the vessel's axis, 0 to a quarter turn; of a
    /// straight needle 0 [rad].
    double angle_to_axis = 0;
    int pass = 0;             ///< The same for bites of a needle that did not leave the vessel in between.
    bool on_needle = true;    ///< The needle has not been drawn through yet; after that the bite is the thread's.
    bool torn = false;        ///< Out to the cut: neither needle nor thread is held by it any more.
    bool both_walls = false;  ///< One pass took this wall and, through the lumen, the one across.

    /// It does not go from outside to the lumen or back.
    bool partial() const {
        return state == BiteState::open && !((entry.side == Side::outer && exit.side == Side::inner) ||
                                             (entry.side == Side::inner && exit.side == Side::outer));
    }
};

/// Something that a needle or a pull did to a wall.
struct BiteEvent {
    /// What can happen.
    enum Kind {
        pierced,    ///< The tip went into the wall.
        through,    ///< The tip came out of the wall.
        back_in,    ///< The needle goes back, its tip is in the wall again.
        withdrawn,  ///< The needle left as it came.
        drawn,      ///< All of the needle is through.
        torn,       ///< The bite is torn out to the cut, which it now opens into.
        slipped,    ///< The tip went over an edge of a wall that gave way too much to be pierced; no bite.
    } kind;         ///< What happened.
    int bite;       ///< Its number; none: -1.
    double force;   ///< That pierced a skin or tore it, or that the tip pressed with before it slipped [N].
};

/// A needle that goes into, through and out of one vessel's wall, as often as it likes; its bites remain. Before the
/// tip is through a skin it dimples it, or tents it from within; from then on the wire runs in a channel: the points of
/// the wall where it enters and leaves are drawn onto the arc, and held along it by friction. What of the wire is
/// outside pushes the wall aside as any tool does. Deterministic; nothing is allocated once there is room for forces
/// and bites.
///
/// Each step: press(), Tissue::step() with forces(), Skin::update(), settle().
class Bites {
  public:
    /// Of a wall that is so at rest.
    Bites(const BiteDef& def, const Mesh& rest);

    /// Where the needle is now; none: nullptr, as when it is taken away, or cut off behind its thread. One whose tip
    /// jumps by more than a quarter of its length is taken away and put elsewhere. Some 50 us where the needle is near
    /// the vessel.
    void press(const Arc* needle, const Skin& skin);
    /// What the needle does to the wall in the next step, since press().
    std::span<const PointForce> forces() const { return forces_; }
    /// Finds what came of the step; opens holes in the skin.
    void settle(Skin& skin);

    /// How much a bite bears, by its hole that is further from the cut [N]; far from any, or in a wall without one, 3
    /// mm's worth.
    double bears(const Bite& bite) const;
    /// The thread pulls at a bite with `force` [N]; after settle(), for the needle's own pull is known. True once that
    /// has been more than the bite bears: it is torn, the needle is in it no longer, and the skin is slit from its
    /// holes to the cut, 0.6 ms, so that thread can leave. A bite that is only pricked does not tear. The wall below
    /// stays as strong as it is.
    bool pull(int bite, double force, Skin& skin);

    /// Adds bites that are there from the start, drawn through: those of a straight needle that went from `from` to
    /// `to` [m], at each wall on its path. Before the first press().
    void begin_with(const Vec3& from, const Vec3& to, Skin& skin);

    std::span<const Bite> bites() const { return bites_; }              ///< All so far, in the order they were begun.
    std::span<const BiteEvent> events() const { return events_; }       ///< What happened since press().
    Vec3 force() const { return force_; }                               ///< Of the wall on the needle [N].
    bool tip_is_in_wall() const { return crossings_.size() % 2 == 1; }  ///< The needle's is, now.
    int holes_on_needle() const { return static_cast<int>(crossings_.size()); }  ///< How many its wire is in.
    bool touches() const { return touch_.active; }                               ///< The tip dimples or tents a skin.
    const BiteDef& def() const { return def_; }                                  ///< How a needle meets this wall.
    /// Adds the bites, the needle as it was told last and what it touches.
    friend void add_to(sim::geometry::Hash& hash, const Bites& bites);

  private:
    struct Touch {  // of the tip and a skin that it has not pierced
        bool active = false;
        bool inwards = true;          // the tip is outside the wall
        int face = 0;                 // that it touches; none: -1
        Vec3 weights = Vec3::Zero();  // of the point in that face
        Side first_side = Side::outer;
        Vec3 first_normal = Vec3::Zero();     // of the skin where it was first touched
        Vec3 first_direction = Vec3::Zero();  // of the tip when it first touched
        Vec3 tip = Vec3::Zero();  // the needle's; in the step in which the skin gives way, as far as it does [m]
        double force = 0;         // [N]
        double gone = 0;          // how far the tip went in the last step [m]
        double gain = 0;          // how much force that added for each metre [N/m]
        bool gives_way = false;   // the skin does, in this step
        bool is_through = false;  // the tip is through a wall that gave way, by less than it takes to pierce
    };
    struct Crossing {  // of the wire and a hole, in the order in which the tip made them
        int bite, hole;
        double along;  // the hole's place on the wire [m]
        double held;   // the place of the wire that friction holds it at [m]
    };

    void let_go();
    void give_rims_to_wire(Skin& skin);
    bool is_outside(int piece) const;
    void press_shaft(const Arc& before, const Skin& skin);
    void settle_shaft(const Skin& skin);
    template <class Push>
    void bulge(const Skin& skin, const Push& push) const;
    void begin_touch(const Vec3& tip_before, const Skin& skin);
    void touch_at(const Skin& skin, const Skin::Spot& spot);
    Skin::Spot behind_tip(const Skin& skin) const;
    int hole_behind_tip(const Skin& skin) const;
    void advance_touch();
    bool stays(const Skin& skin);
    bool goes_through(const Skin& skin);
    void slide_touch(const Skin& skin);
    Vec3 direction_of_touch(const Skin& skin) const;
    Vec3 touch_force(const Skin& skin) const;  // on the wall
    void settle_touch(Skin& skin);
    void follow(const Skin& skin);
    double friction_of(std::size_t crossing) const;
    Vec3 aside(const Crossing& crossing, const Skin& skin) const;
    void hold(std::size_t crossing, const Skin& skin);
    void cross(const Skin& skin, int hole, bool inwards, const Vec3& normal, const Vec3& direction, double force);
    void leave_by_tip();
    bool is_at_last_hole() const;
    void leave_by_tail();
    void measure(const Skin& skin);
    Triangle cut_face(int face) const;
    double from_cut(const MaterialPoint& point) const;
    Vec3 slit(const BiteEnd& end, Skin& skin) const;
    void slit(const Bite& bite, Skin& skin) const;
    void tear(int bite, double force);
    bool is_entry(std::size_t crossing) const { return crossing % 2 == 0; }
    Bite& of(const Crossing& crossing) { return bites_[static_cast<std::size_t>(crossing.bite)]; }

    BiteDef def_;
    CapsuleContact shaft_;
    Mesh rest_;
    std::vector<Rim> outer_, inner_;  // of its cut
    std::vector<int> cut_;            // faces of its cut
    Arc needle_;                      // as it was told last
    bool has_needle_ = false;
    int passes_ = 0;  // so far
    Touch touch_;
    Vec3 slipped_at_ = Vec3::Constant(std::numeric_limits<double>::infinity());  // the tip, when it last slipped [m]
    std::vector<Crossing> crossings_;
    std::vector<Bite> bites_;
    std::vector<BiteEvent> events_;   // since press()
    std::vector<PointForce> forces_;  // since press()
    Vec3 force_ = Vec3::Zero();       // on the needle [N]
    std::vector<double> pulls_;       // scratch: of the needle at its holes [N]
    std::vector<Skin::Wire> wires_;   // scratch: the needle in its holes
};

}  // namespace tissue
