#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "scenarios/drill/file.hpp"
#include "tests/bench/lab/trace.hpp"
#include "tests/bench/suites/stability.hpp"

namespace {

using namespace bench::lab;
using namespace bench::suites;

std::string told(const Outcome& outcome) {
    const ConditionKind& kind = condition_kind(outcome.condition.is);
    std::ostringstream text;
    text << kind.name << " = " << outcome.value << ' ' << kind.unit << ", must be at "
         << (outcome.condition.must == Must::be_at_most ? "most " : "least ") << outcome.condition.bound;
    return text.str();
}

class HardCases : public testing::TestWithParam<std::filesystem::path> {};

// What is known to miss its bound must not come to miss it by more, and when it holds its mark must go.
TEST_P(HardCases, EveryConditionHolds) {
#ifdef __SANITIZE_ADDRESS__
    constexpr bool quick = true;  // ten times slower there: the first variant of each
#else
    constexpr bool quick = false;
#endif
    const HardCase hard_case = load_hard_case(GetParam());
    for (const Outcome& outcome : examine(hard_case, quick)) {
        const Condition& condition = outcome.condition;
        EXPECT_TRUE(outcome.keeps(condition.today.value_or(condition.bound)))
            << told(outcome) << "\nIf not: " << hard_case.goes_wrong;
        const bool is_known = condition.today.has_value();
        EXPECT_FALSE(is_known && !quick && outcome.holds()) << told(outcome) << ", and holds now: \"known\" can go";
    }
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
    std::string name = info.param.stem();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, HardCases, testing::ValuesIn(hard_case_files(CARREL_SOURCE "/tests/hard_cases")),
                         name_of);

}  // namespace
