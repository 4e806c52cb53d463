#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "tissue/bite.hpp"
#include "tissue/tube.hpp"

// Counts every allocation of this program; it is a program of its own for that.
namespace {

std::size_t allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
    ++allocations;
    if (void* memory = std::aligned_alloc(alignment, (size / alignment + 1) * alignment)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace {

using namespace tissue;

TEST(Allocation, AStepAllocatesNothingAfterTheFirst) {
    const Mesh mesh = make_tube({});
    Tissue tissue({}, mesh);
    std::vector<Hold> holds;
    for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i)
        if (mesh.nodes[static_cast<std::size_t>(i)].x() > 7.9e-3)
            holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
    std::size_t before = 0;
    for (int i = 0; i < 200; ++i) {
        const PointForce forces[] = {{{}, {-1e-4 * i, 0, 0}}};
        tissue.step({.holds = holds, .forces = forces, .pressure = 1e3}, 1e-3);
        if (i == 0) before = allocations;
    }
    EXPECT_EQ(allocations - before, 0u);
    ::operator delete(::operator new(1));
    EXPECT_EQ(allocations - before, 1u);  // the counter counts
}

// A needle through a wall and back, a tool beside it; holes are pierced meanwhile.
TEST(Allocation, ABiteAllocatesNothingAfterTheFirstTouch) {
    const Mesh mesh = make_tube({});
    Tissue tissue({}, mesh);
    Skin skin(mesh);
    Bites bites({}, mesh);
    CapsuleContact tool({});
    WallContact itself({}, TubeDef{}.wall);
    std::vector<Hold> holds;
    for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i)
        if (mesh.nodes[static_cast<std::size_t>(i)].x() > 7.9e-3)
            holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
    std::vector<PointForce> forces;
    forces.reserve(1024);
    std::size_t before = 0, holes = 0;
    for (int i = 0; i < 400; ++i) {
        const double way = 20e-6 * (i < 200 ? i : 400 - i);  // straight down through the upper wall, in a wide arc
        const Arc needle{.centre = {1.5e-3, 2.3e-3 - way, 8e-3},
                         .to_tail = Vec3(0, 0.38268, -0.92388),
                         .onwards = Vec3(0, -0.92388, -0.38268),
                         .radius = 8e-3,
                         .angle = 0.3927};
        const Capsule rod{{4e-3, 2.4e-3, -3e-3}, {4e-3, 2.4e-3, 3e-3}, 0.5e-3};
        bites.press(&needle, skin);
        forces.assign(bites.forces().begin(), bites.forces().end());
        tool.press(skin, rod, rod, forces), itself.press(mesh, skin, forces);
        tissue.step({.holds = holds, .forces = forces}, 2e-3);
        skin.update(tissue.nodes());
        bites.settle(skin);
        if (bites.holes_on_needle() == 0 && skin.holes() == 0) before = allocations;
        holes = std::max(holes, static_cast<std::size_t>(skin.holes()));
    }
    EXPECT_GE(holes, 2u);
    EXPECT_EQ(allocations - before, 0u);
}

}  // namespace
