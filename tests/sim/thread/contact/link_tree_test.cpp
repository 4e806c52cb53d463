#include "sim/thread/contact/link_tree.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "sim/geometry/closest_points.hpp"

namespace {

using sim::geometry::Box;
using sim::geometry::Vec3;
using sim::thread::contact::LinkTree;

std::vector<Vec3> walk(unsigned seed, int links) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> step(-1, 1);
    std::vector<Vec3> nodes{Vec3::Zero()};
    for (int i = 0; i < links; ++i)
        nodes.push_back(nodes.back() + Vec3(step(random), step(random), 0.3 * step(random)));
    return nodes;
}

double distance(const std::vector<Vec3>& nodes, int i, int j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    return std::sqrt(sim::geometry::closest_points(nodes[a], nodes[a + 1], nodes[b], nodes[b + 1]).distance_squared);
}

// A pair that the tree forgets is a contact that never happens: strands there run through each other. Crumpled walks,
// where nearly everything is near, and numbers of links about the leaf's size and powers of two, where trees go wrong.
TEST(LinkTree, VisitsEveryNearPairOnceAndInOrder) {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const int counts[] = {1, 2, 3, 4, 5, 15, 16, 17, 31, 33, 64, 100};
        const int links = counts[seed % 12], skip = 1 + static_cast<int>(seed % 4);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", links " + std::to_string(links));
        const auto nodes = walk(seed, links);
        LinkTree tree(links);
        tree.refit(nodes);
        const double reach = 0.2 + 0.1 * (seed % 7);
        std::set<std::pair<int, int>> visited;
        tree.self_pairs(reach, skip, [&](int i, int j) {
            EXPECT_LE(i + skip, j);
            EXPECT_LT(j, links);
            EXPECT_TRUE(visited.emplace(i, j).second) << i << ' ' << j;
        });
        for (int i = 0; i < links; ++i)
            for (int j = i + skip; j < links; ++j) {
                if (distance(nodes, i, j) >= reach) continue;
                EXPECT_TRUE(visited.contains({i, j})) << i << ' ' << j;
            }
    }
}

// The same for a tool's box: a link that is forgotten is a needle holder that closes through the thread.
TEST(LinkTree, VisitsEveryLinkNearABox) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const int links = 10 + 7 * static_cast<int>(seed);
        const auto nodes = walk(seed, links);
        LinkTree tree(links);
        tree.refit(nodes);
        Box box;
        box.include(nodes[nodes.size() / 2]);
        box = box.grown(0.7);
        std::set<int> visited;
        tree.near(box, [&](int i) { EXPECT_TRUE(visited.insert(i).second); });
        for (int i = 0; i < links; ++i) {
            Box link;
            link.include(nodes[static_cast<std::size_t>(i)]);
            link.include(nodes[static_cast<std::size_t>(i) + 1]);
            if (!link.overlaps(box)) continue;
            EXPECT_TRUE(visited.contains(i)) << i;
        }
    }
}

// A tree that visits everything is right and useless: a long straight thread has no near pairs beyond its neighbours.
TEST(LinkTree, LeavesFarPairsAlone) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= 512; ++i) nodes.emplace_back(i, 0, 0);
    LinkTree tree(512);
    tree.refit(nodes);
    int visits = 0;
    tree.self_pairs(3, 2, [&](int, int) { ++visits; });
    EXPECT_LT(visits, 512 * 4 * LinkTree::leaf_links);
}

}  // namespace
