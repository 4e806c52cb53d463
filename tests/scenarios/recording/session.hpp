#pragma once
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "scenarios/recording/recording.hpp"

namespace session {

using instruments::ToolInput;
using scenarios::recording::Head;

/// A folder of its own that goes with the test.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "carrel-recording-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

inline Head head() {
    return {"{\"carrel_drill\": 1, \"title\": \"\xc3\xa9\"}\n",
            "a.json",
            "0.1.0",
            1e-3,
            {"left", "right"},
            {{"m.csv", std::string(64, 'a')}}};
}

/// Inputs of tick `t`: smooth with noise in the last bits, as devices give; a function of the tick alone.
inline std::vector<ToolInput> tools_at(std::uint64_t t) {
    std::mt19937_64 random(t);
    const auto noise = [&] { return static_cast<double>(random()) / 1.8446744073709552e19 * 1e-6; };
    std::vector<ToolInput> tools(2);
    for (ToolInput& tool : tools) {
        tool.pose.position = {1e-5 * static_cast<double>(t) + noise(), noise(), -0.02 + noise()};
        tool.pose.rotation = instruments::Quat(1 - noise(), noise(), noise(), noise());
        tool.jaw = 0.5 + noise();
    }
    return tools;
}

inline std::uint64_t hash_at(std::uint64_t t) {
    return std::mt19937_64(t ^ 0x9e3779b97f4a7c15u)();
}

/// The bits of inputs, so that NaN compares equal to itself and -0 differs from 0.
inline std::vector<std::uint64_t> bits(std::span<const ToolInput> tools) {
    std::vector<std::uint64_t> all;
    for (const ToolInput& tool : tools) {
        const auto& [p, q] = tool.pose;
        for (const double x : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), tool.jaw})
            all.push_back(std::bit_cast<std::uint64_t>(x));
    }
    return all;
}

/// Records `ticks` ticks with a hash each hundred. The clock stands still, so that chunks are of 500 ticks on every
/// machine.
inline void record(const std::filesystem::path& file, std::uint64_t ticks, bool finish = true) {
    scenarios::recording::Recorder recorder(file, head(), {.clock = [] { return 0.0; }});
    for (std::uint64_t t = 0; t < ticks; ++t) {
        recorder.add_tick(tools_at(t));
        if (t % 100 == 99) recorder.add_hash(t, hash_at(t));
    }
    if (finish) recorder.finish();
}

}  // namespace session
