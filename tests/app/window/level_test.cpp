#include "app/window/level.hpp"

#include <gtest/gtest.h>

using app::window::DrawingLevel;

TEST(DrawingLevel, IsFullWhereThatIsFastEnough) {
    DrawingLevel level("4.6 (Core Profile) Mesa 22.3.6 | AMD Radeon");
    level.add_second(30);
    EXPECT_TRUE(level.is_full());
    level.add_second(29);
    EXPECT_FALSE(level.is_full());
    level.add_second(60);
    EXPECT_FALSE(level.is_full()) << "it would come and go";
}

TEST(DrawingLevel, IsLightFromTheFirstFrameWithoutAGraphicsCard) {
    EXPECT_FALSE(DrawingLevel("4.5 (Core Profile) Mesa 22.3.6 | llvmpipe (LLVM 15.0.6, 256 bits)").is_full());
}

TEST(DrawingLevel, StaysAsThePersonSwitchedIt) {
    DrawingLevel level("llvmpipe");
    level.toggle();
    level.add_second(2);
    EXPECT_TRUE(level.is_full());
}
