#include <gtest/gtest.h>

#include <functional>

#include "tests/sim/thread/scene.hpp"

// Laws of space that no choice of axes, hand or unit may break: what holds for one thread holds for its image.
namespace {

using namespace scene;
using Map = std::function<Vec3(const Vec3&)>;

std::vector<Vec3> pulled(const Map& map, double scale, int ticks) {
    std::vector<Vec3> nodes = overhand(120);
    for (Vec3& p : nodes) p = map(p);
    const ThreadDef def{.radius = scale * radius};
    Thread thread(def, std::move(nodes));
    const std::vector<Vec3> start = overhand(120);
    const Vec3 step = 0.1e-3 * (start.back() - start.front()).normalized();
    const int owners[] = {-1, -1};
    for (int i = 1; i <= ticks; ++i) {
        const Hold holds[] = {{0, map(start.front() - i * step)}, {120, map(start.back() + i * step)}};
        thread.tick({holds, owners, {}, nullptr});
    }
    return {thread.nodes().begin(), thread.nodes().end()};
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

std::vector<Vec3> mapped(std::vector<Vec3> nodes, const Map& map) {
    for (Vec3& p : nodes) p = map(p);
    return nodes;
}

const Map same = [](const Vec3& p) { return p; };

// A left-handed knot is a right-handed one in a mirror. Any step that knows left from right would make one of them
// easier to tie. Changing a sign rounds nothing, so the two motions agree to the last bit.
TEST(Law, MirroredThreadsMoveAlikeToTheBit) {
    for (int axis = 0; axis < 3; ++axis) {
        const Map mirror = [axis](const Vec3& p) {
            Vec3 q = p;
            q[axis] = -q[axis];
            return q;
        };
        EXPECT_EQ(farthest(mapped(pulled(same, 1, 60), mirror), pulled(mirror, 1, 60)), 0) << axis;
    }
}

// A doubled thread with doubled motion: powers of two round nothing, so any hidden length (a bare 1e-6 somewhere) shows
// as a different bit.
TEST(Law, ThreadsAnyPowerOfTwoLargerMoveAlikeToTheBit) {
    for (const double scale : {0x1p-10, 0x1p-3, 2.0, 0x1p10}) {
        const Map grown = [scale](const Vec3& p) { return Vec3(scale * p); };
        EXPECT_EQ(farthest(mapped(pulled(same, 1, 60), grown), pulled(grown, scale, 60)), 0) << scale;
    }
}

// Other scales, and axes exchanged (sums of three squares in another order), round differently; while the knot is loose
// those last bits must not grow into another motion. The bound is a thousandth of the thread's thickness.
TEST(Law, ScaleAndQuarterTurnsDoNotMatter) {
    constexpr int loose = 15;
    const auto plain = pulled(same, 1, loose);
    for (const double scale : {1e-3, 0.1, 7.0, 1e3}) {
        const Map grown = [scale](const Vec3& p) { return Vec3(scale * p); };
        EXPECT_LT(farthest(mapped(plain, grown), pulled(grown, scale, loose)), 1e-3 * scale * 2 * radius) << scale;
    }
    const std::pair<const char*, Map> turns[] = {
        {"about z", [](const Vec3& p) { return Vec3(-p.y(), p.x(), p.z()); }},
        {"about x", [](const Vec3& p) { return Vec3(p.x(), -p.z(), p.y()); }},
        {"about the diagonal", [](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()); }}};
    for (const auto& [name, turn] : turns)
        EXPECT_LT(farthest(mapped(plain, turn), pulled(turn, 1, loose)), 1e-3 * 2 * radius) << name;
}

// A recording can only be replayed if the same input gives the same bits.
TEST(Law, TheSameInputGivesTheSameState) {
    const auto hash = [] {
        Thread thread({}, overhand());
        Pull pull(thread);
        for (int i = 0; i < 80; ++i) pull.by(thread, 0.1e-3);
        return thread.hash();
    };
    EXPECT_EQ(hash(), hash());
}

// A hash that misses a moved node would call a failed replay a success.
TEST(Law, TheHashSeesAMotionOfOneBit) {
    Thread a({}, overhand()), b({}, overhand());
    Pull pull(a);
    pull.hold(a);
    pull.right.x() = std::nextafter(pull.right.x(), 1.0);
    pull.hold(b);
    EXPECT_NE(a.hash(), b.hash());
}

}  // namespace
