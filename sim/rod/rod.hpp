#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/geometry/moving.hpp"
#include "sim/rod/chain_matrix.hpp"
#include "sim/rod/rod_def.hpp"

namespace sim::rod {

using geometry::Capsule;
using geometry::Hold;
using geometry::MovingCapsule;
using geometry::Vec3;

/// What acts on a rod during one step.
struct RodInput {
    std::span<const Hold> holds;       ///< Nodes that go where they are put.
    std::span<const Vec3> loads = {};  ///< Force on each node [N], or none.
    /// What nodes rest on and slide over, the same ones in every step; in step() alone.
    std::span<const MovingCapsule> bodies = {};
    /// Angle by which the cross-section of the last link has been turned against that of the first about the rod,
    /// beyond what they were made with [rad]; nothing where one of them is free to turn, and the rod carries no twist.
    std::optional<double> turn = {};
    /// Force that may stay unbalanced at a node [N]; nothing: fifty times what the rounding of its place does to the
    /// stiffest link.
    std::optional<double> tolerance = {};
    /// Whether each node stays where it is, as held nodes do that go nowhere; or none.
    std::span<const char> asleep = {};
};

/// A force between two points of the rod, or on a point of it.
struct Pair {
    std::array<int, 4> node{};       ///< The points lie apart by the sum of weight * node, and what is not the rod's.
    std::array<double, 4> weight{};  ///< Share of each node in its point, -1..1; negative for the other point's nodes.
    int nodes = 0;                   ///< How many entries of `node` and `weight` count, 0 to 4.
    Vec3 force = Vec3::Zero();       ///< Force on the point of positive weight [N]; the other bears the opposite.
};

/// A link that rolls on what it is pressed against: turning it towards the normal moves where it touches, and that
/// turns it back.
struct Rolling {
    int link;       ///< Counted along the rod from 0.
    Vec3 normal;    ///< The direction in which the link is pushed off, unit.
    double moment;  ///< What a turn towards the normal by 1 rad turns it back with [N m].
};

/// What a step came to.
struct RodReport {
    int iterations = 0;   ///< Newton iterations made.
    double residual = 0;  ///< Largest force on a node that is left unbalanced [N].
    /// Whether any small move would cost energy, so that the rod is not about to buckle. It is judged as if its natural
    /// bends were straight: false does not mean that a rod which keeps sharp bends would move.
    bool stable = true;
    bool settled = true;  ///< Stable, and balanced within the tolerance.
};

/// A bending, twisting, practically inextensible rod: discrete elastic rods (Bergou, Wardetzky, Robinson, Audoly and
/// Grinspun 2008) of round cross-section, untwisted when unloaded, and straight but for what RodDef keeps. Twist
/// spreads evenly at once, as it does in so thin a rod (their section 5), so that nodes alone are unknown. One step of
/// implicit Euler, by Newton's method on its energy with a direct solve (ChainMatrix): stable at any step and any
/// stiffness. Cost: O(n) an iteration, and O(m^3) for m nodes that touch.
class Rod {
  public:
    /// Nodes at `nodes` [m], at least 3; rest lengths are the distances between them.
    Rod(const RodDef& def, std::vector<Vec3> nodes);

    /// Makes one step of `seconds` [s], or with density 0 or no time goes to the equilibrium, in at most `most`
    /// iterations; with none it only says whether the rod is in an equilibrium, and a stable one. The caller keeps
    /// everything in `input` finite and its nodes in range.
    RodReport step(const RodInput& input, double seconds, int most = 20);

    /// Begins a step in stages, for a caller that knows what the rod touches: begin(), find_free_step(), add_forces()
    /// and go_by() as often as needed, end(). `input.holds` say which nodes are held.
    void begin(const RodInput& input, double seconds);
    /// Finds the Newton step to where the rod and these forces balance to first order, with held nodes going to
    /// `targets`.
    void find_free_step(std::span<const Hold> targets, std::span<const Pair> pairs, std::span<const Rolling> rolling);
    /// The stiffness matrix of the step that was found last [N/m]; its inverse is what unit forces on nodes move them
    /// by.
    ChainMatrix& matrix() { return matrix_; }
    /// The step found so far, one displacement a node [m].
    std::span<const Vec3> step_found() const { return newton_; }
    /// Adds to the step what these forces change about it, one force a node [N]; those on held nodes do nothing.
    void add_forces(const std::vector<Vec3>& forces);
    /// The largest share of the step, 0..1, that pulls or pushes no link harder than `most` [N], or than it is already.
    double share_within(double most);
    /// Makes this share of the step, or what of it turns no link by more than 0.3 rad and leaves every node within
    /// `bound` [m] of where it is in `from`; returns the share made, 0 where none will do.
    double go_by(double share, std::span<const Vec3> from, std::span<const double> bound);
    /// Ends a step in stages: finds velocities and, where fibres yield, natural bends.
    void end();

    /// Between steps: makes a link two at `share` of it, 0..1. Call resize() after the last change of links.
    void split(std::size_t link, double share);
    /// Between steps: leaves out the nodes between these two and puts a cut, a link of length 0, in their place. Call
    /// resize() after the last change of links. A rod that is cut goes by stages alone and carries no twist.
    void leave_out(std::size_t first, std::size_t second);
    /// Between steps: makes the two links that meet at a node one; the node goes. Call resize() after the last change
    /// of links.
    void join_at(std::size_t node);
    /// Brings masses and stiffnesses to the links as they are, after they have changed. O(n).
    void resize();
    /// Makes room for so many links, so that steps and changes of links allocate nothing.
    void reserve(std::size_t links);

    /// What the rod is made of.
    const RodDef& def() const { return def_; }
    /// The n + 1 nodes [m], world frame.
    std::span<const Vec3> nodes() const { return now_.nodes; }
    /// The n + 1 nodes' velocities [m/s], world frame.
    std::span<const Vec3> velocity() const { return now_.velocity; }
    /// The n links' lengths when nothing pulls [m]; 0 of a cut.
    std::span<const double> rest_lengths() const { return rest_length_; }
    /// What each node bends by when unloaded, as the difference of its links' tangents, 0 to 2; n + 1 numbers.
    std::span<const double> natural_bends() const { return natural_; }
    /// The pull that a link bears [N], negative where it is pushed together; 0 of a cut.
    double tension(int link) const;
    /// The moment that twist carries [N m], the same all along.
    double twist_moment() const;
    /// What the hold of a node pulled with in the last step [N].
    Vec3 hold_force(int node) const;
    /// Angle of the last link's cross-section against the first's along the rod, its writhe taken off [rad].
    double twist() const { return now_.twist; }

    /// A node and a body that are near each other.
    struct Touch {
        int node;          ///< Counted along the rod from 0.
        int body;          ///< Index into RodInput::bodies.
        double push;       ///< Force along the normal [N].
        Vec3 anchor;       ///< Where the node would come to rest without other forces [m].
        double limit = 0;  ///< The most that friction carries in this step [N].
    };
    /// The nodes within a diameter of a body, as the last step ended.
    std::span<const Touch> touches() const { return now_.touches; }

    /// Calls visit(number) for every number that a step starts from: shape, speed, tensions, twist, touches and what it
    /// is when unloaded, always in the same order.
    template <class Visit>
    void for_all_carried(Visit visit) const;

  private:
    /// All of it, or what is positive of it whatever the shape: without how forces turn with the nodes.
    enum class Keep { whole, positive };
    struct Link {
        Vec3 along;     // unit tangent
        double length;  // [m]
        // Of the energy: its derivative by this link's vector, and its second derivative own I + aside along^T + along
        // aside^T.
        Vec3 pull, aside;
        double own;
    };
    bool is_cut(std::size_t link) const { return rest_length_[link] == 0; }
    bool can_give(std::size_t link) const { return !is_cut(link) && !(held_[link] && held_[link + 1]); }
    static void measure(const std::vector<Vec3>& x, std::vector<Link>& links);
    double energy_of(const std::vector<Link>& links) const;

    Vec3 from_axis(const Touch& touch, const Vec3& x) const;
    /// Of a touch with its node at x: what it pushes with [N] and where to, and how far it slipped from its anchor [m].
    struct Pressed {
        double push;
        Vec3 normal, slip;
    };
    Pressed pressed(const Touch& touch, const Vec3& x) const;
    void find_touches(std::span<const MovingCapsule> bodies);
    void add_contact();
    double contact_energy(const std::vector<Vec3>& x) const;
    void settle_touches();
    std::array<Vec3, 2> directors_at(const std::vector<Vec3>& x) const;
    Vec3 along_rod(Vec3 across, const std::vector<Vec3>& x) const;
    double twist_at(const std::vector<Vec3>& x) const;
    double energy(const std::vector<Vec3>& x, std::vector<Link>& links);
    void assemble(Keep keep, std::span<const Pair> pairs = {}, std::span<const Rolling> rolling = {});
    void add_stretch(Keep keep);
    void add_bending(Keep keep);
    ChainMatrix::Block cross(std::size_t link) const;
    void spread_to_nodes();
    void add_twist();
    void find_twist_gradient();
    void add_pairs(std::span<const Pair> pairs);
    void add_rolling(std::span<const Rolling> rolling);
    Keep factor();
    void find_newton_step();
    double unbalanced() const;
    bool foresaw_tensions();
    void lead(std::span<const Hold> targets);
    bool is_settled(RodReport& report);
    double improve();
    void spread_between_held(std::vector<Vec3>& x) const;
    double largest_turn() const;
    bool pulls_within(const std::vector<Vec3>& x) const;
    void foresee_tensions();
    void try_share(double share);
    void take_trial(double share);
    double go();
    void bring_to(const std::vector<double>& lengths, std::vector<Vec3>& x);
    void find_excess(const std::vector<double>& lengths, const std::vector<Vec3>& x);
    void share_between_held(const std::vector<Vec3>& x);
    void share_excess(std::size_t first, std::size_t past, double apart);
    void shorten(std::vector<Vec3>& x);
    void accept(const std::vector<Vec3>& x);

    void find_inert();
    void find_velocity();
    void take_set();
    void hand_on_natural_bend(std::size_t node);
    RodReport step_in_parts(const RodInput& input, double seconds, int most, int halvings);
    RodReport try_step(const RodInput& input, double seconds, int most);

    RodDef def_;
    std::vector<double> rest_length_, mass_;  // per link [m], per node [kg]
    std::vector<double> inert_;               // what of the mass has inertia in this step [kg]
    std::vector<double> natural_;             // bend of an unloaded node, as the difference of tangents
    double twisted_length_ = 0;               // [m]
    double softest_ = 0, stiffest_ = 0;       // [N/m] added to every node, and of a link against stretch
    double stiff_ = 0;                        // [N/m] of contact

    /// What a step starts from.
    struct Moving {
        std::vector<Vec3> nodes, velocity;
        std::vector<double> tension;    // foreseen [N]
        std::array<Vec3, 2> directors;  // across the first and the last link
        double turned = 0, twist = 0;   // of the directors along the rod, and with what the ends were turned [rad]
        std::vector<Touch> touches;
    } now_;

    // Of the step that is being made.
    std::vector<Vec3> due_;  // displacements of held nodes, where there are any [m]
    std::vector<Vec3> start_, led_, aim_, loads_, force_, gradient_, newton_, spread_, trial_;
    std::vector<char> held_;
    std::optional<double> turn_;
    double inertia_ = 0;  // [1/s^2]
    std::vector<MovingCapsule> bodies_;
    double seconds_ = 0, tolerance_ = 0;
    std::vector<Link> links_, tried_;
    std::vector<double> foreseen_, lengths_, pivot_, upper_, shorten_;
    ChainMatrix matrix_;
};

template <class Visit>
void Rod::for_all_carried(Visit visit) const {
    const auto visit_vector = [&](const Vec3& v) { visit(v.x()), visit(v.y()), visit(v.z()); };
    for (const auto* of_nodes : {&now_.nodes, &now_.velocity})
        for (const Vec3& v : *of_nodes) visit_vector(v);
    for (const auto* numbers : {&rest_length_, &natural_, &now_.tension})
        for (const double number : *numbers) visit(number);
    for (const Vec3& director : now_.directors) visit_vector(director);
    visit(now_.turned), visit(now_.twist);
    for (const Touch& touch : now_.touches) {
        visit(touch.node), visit(touch.body), visit(touch.push), visit(touch.limit);
        visit_vector(touch.anchor);
    }
}

}  // namespace sim::rod
