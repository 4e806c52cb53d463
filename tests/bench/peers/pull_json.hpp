#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/bench/lab/pull.hpp"

namespace bench::peers {

// What is no number is null in JSON.
inline nlohmann::ordered_json to_json(const lab::PullFigures& figures) {
    nlohmann::ordered_json object;
    for (const auto& [name, value] : lab::pull_figures) object[name] = figures.*value;
    return object;
}

/// Throws nlohmann::json::exception when a figure is missing.
inline lab::PullFigures figures_from(const nlohmann::json& object) {
    lab::PullFigures figures{};
    for (const auto& [name, value] : lab::pull_figures)
        figures.*value = object.at(name).is_null() ? NAN : object.at(name).get<double>();
    return figures;
}

}  // namespace bench::peers
