#pragma once
#include <array>
#include <span>
#include <vector>

#include "sim/geometry/hash.hpp"
#include "tissue/block_matrix.hpp"
#include "tissue/cells.hpp"
#include "tissue/descent.hpp"
#include "tissue/laplacian.hpp"
#include "tissue/material.hpp"
#include "tissue/mesh.hpp"

namespace tissue {

/// A node that goes where it is put, or slides on the planes or lines across the axes along which it is not held.
struct Hold {
    int node;                                     ///< Which.
    Vec3 target;                                  ///< Where it is put [m].
    std::array<bool, 3> along{true, true, true};  ///< Which axes it is held along.
};

/// A force at a point of the wall: the same throughout a step, or falling as the point gives way, as what presses or
/// pulls it does (a tool's side, a thread's tension, a needle). With the whole stiffness of what pushes, that is met
/// however stiff it is and long the step.
struct PointForce {
    MaterialPoint at;      ///< Where it acts.
    Vec3 force;            ///< With the point where it is at the step's start [N].
    double stiffness = 0;  ///< By how much it falls for each metre that the point goes from there in the step [N/m].
    /// Direction in which the stiffness counts, unit, so that what slides across is not held back; zero: in all.
    Vec3 along = Vec3::Zero();

    /// By how much the force has fallen when the point has gone so far [N].
    Vec3 lost(const Vec3& gone) const { return stiffness * (along.isZero(0) ? gone : Vec3(along.dot(gone) * along)); }
};

/// What acts on a wall during one step.
struct Input {
    std::span<const Hold> holds = {};         ///< Each node at most once.
    std::span<const PointForce> forces = {};  ///< Any number.
    double pressure = 0;                      ///< On inner faces, outwards [Pa]; where a tube ends it is open.
};

/// How a step is solved.
struct Solver {
    int iterations = 1;  ///< Moves in a step, at least 1.
    /// Over how many steps a factorisation is spread; 0: all of it before each move, which is Newton's method.
    int steps_per_factor = 8;
    double tolerance = 0;  ///< A step ends once no node is out of balance by more than this [N].
};

/// What a step came to.
struct Report {
    int iterations = 0;        ///< Moves that it made.
    double residual = 0;       ///< Largest force on a node that was out of balance before the last move [N].
    double energy_change = 0;  ///< Of the last move, damping included [J]: never above 0.
};

/// A vessel's wall that gives way: nearly incompressible, neo-Hookean and viscous, without inertia, in steps of
/// implicit Euler. A step goes down the energy with what the damping takes, from where the wall is, along Newton's
/// direction of a stiffness that is some steps old, to the lowest point on the line, which is that of a polynomial. So
/// the wall's energy less the work of steady forces never rises, however long the step and old the stiffness; what a
/// step leaves undone is the next one's. Deterministic; nothing is allocated after the first step, with up to as many
/// forces as faces.
class Tissue {
  public:
    /// `mesh` must have tetrahedra, of positive volume, in cells of at most eight nodes and six tetrahedra.
    Tissue(const Material& material, Mesh mesh, const Solver& solver = {});

    /// One step of so many seconds, above 0; infinite: without damping. Nodes and tetrahedra in `input` must exist, its
    /// numbers must be finite.
    Report step(const Input& input, double seconds);

    const Mesh& rest() const { return rest_; }              ///< As it is when nothing pulls at it.
    const Material& material() const { return material_; }  ///< What it is made of.
    std::span<const Vec3> nodes() const { return x_; }      ///< Where they are [m].
    std::span<const Vec3> velocity() const { return v_; }   ///< Of the nodes in the last step [m/s].
    Vec3 position(const MaterialPoint& point) const;        ///< Where a point of the wall is [m].
    double energy() const;                                  ///< Elastic [J].
    /// What a held node was pulled with before the last move [N].
    Vec3 hold_force(int node) const { return -residual_[static_cast<std::size_t>(node)]; }
    /// Puts nodes elsewhere [m], at rest, one entry for each; the next step finds the stiffness of the new shape.
    void place(std::span<const Vec3> nodes);
    /// Adds all that is carried from step to step, which is not what the wall is made of.
    friend void add_to(sim::geometry::Hash& hash, const Tissue& wall);

  private:
    void apply_holds(std::span<const Hold> holds);
    void add_forces(std::span<const PointForce> forces);
    void add_pressure(double pressure);
    Vec3 carried(const MaterialPoint& point, std::span<const Vec3> by_nodes) const;
    Lane pressure(std::size_t cells) const { return material_.bulk() * swelling_[cells] - Lane(material_.shear()); }
    void find_residual();
    void go_along_direction(double far);
    void find_direction(bool afresh);
    void find_strain();
    void soften(std::span<const Vec3> force, std::vector<Vec3>& to);
    void add_lost(std::span<const PointForce> forces, double times, std::span<const Vec3> gone,
                  std::vector<Vec3>& to) const;
    void find_solved();
    Descent energy_along_direction();
    void begin_factor();
    void go_on_factoring(long work);
    void factor_at_once();
    void add_stiffness(const PointForce& force);
    void add_block(int i, int j, BlockMatrix::Place place, const BlockMatrix::Block& whole);
    void add_block(int i, int j, BlockMatrix::Place place, const Vec3& a, const Vec3& b, const Vec3& w);
    void assemble_node(int node);
    void assemble_cells(std::size_t cells);
    long assembly_work() const;

    // What never changes.
    Mesh rest_;
    Material material_;
    Solver solver_;
    Laplacian laplacian_;
    std::vector<Cells> cells_;
    std::vector<double> mass_;  // of nodes [kg]
    std::vector<std::array<std::array<BlockMatrix::Place, Cells::most_pairs>, Cells::lanes>> cell_places_;  // of pairs
    std::vector<std::array<std::array<BlockMatrix::Place, Cells::most_nodes>, Cells::lanes>> own_places_;   // of nodes
    std::vector<std::vector<BlockMatrix::Place>> row_places_;  // of a node and its neighbours

    // What is carried from step to step.
    std::vector<Vec3> x_;              // nodes [m]
    std::vector<Vec3> v_;              // their velocities [m/s]
    std::vector<Vec3> residual_;       // what nodes were out of balance by before the last move [N]
    std::vector<Vec3> direction_;      // in which nodes went in the last move
    std::vector<Vec3> last_residual_;  // on free nodes, before the last move [N]
    double last_product_ = 0;          // of that with the solution for it
    std::vector<Lane> swelling_;       // J - 1 of cells

    // The stiffness: what solves use, and the next one, as far as it has come.
    BlockMatrix matrix_;
    std::vector<PointForce> used_stiff_;  // forces whose stiffness is in what solves use
    std::vector<Volumes> used_volumes_;   // of cells, when that was found
    std::vector<PointForce> factored_stiff_;
    std::vector<Volumes> factored_volumes_;
    std::vector<Vec3> factored_x_, factored_free_;  // the state that is being factored
    double factored_rate_ = 0, factored_drag_ = 0;
    std::vector<Lane> factored_pressure_;
    std::size_t assembled_ = 0;  // nodes and cells of it so far
    bool factoring_ = false;     // a factorisation is under way
    bool have_factors_ = false;  // there are some that solves can use
    bool whole_ = true;          // it is of the whole stiffness, not without the part that can be negative

    // Scratch of one step.
    double rate_ = 0;                          // steps a second [1/s]
    double drag_ = 0;                          // what a unit of mass resists a step with [1/s^2]
    std::vector<Vec3> before_;                 // nodes as the step began [m]
    std::vector<Vec3> free_;                   // 1 along axes on which a node is free, 0 where it is held
    std::vector<Vec3> outside_;                // forces from outside [N]
    std::vector<PointForce> stiff_;            // those of the step's forces that fall as points go
    std::vector<Vec3> lx_;                     // L times nodes [m^2]
    std::vector<Vec3> lx_before_;              // L times nodes as the step began [m^2]
    std::vector<Vec3> ldirection_;             // L times the direction
    std::vector<Vec3> free_residual_;          // what of the residual is on free nodes [N]
    std::vector<Vec3> solved_;                 // the stiffness' solution for it
    std::vector<Vec3> left_, next_, pull_;     // conjugate gradients: residual, direction, stiffness times direction
    std::vector<Vec3> factored_pull_;          // and what is factored times that direction
    std::vector<Volumes> volumes_;             // of cells
    std::vector<std::array<Lane, 3>> along_;   // coefficients of cells' volumes along the direction
    std::vector<std::array<Lane, 3>> strain_;  // how the wall about nodes is deformed since the stiffness, by columns
    std::vector<double> shared_;               // volume of the cells that share a node [m^3]
};

}  // namespace tissue
