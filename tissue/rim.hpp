#pragma once
#include <span>
#include <vector>

#include "tissue/mesh.hpp"

namespace tissue {

/// Where a cut meets another side of the wall: a closed line of edges. A place on it is how far along it is at rest
/// [m], from 0 to length.
struct Rim {
    std::vector<int>
        nodes;  ///< Nodes in order, the cut to its left seen from outside the wall; the first is not repeated.
    std::vector<double> places;  ///< Places of the nodes, at rest [m].
    double length = 0;           ///< Length of the whole line at rest [m].
};

/// All closed lines of edges that a face of Side::cut shares with one of `side`: its outer rims, or its inner ones. By
/// the lowest node of each; lines that do not close are left out.
std::vector<Rim> rims(const Mesh& rest, Side side);

/// A point of a rim that is nearest to another point.
struct RimPoint {
    double place;     ///< Where it is along the rim [m].
    double distance;  ///< How far it is from the other point [m].
};
/// The point of a rim nearest to a point of the wall, both at rest [m]. Some 10 ns for each edge of the rim.
RimPoint nearest(const Rim& rim, const Mesh& rest, const Vec3& point);
/// Where a place of a rim is when the mesh has its nodes here [m]; places beyond the end go round again.
Vec3 position(const Rim& rim, double place, std::span<const Vec3> nodes);
/// How long a rim is when the mesh has its nodes here [m].
double length(const Rim& rim, std::span<const Vec3> nodes);
/// The mean of a rim's line when the mesh has its nodes here [m].
Vec3 middle(const Rim& rim, std::span<const Vec3> nodes);

}  // namespace tissue
