#include "sim/geometry/resample.hpp"

#include <cassert>

namespace sim::geometry {

std::vector<Vec3> resample(std::span<const Vec3> path, int links) {
    assert(path.size() >= 2 && links >= 1 && "a path, and links to lay along it");
    double total = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) total += (path[i + 1] - path[i]).norm();
    std::vector<Vec3> nodes{path.front()};
    double passed = 0;
    std::size_t i = 0;
    for (int k = 1; k < links; ++k) {
        const double wanted = total * k / links;
        double piece = (path[i + 1] - path[i]).norm();
        while (passed + piece < wanted && i + 2 < path.size()) {
            passed += piece;
            ++i;
            piece = (path[i + 1] - path[i]).norm();
        }
        nodes.push_back(path[i] + (wanted - passed) / piece * (path[i + 1] - path[i]));
    }
    nodes.push_back(path.back());
    return nodes;
}

}  // namespace sim::geometry
