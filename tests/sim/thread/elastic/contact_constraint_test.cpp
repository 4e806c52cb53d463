#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "sim/geometry/at.hpp"
#include "sim/thread/elastic/contact_solver.hpp"
#include "sim/thread/elastic/find_contacts.hpp"

namespace contact_constraints {

using sim::at;
using sim::geometry::Vec3;
using sim::rod::Pair;
using sim::thread::elastic::ContactSet;
using sim::thread::elastic::State;

constexpr int nodes = 24, pieces = 3, size = nodes / pieces;  // of which the first two touch each other

// An elastic thread cut in three, its matrix one that a rod could have.
struct Cut {
    State state;
    ContactSet set;
    sim::thread::elastic::Pieces all;
    Eigen::MatrixXd inverse;

    explicit Cut(std::mt19937& random) : state(thread(), line()) {
        std::normal_distribution<double> normal;
        auto& matrix = state.rod.matrix();
        matrix.clear(nodes);
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
        for (int i = 0; i < nodes; ++i)
            for (int j = i; j < std::min(nodes, i + 3) && j / size == i / size; ++j) {
                Eigen::Matrix3d block;
                for (double& x : block.reshaped()) x = normal(random);
                if (i == j) block = (block * block.transpose() + 40 * Eigen::Matrix3d::Identity()).eval();
                matrix.add(at(i), at(j), block);
                dense.block(3 * i, 3 * j, 3, 3) = block;
                dense.block(3 * j, 3 * i, 3, 3) = block.transpose();
            }
        EXPECT_TRUE(matrix.factor());
        inverse = dense.inverse();
        for (int i = 0; i < nodes; ++i) all.of_node.push_back(i / size);
        all.count = pieces;
    }

    static sim::thread::ThreadDef thread() {
        sim::thread::ThreadDef def;
        def.elastic = sim::thread::RodDef{};
        return def;
    }
    static std::vector<Vec3> line() {
        std::vector<Vec3> points;
        for (int i = 0; i < nodes; ++i) points.push_back(1e-3 * i * Vec3::UnitX());
        return points;
    }

    // Between a link of one piece and a link of another or of the same, of a tool (none: -1), or where no node can
    // move.
    void contact(std::mt19937& random, int piece, int other) {
        Pair pair;
        const auto add = [&](int of, double sign) {
            if (of < 0) return;
            const int first = of * size + static_cast<int>(random() % (size - 1));
            const double share = static_cast<double>(random() % 1000) / 1000;
            for (const int k : {0, 1})
                pair.node[at(pair.nodes)] = first + k, pair.weight[at(pair.nodes++)] = sign * (k ? share : 1 - share);
        };
        add(piece, 1), add(other, -1);
        set.contacts.emplace_back(&row).pair = pair;
    }
    Eigen::MatrixXd ways() const {
        Eigen::MatrixXd ways = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * set.contacts.size()), 3 * nodes);
        for (std::size_t c = 0; c < set.contacts.size(); ++c)
            for (int k = 0; k < set.contacts[c].pair.nodes; ++k)
                for (int a = 0; a < 3; ++a)
                    ways(sim::axes(c) + a, 3 * set.contacts[c].pair.node[at(k)] + a) +=
                        set.contacts[c].pair.weight[at(k)];
        return ways;
    }
    sim::thread::contact::Row row{};
};

using sim::thread::contact::Against;
using sim::thread::contact::Row;

// A link's middle on a wall's triangle, which it just touches.
Row on_wall(int triangle, const Vec3& normal) {
    const double radius = sim::thread::ThreadDef{}.radius;
    return {Against::surface, 3, triangle, radius, 0.15, radius, 0.5, 0, normal, radius * normal, Vec3::Zero(), radius};
}

// What it pressed there with, mN: not so that it slides.
Row pressed(int triangle, const Vec3& push) {
    Row row = on_wall(triangle, Vec3::UnitZ());
    row.normal_push = 1e-3 * push.z();
    row.tangent_push = 1e-3 * Vec3(push.x(), push.y(), 0);
    return row;
}

// What all that may press pushes with, found anew [mN].
Vec3 pushed(State& state) {
    std::vector<sim::thread::elastic::ContactConstraint> contacts;
    sim::thread::elastic::ContactFinder(state.most_links()).find(state, contacts);
    Vec3 sum = Vec3::Zero();
    for (const auto& contact : contacts) sum += 1e3 * contact.push;
    return sum;
}

// A thread that rests on a wall where two of its triangles meet is now nearer to one and now to the other. What it
// presses with, and what of that sticks, is the wall's; to another that faces another way it is nothing.
TEST(ContactConstraints, GoOnWhereTheNextTriangleOfAWallIsNearest) {
    const Vec3 push(0.1, 0.05, 1), turned = Vec3(std::sin(0.1), 0, std::cos(0.1)),
                                   aside = Vec3(std::sin(0.5), 0, std::cos(0.5));
    State state(Cut::thread(), Cut::line());
    state.pressed = {pressed(7, push)};
    state.rows = {on_wall(8, Vec3::UnitZ())};
    EXPECT_LE((pushed(state) - push).norm(), 1e-12);  // rounding of numbers about 1
    state.rows = {on_wall(8, turned)};
    EXPECT_NEAR(pushed(state).norm(), push.norm(), 0.02);  // 0.1 rad of it is turned away
    state.rows = {on_wall(7, Vec3::UnitZ()), on_wall(8, Vec3::UnitZ())};
    EXPECT_LE((pushed(state) - push).norm(), 1e-12);  // not twice
    state.rows = {on_wall(8, aside)};
    EXPECT_EQ(pushed(state).norm(), 0);
}

// Contacts of one piece, between two and with no node that moves, in any order, against all nodes at once by Eigen's
// dense inverse. What one push moves is moved by push_more(). Of contacts that share no piece nothing is written, and
// nothing is read.
TEST(ContactConstraints, MovePieceByPieceAsAllNodesAtOnceDo) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Cut cut(random);
        ContactSet& set = cut.set;
        sim::thread::elastic::DelassusMatrix responses;
        const int last = seed % 2 ? 1 : 2;  // the third piece touches nothing, or itself alone
        for (int i = 0; i < 30; ++i) {
            const int piece = static_cast<int>(random() % static_cast<unsigned>(last + 1));
            const int others[] = {-1, piece, piece < 2 ? 1 - piece : -1};
            cut.contact(random, i == 7 ? -1 : piece, i == 7 ? -1 : others[random() % 3]);
        }
        const std::size_t count = set.contacts.size();
        responses.reserve(count, nodes);
        responses.measure(cut.state, set.contacts, cut.all);
        const Eigen::MatrixXd ways = cut.ways(), expected = ways * cut.inverse * ways.transpose();
        for (std::size_t d = 0; d < count; ++d)
            for (const sim::thread::elastic::Run& run : responses.coupled_with(set.contacts[d])) {
                for (std::size_t c = run.first; c < run.past; ++c)
                    ASSERT_LT((responses.block(d, c) - expected.block<3, 3>(sim::axes(d), sim::axes(c)))
                                  .cwiseAbs()
                                  .maxCoeff(),
                              1e-12);  // entries are of the order of a fortieth
            }
        set.apart.assign(3 * count, 0.0);
        const Vec3 push(0.3, -1, 0.7);
        push_more(set, responses, 3, push);
        const Eigen::Map<const Eigen::VectorXd> moved(set.apart.data(), expected.rows());
        EXPECT_LT((moved - expected.middleCols<3>(9) * push).cwiseAbs().maxCoeff(), 1e-12);
        for (auto& contact : set.contacts) contact.normal = Vec3::UnitZ(), contact.rest = 1e-3 * contact.normal;
        sim::thread::elastic::NormalSolver().part(set, responses, cut.state.def.radius);
        double sum = 0;
        for (const auto& contact : set.contacts) sum += contact.push.norm();
        EXPECT_TRUE(sum > push.norm() && std::isfinite(sum)) << "too near, they push";
    }
}

}  // namespace contact_constraints
