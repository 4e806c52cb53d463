#pragma once
#include <array>
#include <span>
#include <vector>

#include "tissue/block_matrix.hpp"
#include "tissue/cells.hpp"
#include "tissue/descent.hpp"
#include "tissue/laplacian.hpp"
#include "tissue/material.hpp"
#include "tissue/mesh.hpp"

namespace tissue {

/// A node that goes where it is put, or slides on the planes or lines across the axes along which it is not held.
struct Hold {
    int node;
    Vec3 target;                                  ///< [m]
    std::array<bool, 3> along{true, true, true};  ///< Which axes it is held along.
};

/// A force at a point of the wall: the same throughout a step, or falling as the point gives way, as what presses or
/// pulls it does (a tool's side, a thread's tension, a needle). With the whole stiffness of what pushes, that is met
/// however stiff it is and long the step.
struct PointForce {
    MaterialPoint at;
    Vec3 force;                 ///< Where the point was at the step's start [N].
    double stiffness = 0;       ///< So much less for each metre that it goes from there in the step [N/m].
    Vec3 along = Vec3::Zero();  ///< Unit: the stiffness is of this way alone, what slides across is not held back;
                                ///< zero: of all ways.

    Vec3 lost(const Vec3& gone) const {
        return stiffness * (along.isZero(0) ? gone : Vec3(along.dot(gone) * along));
    }  ///< [N]
};

/// What acts on a wall during one step.
struct Input {
    std::span<const Hold> holds = {};  ///< Each node once.
    std::span<const PointForce> forces = {};
    double pressure = 0;  ///< On inner faces, outwards [Pa]; where a tube ends it is open.
};

/// How a step is solved.
struct Solver {
    int iterations = 1;  ///< Moves a step.
    int steps_per_factor =
        8;  ///< A factorisation is spread over so many steps; 0: all of it before each move, which is Newton's method.
    double tolerance = 0;  ///< No more moves once no node is out of balance by more [N].
};

/// What a step came to.
struct Report {
    int iterations = 0;
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

    /// Nodes, tetrahedra and numbers in `input` must exist and be finite. With seconds infinite there is no damping.
    Report step(const Input& input, double seconds);

    const Mesh& rest() const { return rest_; }
    const Material& material() const { return material_; }
    std::span<const Vec3> nodes() const { return x_; }     ///< [m]
    std::span<const Vec3> velocity() const { return v_; }  ///< [m/s]
    Vec3 position(const MaterialPoint& point) const;       ///< [m]
    double energy() const;                                 ///< Elastic [J].
    Vec3 hold_force(int node) const {
        return -residual_[static_cast<std::size_t>(node)];
    }  ///< What it was pulled with before the last move [N].
    /// Puts nodes elsewhere, at rest; the stiffness is that of the new shape at the next step.
    void place(std::span<const Vec3> nodes);

  private:
    void apply_holds(std::span<const Hold> holds);
    void add_forces(std::span<const PointForce> forces);
    void add_pressure(double pressure);
    Vec3 carried(const MaterialPoint& point, std::span<const Vec3> by_nodes) const;
    Lane pressure(std::size_t cells) const { return material_.bulk() * swelling_[cells] - Lane(material_.shear()); }
    void find_residual();
    void go_along_way(double far);
    void find_way(bool afresh);
    void find_strain();
    void soften(std::span<const Vec3> push, std::vector<Vec3>& to);
    void add_lost(std::span<const PointForce> forces, double times, std::span<const Vec3> way,
                  std::vector<Vec3>& to) const;
    void find_solved();
    Descent energy_along_way();
    void begin_factor();
    void go_on_factoring(long work);
    void factor_at_once();
    void add_stiffness(const PointForce& force);
    void add_block(int i, int j, BlockMatrix::Place place, const BlockMatrix::Block& whole);
    void add_block(int i, int j, BlockMatrix::Place place, const Vec3& a, const Vec3& b, const Vec3& w);
    void assemble_node(int node);
    void assemble_cells(std::size_t cells);
    long assembly_work() const;

    Mesh rest_;
    Material material_;
    Solver solver_;
    Laplacian laplacian_;
    std::vector<Cells> cells_;
    std::vector<double> mass_;  // of nodes [kg]
    std::vector<Vec3> x_, v_, before_;
    std::vector<Vec3> free_, outside_;  // 1 along axes on which a node is free, 0 where held; forces from outside
    std::vector<PointForce> stiff_, factored_stiff_,
        used_stiff_;  // of the step's forces, of what is being factored, of what solves are with
    std::vector<Vec3> lx_, lx_before_, lway_;                       // L times nodes, and times the way
    std::vector<Vec3> residual_, push_, way_, last_push_, solved_;  // push: what of the residual is on free nodes
    std::vector<Vec3> left_, next_, along_way_, pull_;              // of a solve with other forces than are factored
    std::vector<Volumes> volumes_;
    std::vector<Lane> swelling_;              // J - 1 of cells
    std::vector<std::array<Lane, 3>> along_;  // coefficients of the volume along the way
    double rate_ = 0, drag_ = 0;              // steps a second, and what a unit of mass resists a step with [1/s^2]
    double last_product_ = 0;

    BlockMatrix matrix_;
    std::vector<std::array<std::array<BlockMatrix::Place, Cells::most_pairs>, Cells::lanes>> cell_places_;
    std::vector<std::array<std::array<BlockMatrix::Place, Cells::most_nodes>, Cells::lanes>> own_places_;
    std::vector<std::vector<BlockMatrix::Place>> row_places_;
    std::vector<Vec3> factored_x_, factored_free_;  // the state that is being factored
    double factored_rate_ = 0, factored_drag_ = 0;
    std::size_t assembled_ = 0;  // nodes and cells
    std::vector<Lane> factored_pressure_;
    std::vector<Volumes> factored_volumes_, used_volumes_;  // of that state, and of the one that solves are with
    std::vector<std::array<Lane, 3>> strain_;  // how the wall about nodes is deformed since then, by columns
    std::vector<double> shared_;               // volume of the cells that share a node
    bool factoring_ = false, have_factors_ = false, whole_ = true;
};

}  // namespace tissue
