#include "tests/hashes/table.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

namespace hashes {

namespace fs = std::filesystem;

static std::map<std::string, std::string> read_table() {
    std::map<std::string, std::string> table;
    std::ifstream file(CARREL_SOURCE "/tests/hashes/hashes.csv");
    for (std::string line; std::getline(file, line);) {
        const std::size_t comma = line.rfind(',');
        if (comma != std::string::npos) table[line.substr(0, comma)] = line.substr(comma + 1);
    }
    return table;
}

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

std::vector<fs::path> drill_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(CARREL_SOURCE "/scenarios/drills"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.stem();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace hashes
