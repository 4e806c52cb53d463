// The wall of a vessel as thread presses on it.
#include "scenarios/world/soft_vessel.hpp"

#include <gtest/gtest.h>

namespace soft_vessel {

using scenarios::world::SoftVessel;
using scenarios::world::wall_compliance;

// Places apart on one wall, each pressed with 1 mN by a thread that takes it to give way by `wall_compliance`. What the
// wall takes the thread for is one number for all of them [N/m], or they were together far stiffer than it reckons
// with; an inextensible thread knows nothing of how it gives way.
TEST(SoftVessel, ReckonsWithAllPlacesTogether) {
    scenarios::world::VesselDef def;
    def.is_soft = true;
    const SoftVessel vessel(def, 0.2e-3);
    for (const auto& [places, elastic, stiffness] :
         {std::tuple{1, true, 5e3}, {5, true, 5e3}, {20, true, 20 / wall_compliance}, {20, false, 1e4}}) {
        SoftVessel pressed = vessel;
        for (int t = 0; t < places; ++t) {
            const auto& triangle = pressed.skin[7 * t];
            pressed.press({7 * t, (triangle.a + triangle.b + triangle.c) / 3, {0, 0, -1e-3}, 0}, triangle, 1);
        }
        pressed.load(1, elastic);
        double sum = 0;
        for (const tissue::PointForce& force : pressed.forces) sum += force.stiffness;
        EXPECT_EQ(pressed.forces.size(), static_cast<std::size_t>(places));
        EXPECT_NEAR(sum, stiffness, 1e-9 * stiffness) << places << " places";  // rounding
    }
}

}  // namespace soft_vessel
