#pragma once
#include <optional>

#include "sim/knot/curve.hpp"
#include "sim/knot/diagram.hpp"

namespace sim::knot {

/// The diagram seen along `view`. Nothing when that direction is not generic (a crossing at a vertex, three strands
/// over one point, ...): take another. With more than `most` crossings it is not complete. Cost: sorted by x, then
/// every pair of edges that overlap in x.
std::optional<Diagram> project(const Polygons& polygons, const Vec3& view, int most);

/// An open strand seen along `view`, without any closing edge: not the diagram of a knot yet, see joined_ends().
struct OpenDiagram {
    Diagram diagram;                ///< One strand, its passages from the first vertex to the last.
    std::vector<double> positions;  ///< Per passage, the index of its edge plus the place along it, 0 to 1.
};
/// The open strand seen along `view`; nothing, and at what cost, as project() says.
std::optional<OpenDiagram> project_open(const std::vector<Vec3>& strand, const Vec3& view, int most);

}  // namespace sim::knot
