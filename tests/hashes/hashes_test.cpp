#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

#include "scenarios/drill/motion.hpp"
#include "scenarios/session/session.hpp"
#include "tests/bench/lab/ties.hpp"
#include "tests/bench/lab/trace.hpp"

// State hashes of what is shipped: every drill, every hard case, two hundred ties. A change that means to keep the bits
// keeps this table; one that means to change them renews it (`make hashes`) in the same commit and says why.
namespace {

namespace fs = std::filesystem;

/// The table's rows: kind, name and place, such as "drill,square-knot,12", and the hash there.
std::map<std::string, std::string> read_table() {
    std::map<std::string, std::string> table;
    std::ifstream file(CARREL_SOURCE "/tests/hashes/hashes.csv");
    for (std::string line; std::getline(file, line);) {
        const std::size_t comma = line.rfind(',');
        if (comma != std::string::npos) table[line.substr(0, comma)] = line.substr(comma + 1);
    }
    return table;
}

/// Holds a hash against the table's; with CARREL_RENEW_HASHES set it prints the row instead.
void expect_hash(const std::string& kind, const std::string& name, const std::string& place, std::uint64_t hash) {
    static const auto table = read_table();
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    const std::string row = kind + ',' + name + ',' + place;
    if (std::getenv("CARREL_RENEW_HASHES")) {
        std::cout << "hash:" << row << ',' << text << std::endl;
        return;
    }
    const auto known = table.find(row);
    ASSERT_NE(known, table.end()) << row << " is not in tests/hashes/hashes.csv";
    ASSERT_EQ(known->second, text) << row;
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.stem();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::vector<fs::path> drill_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(CARREL_SOURCE "/scenarios/drills"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// A drill's state once a second: the first 20 s, or 60 with CARREL_LONG_HASHES set.
class DrillHashes : public testing::TestWithParam<fs::path> {};

TEST_P(DrillHashes, AreThoseOfTheTable) {
    const double until_s = std::getenv("CARREL_LONG_HASHES") ? 60 : 20;
    const auto drill = scenarios::drill::load_drill(GetParam());
    std::vector<std::string> names;
    for (const auto& instrument : drill.world.instruments) names.push_back(instrument.name);
    const auto motion = scenarios::drill::load_motion(drill.motion, names);
    std::vector<instruments::ToolInput> inputs(names.size());
    motion.at(0, inputs);
    scenarios::session::Session session(drill, inputs);
    const double end_s = std::min(until_s, motion.duration());
    for (int tick = 0; tick * drill.world.tick_s < end_s; ++tick) {
        motion.at(tick * drill.world.tick_s, inputs);
        session.tick(inputs);
        if ((tick + 1) % 1000 != 0) continue;
        expect_hash("drill", GetParam().stem(), std::to_string((tick + 1) / 1000), session.world().hash());
        if (HasFatalFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, DrillHashes, testing::ValuesIn(drill_files()), test_name);

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

}  // namespace
