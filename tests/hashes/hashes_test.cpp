#include "tests/bench/lab/ties.hpp"
#include "tests/bench/lab/trace.hpp"
#include "tests/hashes/table.hpp"

namespace hashes {

namespace fs = std::filesystem;

/// The last state of each variant of a hard case.
class HardCaseHashes : public testing::TestWithParam<fs::path> {};

TEST_P(HardCaseHashes, AreThoseOfTheTable) {
    const auto hard_case = bench::lab::load_hard_case(GetParam());
    for (std::size_t i = 0; i < hard_case.scenes.size(); ++i)
        expect_hash("hard_case", hard_case.id, std::to_string(i), bench::lab::play(hard_case.scenes[i]).hash);
}

INSTANTIATE_TEST_SUITE_P(Scenes, HardCaseHashes,
                         testing::ValuesIn(bench::lab::hard_case_files(CARREL_SOURCE "/tests/hard_cases")), test_name);

/// The last state of two hundred ties, in eight parts.
class TieHashes : public testing::TestWithParam<int> {};

TEST_P(TieHashes, AreThoseOfTheTable) {
    for (int seed = 25 * GetParam(); seed < 25 * (GetParam() + 1); ++seed)
        expect_hash("tie", "quick", std::to_string(seed), bench::lab::ties(static_cast<std::uint64_t>(seed)).hash);
}

INSTANTIATE_TEST_SUITE_P(Quick, TieHashes, testing::Range(0, 8));

}  // namespace hashes
