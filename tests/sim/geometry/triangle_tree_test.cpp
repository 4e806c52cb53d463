#include "sim/geometry/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace sim::geometry;

static Box box_of(const Triangle& t) {
    Box box;
    for (const Vec3& p : {t.a, t.b, t.c}) box.include(p);
    return box;
}

// A triangle the tree forgets is a hole in a vessel. Half of the boxes are flat or points, and a third of the triangles
// share one centre, where a median by coordinate alone cannot split.
TEST(TriangleTree, FindsExactlyWhatTestingEveryTriangleFinds) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        for (const int count : {0, 1, 4, 5, 300}) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << " count " << count);
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> place(-1, 1), small(-0.1, 0.1);
            const auto point = [&](auto& d) { return Vec3(d(random), d(random), d(random)); };
            std::vector<Triangle> triangles;
            for (int i = 0; i < count; ++i) {
                const Vec3 centre = i % 3 == 0 ? Vec3(0.25, 0.25, 0.25) : point(place);
                const Vec3 side = point(small);
                triangles.push_back(i % 3 == 0 ? Triangle{centre - side, centre, centre + side}
                                               : Triangle{centre, centre + side, centre + point(small)});
            }
            const TriangleTree tree(triangles);
            for (int query = 0; query < 200; ++query) {
                Box box;
                box.include(point(place));
                if (query % 2) box.include(box.low + point(small) * (query % 7));
                if (query % 5 == 0 && count > 0) box = box_of(triangles[static_cast<std::size_t>(query % count)]);
                std::vector<int> expected, found;
                for (int i = 0; i < count; ++i)
                    if (box_of(tree[i]).overlaps(box)) expected.push_back(i);
                tree.near(box, found);
                std::vector<int> again;
                tree.near(box, again);
                EXPECT_EQ(found, again);
                std::sort(found.begin(), found.end());
                ASSERT_EQ(found, expected);
            }
        }
    }
}
