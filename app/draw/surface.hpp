#pragma once
#include <functional>

#include "app/draw/picture.hpp"

namespace app::draw {

/// What the graphics library takes.
struct Vertex {
    Eigen::Vector3f position, normal;  ///< [m], world; unit.
};

/// Triangles that share vertices.
struct Surface {
    std::vector<Vertex> vertices;   ///< Its corners.
    std::vector<unsigned> indices;  ///< Three a triangle, counter-clockwise seen from outside.

    /// Appends another.
    void add(const Surface& more);
};

/// Cosines of crease angles: of steel, 41 degrees, past a 9-gon's corner, short of any edge meant to be one; of flesh,
/// 75 degrees, so that folds are round and a cut's rim is sharp.
constexpr float steel_crease = 0.75f, flesh_crease = 0.26f;

/// Normals: the mean over a corner's faces, by area, that meet at less than the crease angle; so walls are round and
/// edges sharp. Triangles without area are left out.
Surface shaded(const assets::Mesh& mesh, float crease_cosine);

/// Closed skin over rings of equally many points, counter-clockwise seen from the last, with a pole before the first
/// and one after the last.
assets::Mesh loft(const Vec3& first_pole, const std::vector<std::vector<Vec3>>& rings, const Vec3& last_pole);

/// Curve through all points: Catmull-Rom with the chords as parameter (even where the spacing is not), `pieces` a span.
/// No two successive points may coincide. A span at both of whose ends the points turn by less than `straight` [rad] is
/// one piece.
std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points, int pieces, double straight = 0);

/// How finely a round thing is drawn.
struct Roundness {
    int around = 16;      ///< Sides.
    int cap_rings = 4;    ///< From an end's equator to its pole.
    int pieces = 5;       ///< Of the smooth curve, a span.
    double straight = 0;  ///< As in smooth_curve() [rad].
};

/// Round-ended tube of radius_at(point) about the thread's smooth curve, or a ball; empty for no points. The frames are
/// carried along by rotations (parallel transport), so the skin never twists; normals are those of a round tube.
Surface tube(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& radius_at,
             const Roundness& roundness = {});

/// What a tube hides from a lamp in this direction: a band square to it through the points. Its normals are the lamp's.
Surface band(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& radius_at, const Vec3& to_lamp);

/// A tool's solid parts.
enum class ToolPart { shaft, pin, jaw };

/// One of them in its own frame: +z the way the tool points, y the tool's, the jaw's mate on its -x side; its origin is
/// the front of the shaft, the middle of the pin, the hinge of the jaw. fine: 32 sides instead of 12, and as many more
/// slices.
assets::Mesh tool_part(instruments::Kind kind, ToolPart part, bool fine);

/// A part, and from its frame to the world.
struct PlacedPart {
    ToolPart part;
    Eigen::Isometry3d pose;
};

/// A tool's parts at its pose: shaft with its hinge pin, and the jaws. They are the capsules of instruments::parts_at
/// where threads are held; towards the hinge the jaws are drawn stouter on the outside (at most 1.6 jaw radii), and
/// their edges squarer (at most 0.2 radii).
std::vector<PlacedPart> placed_parts(const ToolPicture& picture);

}  // namespace app::draw
