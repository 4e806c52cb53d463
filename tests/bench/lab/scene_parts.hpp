#pragma once
#include <nlohmann/json.hpp>

#include "tests/bench/lab/hard_case.hpp"

namespace bench::lab {

/// What is wrong with a value of a scene file that has the right form.
struct Misfit {
    std::string pointer, what;
};

/// The scene that a checked file with its defaults filled in describes. Throws Misfit.
Scene scene_of(const nlohmann::json& value, const std::filesystem::path& folder);

/// "first", "last", "50%" or a number, of so many nodes.
int node_of(const nlohmann::json& value, int nodes);

}  // namespace bench::lab
