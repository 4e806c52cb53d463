#include "tissue/tissue.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "tests/bench/lab/tissue_cases.hpp"
#include "tests/bench/lab/tissue_pull.hpp"
#include "tissue/tube.hpp"

namespace {

using namespace tissue;

constexpr double tick = 1e-3, in_the_end = std::numeric_limits<double>::infinity();

std::vector<Hold> far_end_held(const Mesh& mesh) {
    std::vector<Hold> holds;
    std::vector<bool> known(mesh.nodes.size());
    for (const Face& face : mesh.faces)
        for (const int i : face.nodes)
            if (face.side == Side::far_end && !known[static_cast<std::size_t>(i)]) {
                known[static_cast<std::size_t>(i)] = true;
                holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
            }
    return holds;
}

// In the middle of the wall of the cell that begins at the cut, next to the plane z = 0.
MaterialPoint at_the_cut() {
    return {0, {0.25, 0.25, 0.25, 0.25}};
}

double smallest_volume(const Tissue& tissue) {
    double least = 1;
    for (const Tetrahedron& tet : tissue.rest().tetrahedra)
        least = std::min(least, volume(tet, tissue.nodes()) / volume(tet, tissue.rest().nodes));
    return least;
}

double farthest_from_rest(const Tissue& tissue) {
    double most = 0;
    for (std::size_t i = 0; i < tissue.nodes().size(); ++i)
        most = std::max(most, (tissue.nodes()[i] - tissue.rest().nodes[i]).norm());
    return most;
}

const Solver newton{.iterations = 50, .steps_per_factor = 0, .tolerance = 1e-10};  // a billionth of the loads here [N]

// D19. What is left is what the wall's volume gives way.
TEST(Material, FollowsANeoHookeanInThePatchTests) {
    using bench::lab::Deformation;
    for (const double stretch : {0.8, 0.9, 1.05, 1.1, 1.2, 1.3, 1.5, 2.0})
        for (const Deformation mode : {Deformation::uniaxial, Deformation::equibiaxial, Deformation::pure_shear}) {
            SCOPED_TRACE(testing::Message() << stretch << " " << static_cast<int>(mode));
            EXPECT_LE(std::abs(bench::lab::patch_stress(mode, stretch).error()), 0.02);
        }
}

// D17 and D18; `carrel bench tissue` has all of their loads.
TEST(Material, FillsAndStretchesTubesAsTheoryHasIt) {
    for (const double axial : {1.0, 1.2})
        EXPECT_LE(std::abs(bench::lab::inflated_radius({}, 1.3, axial).error()), 0.05);
    EXPECT_LE(std::abs(bench::lab::clamped_force({}, 1.2).error()), 0.05);
}

// E22: cells a hundred times as long as thick, or as thick as long; vessels of 1 and of 20 mm.
TEST(Material, FillsTubesOfThinCellsAndOfAnySize) {
    for (const double aspect : {0.01, 100.0})
        for (const double scale : {0.2, 4.0}) {
            SCOPED_TRACE(testing::Message() << aspect << " " << scale);
            EXPECT_LE(std::abs(bench::lab::inflated_radius({.aspect = aspect, .scale = scale}, 1.3, 1).error()), 0.1);
        }
}

// Where each tetrahedron keeps its own volume, a wall can hardly bend.
TEST(Material, DoesNotLock) {
    using bench::lab::VesselPull;
    constexpr double force = 0.02;
    const auto moved = [&](double finer, bool locks) {
        return bench::lab::pulled(VesselPull(bench::lab::vessel(finer), locks), force).edge;
    };
    const Vec3 finer = moved(1.5, false);
    EXPECT_LE((moved(1, false) - finer).norm(), 0.05 * finer.norm());
    EXPECT_GE((moved(1, true) - finer).norm(), 0.15 * finer.norm());
}

TEST(Tissue, StaysAtRestWhereNothingPulls) {
    const Mesh mesh = make_tube({});
    Tissue tissue({}, mesh);
    for (int i = 0; i < 100; ++i) tissue.step({}, tick);
    EXPECT_LE(farthest_from_rest(tissue),
              1e-9 * mesh.nodes.back().norm());         // rounding adds up where nothing holds a tube
    const double wall = 3.14 * 3.5e-3 * 0.5e-3 * 8e-3;  // [m^3]
    EXPECT_NEAR(tissue.energy(), 0, 1e-12 * tissue.material().shear() * wall);
}

// Tube and load turned together: the same answer, turned. Elasticity and damping have no axes of their own.
TEST(Tissue, DoesNotMindHowSpaceIsTurned) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()));
    const auto pulled = [&](bool turned) {
        Mesh mesh = make_tube({.around = 12, .through = 1});
        for (Vec3& p : mesh.nodes) p = turned ? turn * p : p;
        Tissue tissue({}, mesh, newton);
        const std::vector<Hold> holds = far_end_held(mesh);
        const Vec3 force = 0.02 * Vec3(-1, 0.5, 0.2);
        const PointForce forces[] = {{at_the_cut(), turned ? turn * force : force}};
        for (int i = 0; i < 50; ++i) tissue.step({.holds = holds, .forces = forces, .pressure = 1e3}, tick);
        std::vector<Vec3> found;
        for (const Vec3& p : tissue.nodes()) found.push_back(turned ? turn.conjugate() * p : p);
        return found;
    };
    const auto plain = pulled(false), turned = pulled(true);
    double most = 0, moved = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        most = std::max(most, (plain[i] - turned[i]).norm());
        moved = std::max(moved, (plain[i] - make_tube({.around = 12, .through = 1}).nodes[i]).norm());
    }
    EXPECT_GT(moved, 1e-3);
    EXPECT_LE(most, 1e-6 * moved);
}

// Pulled at nodes of its plane of symmetry a tube stays symmetric, for cells are mirrored too.
// Where it is stable: what rounding does to one side is a millionth of what moves. A pull that folds the cut makes more
// of it on the way, and is symmetric where it comes to rest.
TEST(Tissue, KeepsItsPlaneOfSymmetry) {
    const TubeDef def{.around = 12, .through = 1};
    const Mesh mesh = make_tube(def);
    const std::vector<Hold> holds = far_end_held(mesh);
    MaterialPoint node_zero;
    for (int t = static_cast<int>(mesh.tetrahedra.size()) - 1; t >= 0; --t)
        for (std::size_t k = 0; k < 4; ++k)
            if (mesh.tetrahedra[static_cast<std::size_t>(t)][k] == 0) node_zero = {t, {}}, node_zero.weights[k] = 1;
    for (const auto& [pull, steps] : {std::pair{0.005, 100}, {0.02, 1000}}) {
        SCOPED_TRACE(pull);
        Tissue tissue({}, mesh);
        const PointForce forces[] = {{node_zero, {-pull, pull, 0}}};
        for (int i = 0; i < steps; ++i) tissue.step({.holds = holds, .forces = forces}, tick);
        const auto node = [&](int along, int a, int t) {
            return tissue.nodes()[static_cast<std::size_t>((along * def.around + a) * (def.through + 1) + t)];
        };
        EXPECT_GT((node(0, 0, 0) - mesh.nodes[0]).norm(), 1e-3);
        for (int along = 0; along < def.near; ++along)
            for (int a = 0; a < def.around; ++a)
                for (int t = 0; t <= def.through; ++t) {
                    const Vec3 here = node(along, a, t), there = node(along, (def.around - a) % def.around, t);
                    EXPECT_LE((here - Vec3(there.x(), there.y(), -there.z())).norm(), 1e-9);
                }
    }
}

// Steps of a fiftieth of that time err by about as much.
TEST(Tissue, LosesItsStrainInTheTimeOfRelaxation) {
    const Mesh box = make_box({2, 2, 2}, 0.5e-3);
    const Material material;
    Tissue tissue(material, box, newton);
    std::vector<Vec3> drawn;
    for (const Vec3& p : box.nodes) drawn.push_back({1.02 * p.x(), p.y() / std::sqrt(1.02), p.z() / std::sqrt(1.02)});
    tissue.place(drawn);
    for (int i = 0; i < 50; ++i) tissue.step({}, material.relaxation / 50);
    const double strain = (tissue.nodes().back() - tissue.nodes().front()).x() / 1e-3 - 1;
    EXPECT_NEAR(strain / 0.02, std::exp(-1.0), 0.02);
}

// Let go from any shape, with old factors and steps as long as one likes, a tube only ever loses energy, and in the end
// hardly any is left.
TEST(Tissue, LosesEnergyWhateverTheStep) {
    for (const double seconds : {1e-4, 1e-3, 1e-2, 1.0}) {
        SCOPED_TRACE(seconds);
        const Mesh mesh = make_tube({.around = 12, .through = 1});
        Tissue tissue({}, mesh, {.steps_per_factor = 50});
        std::vector<Vec3> bent;
        for (const Vec3& p : mesh.nodes) bent.push_back({p.x(), 0.3 * p.y(), p.z() + 100 * p.x() * p.x()});
        tissue.place(bent);
        const double before = tissue.energy();
        double energy = before;
        for (int i = 0; i < 2000; ++i) {
            EXPECT_LE(tissue.step({}, seconds).energy_change, 0);
            const double now = tissue.energy();
            EXPECT_LE(now, energy + 1e-12 * before);  // rounding
            energy = now;
        }
        EXPECT_LT(energy, 1e-3 * before);
    }
}

// Yanked to and fro by a newton, ten times what its softness would bear: it cannot gain more than the work that the
// force does on it.
TEST(Tissue, GainsNoMoreThanItIsGiven) {
    for (const double seconds : {1e-3, 4e-3, 0.1}) {
        SCOPED_TRACE(seconds);
        const Mesh mesh = make_tube({});
        const std::vector<Hold> holds = far_end_held(mesh);
        Tissue tissue({}, mesh, {.steps_per_factor = 20});
        double work = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec3 before = tissue.position(at_the_cut()),
                       force = i % 40 < 20 ? Vec3(-0.8, 0.6, 0) : Vec3(0.6, 0, 0.8);
            const PointForce forces[] = {{at_the_cut(), force}};
            tissue.step({.holds = holds, .forces = forces}, seconds);
            work += force.dot(tissue.position(at_the_cut()) - before);
            EXPECT_LE(tissue.energy(), work * (1 + 1e-9));
        }
    }
}

// E21: each cell's corner pushed through the wall, a box pressed flat to a tenth, all of a tube turned inside out.
TEST(Tissue, RecoversFromBeingInsideOut) {
    const Mesh mesh = make_tube({});
    const std::vector<Hold> holds = far_end_held(mesh);
    Tissue tissue({}, mesh);
    std::vector<Vec3> nodes = mesh.nodes;
    for (std::size_t i = 0; i < nodes.size() / 2; i += 7) nodes[i] *= i % 2 ? 0.7 : 1.3;
    tissue.place(nodes);
    EXPECT_LT(smallest_volume(tissue), 0);
    for (int i = 0; i < 500; ++i) tissue.step({.holds = holds}, tick);
    EXPECT_GT(smallest_volume(tissue), 0.99);
    EXPECT_LT(farthest_from_rest(tissue), 5e-6);  // a hundredth of the wall
}

TEST(Tissue, RecoversFromBeingPressedFlat) {
    constexpr double edge = 0.5e-3;
    const Mesh box = make_box({3, 3, 2}, edge);
    Tissue tissue({}, box);
    std::vector<Hold> plates, floor;
    for (int i = 0; i < static_cast<int>(box.nodes.size()); ++i) {
        const Vec3& at = box.nodes[static_cast<std::size_t>(i)];
        if (at.z() == 0) floor.push_back({i, at});
        if (at.z() != edge) plates.push_back({i, {at.x(), at.y(), 0.1 * at.z()}});
    }
    for (int i = 0; i < 100; ++i) tissue.step({.holds = plates}, tick);
    for (int i = 0; i < 500; ++i) tissue.step({.holds = floor}, tick);
    EXPECT_GT(smallest_volume(tissue), 0.99);
    EXPECT_LT(farthest_from_rest(tissue), 0.01 * edge);
}

TEST(Tissue, HoldsWhereItIsTold) {
    const Mesh mesh = make_tube({});
    Tissue tissue({}, mesh);
    std::vector<Hold> holds = far_end_held(mesh);
    holds.push_back({0, mesh.nodes[0]});
    for (int i = 0; i < 200; ++i) {
        holds.back().target += Vec3(-5e-6, 5e-6, 0);
        tissue.step({.holds = holds}, tick);
        for (const Hold& hold : holds) ASSERT_EQ(tissue.nodes()[static_cast<std::size_t>(hold.node)], hold.target);
    }
    holds.pop_back();  // let go, it comes back
    for (int i = 0; i < 500; ++i) tissue.step({.holds = holds}, tick);
    EXPECT_LT(farthest_from_rest(tissue), 5e-6);
}

// Seized while it moves, a node stays where it is seized from that step on, though directions are carried over and the
// factors do not know.
TEST(Tissue, IsHeldFromOneStepToTheNext) {
    const Mesh mesh = make_tube({});
    Tissue tissue({}, mesh);
    std::vector<Hold> holds = far_end_held(mesh);
    const PointForce forces[] = {{at_the_cut(), {-0.03, 0.02, 0}}};
    for (int i = 0; i < 20; ++i) tissue.step({.holds = holds, .forces = forces}, tick);
    const int seized = mesh.tetrahedra[0][0];
    EXPECT_GT(tissue.velocity()[static_cast<std::size_t>(seized)].norm(), 1e-3);
    holds.push_back({seized, tissue.nodes()[static_cast<std::size_t>(seized)]});
    for (int i = 0; i < 20; ++i) {
        tissue.step({.holds = holds, .forces = forces}, tick);
        ASSERT_EQ(tissue.nodes()[static_cast<std::size_t>(seized)], holds.back().target);
    }
}

// What holds carry is what pulls, in the end.
TEST(Tissue, IsHeldAsItIsPulled) {
    const Mesh mesh = make_tube({.around = 12, .through = 1});
    Tissue tissue({}, mesh, newton);
    const std::vector<Hold> holds = far_end_held(mesh);
    const Vec3 force(0.01, 0.02, -0.01);
    const PointForce forces[] = {{at_the_cut(), force}};
    for (int i = 0; i < 10; ++i) tissue.step({.holds = holds, .forces = forces}, in_the_end);
    Vec3 sum = Vec3::Zero();
    for (const Hold& hold : holds) sum += tissue.hold_force(hold.node);
    EXPECT_LE((sum + force).norm(), 1e-6 * force.norm());
}

TEST(Tissue, GivesTheSameBitsTwice) {
    const auto play = [] {
        const Mesh mesh = make_tube({});
        Tissue tissue({}, mesh);
        const std::vector<Hold> holds = far_end_held(mesh);
        for (int i = 0; i < 200; ++i) {
            const PointForce forces[] = {{at_the_cut(), {-1e-4 * i, 5e-5 * i, 0}}};
            tissue.step({.holds = holds, .forces = forces, .pressure = 500}, tick);
        }
        return std::vector<Vec3>(tissue.nodes().begin(), tissue.nodes().end());
    };
    const auto first = play(), second = play();
    EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(Vec3)), 0);
}

// Old factors, one move a step: where a force stays, what is left of the way to equilibrium goes to nothing.
TEST(Tissue, ComesToTheEquilibriumOfNewtonsMethod) {
    const Mesh mesh = make_tube({});
    const std::vector<Hold> holds = far_end_held(mesh);
    const PointForce forces[] = {{at_the_cut(), {-0.02, 0.03, 0.01}}};
    Tissue quick({}, mesh), exact({}, mesh, newton);
    for (int i = 0; i < 500; ++i) quick.step({.holds = holds, .forces = forces}, tick);
    for (int i = 0; i < 20; ++i) exact.step({.holds = holds, .forces = forces}, in_the_end);
    const double way = (exact.position(at_the_cut()) - Tissue({}, mesh).position(at_the_cut())).norm();
    EXPECT_GT(way, 1e-3);
    EXPECT_LE((quick.position(at_the_cut()) - exact.position(at_the_cut())).norm(), 1e-3 * way);
}

}  // namespace
