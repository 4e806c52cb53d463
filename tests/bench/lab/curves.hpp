#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/knot/namer.hpp"

namespace bench::lab {

/// A curve whose type is known.
struct LabelledCurve {
    std::string id;        ///< "p103"
    nlohmann::json label;  ///< As in labels.json, whose README says what it holds.
    std::vector<sim::knot::Component> components;

    /// Its ends are free, so that it has one type.
    bool is_definite() const { return !label.contains("closure"); }
};

/// All of `folder`/labels.json; only the one named `id` when given. Throws what the JSON reader throws.
std::vector<LabelledCurve> labelled_curves(const std::filesystem::path& folder, const std::string& id = "");

}  // namespace bench::lab
