#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "assets/mesh.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "tests/sim/thread/scene.hpp"

// Counts every allocation of this program; it is a program of its own for that.
namespace {

std::size_t allocations = 0;

void* counted(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

using namespace scene;

// An allocation waits for a lock now and then: a tick that allocates is one that stutters once a minute. The same
// motion is made twice, so that in the second round every buffer has seen its largest.
std::size_t allocated_by_ticks(const sim::thread::ThreadDef& def) {
    const sim::geometry::TriangleTree wall(assets::make_tube(4e-3, 0.6e-3, 20e-3, 16, 4).soup());
    Thread thread(def, overhand());
    const Vec3 left = thread.nodes().front(), right = thread.nodes().back(), away = (right - left).normalized();
    const int owners[] = {-1, -1};
    const auto play = [&] {
        for (int i = 0; i < 120; ++i) {
            const Vec3 out = 0.05e-3 * (i < 60 ? i : 120 - i) * away;
            const Hold holds[] = {{0, left - out}, {200, right + out}};
            const sim::geometry::Capsule bar{left + Vec3(0, -0.01, 0.001), left + Vec3(0, 0.01, 0.001), 0.5e-3};
            const sim::thread::MovingCapsule capsules[] = {{bar, bar, 0}};
            thread.tick({holds, owners, capsules, &wall});
        }
    };
    play();
    play();
    const std::size_t before = allocations;
    play();
    return allocations - before;
}

TEST(Allocation, ATickAllocatesNothingOnceItsBuffersHaveGrown) {
    sim::thread::ThreadDef elastic;
    elastic.elastic = {.axial_over_bending = 0};
    EXPECT_EQ(allocated_by_ticks({}), 0u);
    EXPECT_EQ(allocated_by_ticks(elastic), 0u);
    const std::size_t at_test = allocations;
    ::operator delete(::operator new(1));
    EXPECT_EQ(allocations, at_test + 1);  // the counter counts
}

// Links come and go while a knot is drawn tight and let go again.
TEST(Allocation, ChangingLinksAllocatesNothing) {
    Thread thread({.shortest_link = 2 * radius}, overhand(60, 8 * radius));
    bench::lab::Apart pull(thread);
    const auto play = [&] {
        for (int i = 0; i < 1200; ++i) pull.by(thread, i < 600 ? 0.05e-3 : -0.05e-3);
    };
    play();
    const std::size_t before = allocations, links = thread.rest_lengths().size();
    std::size_t most = 0;
    for (int i = 0; i < 600; ++i) {
        pull.by(thread, 0.05e-3);
        most = std::max(most, thread.rest_lengths().size());
    }
    EXPECT_EQ(allocations - before, 0u);
    EXPECT_NE(most, links);  // they did change
}

}  // namespace
