#include "tissue/leak.hpp"

#include <gtest/gtest.h>

namespace {

using namespace tissue;

constexpr double mm = 1e-3;

// By hand for a millimetre of slit in walls of 0.5 and 0.1 mm, to the digits given there.
TEST(Leak, HasTheReferencesValues) {
    const struct {
        double gap, thick, thin, digit;
    } rows[] = {{0.02, 0.3, 1.3, 0.1}, {0.05, 3.9, 7.5, 0.1}, {0.1, 14, 17, 1}, {0.2, 34, 36, 1}};
    for (const auto& [gap, thick, thin, digit] : rows) {
        SCOPED_TRACE(gap);
        EXPECT_NEAR(in_ml_per_min(leak_of_slit(gap * mm, mm, 0.5 * mm)), thick, digit / 2);
        EXPECT_NEAR(in_ml_per_min(leak_of_slit(gap * mm, mm, 0.1 * mm)), thin, digit / 2);
    }
    EXPECT_NEAR(in_ml_per_min(leak_of_slit(0.5 * mm, mm, 0.1 * mm)), 90, 0.5);
    EXPECT_NEAR(in_ml_per_min(leak_of_slit(0.5 * mm, mm, 0.5 * mm)), 90, 0.5);
    EXPECT_NEAR(in_ml_per_min(leak_of_hole(mm * mm)), 181, 0.5);
    EXPECT_NEAR(in_ml_per_min(leak_of_hole(mm * mm, {.density = 1010})), 185, 0.5);  // saline, by its density alone
}

// What narrow and wide slits come to: Poiseuille's flow, and the hole's.
TEST(Leak, HasBothLimits) {
    const Fluid blood;
    const double narrow = 1e-6,
                 poiseuille = narrow * narrow * narrow * mm * blood.pressure / (12 * blood.viscosity * 0.5 * mm);
    EXPECT_NEAR(leak_of_slit(narrow, mm, 0.5 * mm), poiseuille, 1e-4 * poiseuille);
    EXPECT_NEAR(leak_of_slit(mm, mm, 0), leak_of_hole(mm * mm), 1e-12 * leak_of_hole(mm * mm));
}

TEST(Leak, IsNothingWhereNothingIsOpenOrPresses) {
    for (const double gap : {0.0, -mm, 1e-300}) EXPECT_EQ(leak_of_slit(gap, mm, 0.5 * mm), 0);
    EXPECT_EQ(leak_of_slit(mm, mm, 0.5 * mm, {.pressure = 0}), 0);
    EXPECT_EQ(leak_of_slit(mm, mm, 0, {.pressure = 0}), 0);
    EXPECT_EQ(leak_of_hole(0), 0);
}

}  // namespace
