#pragma once
#include <functional>

#include "app/draw/picture.hpp"

namespace app::draw {

/// What the graphics library takes.
struct Vertex {
    Eigen::Vector3f position, normal;  ///< [m], world.
};

struct Surface {
    std::vector<Vertex> vertices;
    std::vector<unsigned> indices;  ///< Three a triangle, counter-clockwise seen from outside.
};

/// Normals: the mean over a corner's faces, by area, that meet at less than the crease angle; so walls are round and
/// edges sharp. Triangles without area are left out.
Surface shaded(const assets::Mesh& mesh);

/// Closed skin over rings of equally many points, counter-clockwise seen from the last, with a pole before the first
/// and one after the last.
assets::Mesh loft(const Vec3& first_pole, const std::vector<std::vector<Vec3>>& rings, const Vec3& last_pole);

/// Curve through all points: Catmull-Rom with the chords as parameter (even where the spacing is not), `pieces` a span.
/// No two successive points may coincide.
std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points, int pieces);

/// Round-ended tube of radius_at(point) about the thread's smooth curve, or a ball; empty for no points. The frames are
/// carried along by rotations (parallel transport), so the skin never twists.
assets::Mesh tube(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& radius_at);

/// A tool's solid parts at its pose: shaft with its hinge pin, and the jaws. They are the capsules of
/// instruments::parts_at where threads are held; towards the hinge the jaws are drawn stouter on the outside (at most
/// 1.6 jaw radii), and their edges squarer (at most 0.2 radii).
std::vector<assets::Mesh> tool(const ToolPicture& picture);

}  // namespace app::draw
