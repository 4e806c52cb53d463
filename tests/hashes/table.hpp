#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// tests/hashes/hashes.csv: state hashes of what is shipped. A change that means to keep the bits keeps this table; one
// that means to change them renews it (`make hashes`) in the same commit and says why.
namespace hashes {

/// Holds a hash against the row of this kind, name and place, such as "drill,square-knot,12"; with CARREL_RENEW_HASHES
/// set it prints the row instead.
void expect_hash(const std::string& kind, const std::string& name, const std::string& place, std::uint64_t hash);

/// The shipped drills, in the order of their names.
std::vector<std::filesystem::path> drill_files();

/// A file's name without its ending, as GoogleTest takes it: with lines below for dashes.
std::string test_name(const testing::TestParamInfo<std::filesystem::path>& info);

}  // namespace hashes
