#include "tests/bench/lab/curves.hpp"

#include <fstream>
#include <sstream>

namespace bench::lab {

using sim::knot::Component;

static std::vector<Component> read(const std::filesystem::path& file, const nlohmann::json& parts) {
    std::vector<Component> components(parts.size());
    std::ifstream in(file);
    std::size_t c = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() && c < parts.size() && !components[c].vertices.empty()) ++c;
        std::istringstream numbers(line.substr(0, line.find('#')));
        if (double x, y, z; numbers >> x >> y >> z) components.at(c).vertices.emplace_back(x, y, z);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) components[i].closed = parts[i]["closed"];
    return components;
}

std::vector<LabelledCurve> labelled_curves(const std::filesystem::path& folder, const std::string& id) {
    std::ifstream in(folder / "labels.json");
    std::vector<LabelledCurve> all;
    const auto labels = nlohmann::json::parse(in);
    for (const auto& label : labels["curves"])
        if (id.empty() || label["id"] == id)
            all.push_back({label["id"], label, read(folder / label["file"].get<std::string>(), label["components"])});
    return all;
}

}  // namespace bench::lab
