#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/bench/pull.hpp"

namespace app::bench {

// What is no number is null in JSON.
inline nlohmann::ordered_json to_json(const PullFigures& figures) {
    nlohmann::ordered_json object;
    for (const auto& [name, value] : pull_figures) object[name] = figures.*value;
    return object;
}

/// Throws nlohmann::json::exception when a figure is missing.
inline PullFigures figures_from(const nlohmann::json& object) {
    PullFigures figures{};
    for (const auto& [name, value] : pull_figures)
        figures.*value = object.at(name).is_null() ? NAN : object.at(name).get<double>();
    return figures;
}

}  // namespace app::bench
