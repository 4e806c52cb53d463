#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/geometry/vec.hpp"
#include "sim/thread/band.hpp"
#include "sim/thread/thread.hpp"

namespace sim::thread {

/// What an elastic thread is made of. SI.
struct RodDef {
    double radius = 0.0425e-3;       ///< [m]
    double young = 2.8e9;            ///< Young's modulus [Pa].
    double poisson = 0.5;            ///< Poisson's ratio, of the twist alone.
    double friction = 0.15;          ///< Coulomb, against bodies.
    double density = 905;            ///< [kg/m^3]; 0: without inertia, every step ends in equilibrium.
    /// Axial stiffness of a link over its bending stiffness, EA h^2 / B: practically inextensible. 0: that of the material, which
    /// is 4 (h / radius)^2 and stretches a suture by a twentieth at a newton.
    double axial_over_bending = 1e4;
    Vec3 gravity = Vec3::Zero();     ///< [m/s^2]

    double bending_stiffness() const;   ///< B = E I [N m^2].
    double twisting_stiffness() const;  ///< C = B / (1 + poisson) [N m^2].
    double axial_stiffness(double link) const;  ///< [N], of links of this length.
    double mass_per_length() const;     ///< [kg/m]
};

/// What acts on a rod during one step.
struct RodInput {
    std::span<const Hold> holds;             ///< Nodes that go where they are put.
    std::span<const Vec3> loads = {};        ///< Force on each node [N], or none.
    std::span<const MovingCapsule> bodies = {};  ///< What nodes rest on and slide over, the same ones in every step.
    /// How far the cross-section of the last link has been turned against that of the first about the rod, beyond what they
    /// were made with [rad]; nothing where one of them is free to turn, and the rod carries no twist.
    std::optional<double> turn = {};
    /// Force that may stay unbalanced at a node [N]; nothing: fifty times what the rounding of its place does to the stiffest link.
    std::optional<double> tolerance = {};
};

/// What a step came to.
struct RodReport {
    int iterations = 0;         ///< Newton steps.
    double residual = 0;        ///< Largest force on a node that is left unbalanced [N].
    bool stable = true;         ///< Any small move would cost energy: it is not about to buckle.
    bool settled = true;        ///< Stable, and balanced within the tolerance.
};

/// A bending, twisting, practically inextensible rod: discrete elastic rods (Bergou, Wardetzky, Robinson, Audoly and Grinspun 2008)
/// of round cross-section, straight and untwisted when unloaded. Twist spreads evenly at once, as it does in so thin a rod
/// (their section 5), so that nodes alone are unknown. One step of implicit Euler, by Newton's method on its energy with a direct
/// banded solve: stable at any step and any stiffness. Cost: O(n) an iteration.
class Rod {
  public:
    /// Nodes at `nodes` [m], at least 3; rest lengths are the distances between them.
    Rod(const RodDef& def, std::vector<Vec3> nodes);

    /// Everything in `input` must be finite and nodes exist; the caller sees to that. Allocates.
    /// One step of `seconds`, or with density 0 or no time to the equilibrium, in at most `most` iterations; with none it only says
    /// whether the rod is in one, and a stable one.
    RodReport step(const RodInput& input, double seconds, int most = 20);

    const RodDef& def() const { return def_; }
    std::span<const Vec3> nodes() const { return now_.nodes; }
    std::span<const double> rest_lengths() const { return rest_; }
    double tension(int link) const;        ///< [N], negative where it is pushed together.
    double twist_moment() const;           ///< [N m], the same all along.
    Vec3 hold_force(int node) const;       ///< What a hold pulled with in the last step [N].
    double twist() const { return now_.twist; }  ///< Of the last link against the first along the rod, its writhe taken off [rad].

    /// A node and a body that are near each other.
    struct Touch {
        int node, body;
        double push;          ///< [N] along the normal.
        Vec3 anchor;          ///< Where it would come to rest without other forces [m].
        double limit = 0;     ///< Of its friction in this step [N].
    };
    std::span<const Touch> touches() const { return now_.touches; }

  private:
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
    double energy(const std::vector<Vec3>& x) const;
    /// All of it, or what is positive of it whatever the shape: without how forces turn with the nodes.
    enum class Stiffness { whole, positive };
    void assemble(Stiffness stiffness);
    void add_stretch(Stiffness stiffness);
    void add_bending(Stiffness stiffness);
    void add_twist();
    void find_twist_gradient();
    Stiffness factor();
    std::vector<Vec3> newton_step();
    void spread_between_held(std::vector<Vec3>& x) const;
    double unbalanced() const;
    bool foresaw_tensions();
    bool go(const std::vector<Vec3>& way);
    void bring_to(const std::vector<double>& lengths, std::vector<Vec3>& x);
    void accept(const std::vector<Vec3>& x);

    RodReport step_in_parts(const RodInput& input, double seconds, int most, int halvings);
    RodReport try_step(const RodInput& input, double seconds, int most);

    RodDef def_;
    std::vector<double> rest_, mass_;      // per link [m], per node [kg]
    double twisted_length_ = 0;            // [m]
    double softest_ = 0, stiffest_ = 0;    // [N/m] added to every node, and of a link against stretch
    double stiff_ = 0;                     // [N/m] of contact

    /// What a step starts from.
    struct Moving {
        std::vector<Vec3> nodes, velocity;
        std::vector<double> tension;       // foreseen [N]
        std::array<Vec3, 2> directors;     // across the first and the last link
        double turned = 0, twist = 0;      // of the directors along the rod, and with what the ends were turned [rad]
        std::vector<Touch> touches;
    } now_;

    // Of the step that is being made.
    std::vector<Vec3> aim_, loads_, force_, gradient_;
    std::vector<char> held_;
    std::optional<double> turn_;
    double inertia_ = 0;                   // [1/s^2]
    std::vector<MovingCapsule> bodies_;
    Band band_, whole_;
};

}  // namespace sim::thread
