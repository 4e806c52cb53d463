#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "tissue/tissue.hpp"
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
        if (mesh.nodes[static_cast<std::size_t>(i)].x() > 7.9e-3) holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
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

}  // namespace
