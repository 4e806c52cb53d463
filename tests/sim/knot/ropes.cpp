#include "tests/sim/knot/ropes.hpp"

#include <fstream>
#include <numbers>
#include <sstream>

namespace ropes {

constexpr double pi = std::numbers::pi;

static std::vector<Component> read(const std::string& file, const nlohmann::json& parts) {
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

std::vector<Labelled> labelled(const std::string& id) {
    const std::string folder = std::string(CARREL_SOURCE) + "/tests/data/curves/";
    std::ifstream in(folder + "labels.json");
    std::vector<Labelled> all;
    const auto labels = nlohmann::json::parse(in);
    for (const auto& label : labels["curves"])
        if (id.empty() || label["id"] == id)
            all.push_back({label["id"], label, read(folder + label["file"].get<std::string>(), label["components"])});
    return all;
}

Rope torus_knot(int n) {
    Rope rope;
    for (int i = 0; i < 200; ++i) {
        // Two tours, the section turning from outwards to downwards: about the way forward that is right-handed.
        const double along = 2 * pi * 2 * i / 200, around = 2 * pi * n * i / 200;
        const double radius = 2.0 + std::cos(around);
        rope.emplace_back(radius * std::cos(along), radius * std::sin(along), -std::sin(around));
    }
    return rope;
}

Rope mirrored(Rope rope) {
    for (Vec3& p : rope) p.x() = -p.x();
    return rope;
}

Rope turned(Rope rope, std::mt19937& random) {
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    for (Vec3& p : rope) p = q * p;
    return rope;
}

}  // namespace ropes
