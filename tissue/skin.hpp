#pragma once
#include "sim/geometry/shapes.hpp"
#include "tissue/mesh.hpp"

namespace tissue {

using sim::geometry::Box;
using sim::geometry::Triangle;

/// A triangle that is part of another one.
struct Part {
    int of = 0;
    Eigen::Matrix3d weights = Eigen::Matrix3d::Identity();  ///< Of that one's corners, a column for each of its own.
};

/// A wall's surface as others touch it: triangles that move with the wall, with openings where it was pierced. Thread
/// passes through an opening and rests against its rim by ordinary contact.
///
/// An opening is what remains of a regular octagon seen along the way that it was pierced. Its rim is as rigid as what
/// is in it: its corners keep their places about the middle, which moves and turns with the wall, or with a wire that
/// is in it; corners up to three radii from there go along, the less the further out, so that none but slivers turn
/// over where the wall draws together by up to a third.
class Skin {
  public:
    /// The surface of `rest`, as it is there.
    explicit Skin(const Mesh& rest);

    /// Moves with the wall; one number of nodes throughout [m]. 25 us for 900 triangles; nothing is allocated.
    void update(std::span<const Vec3> nodes);

    /// Opens a hole about `point`, which is in or near this face of the mesh, through which a cylinder of `radius` [m]
    /// fits along `direction` in the wall at rest; no further aslant than 60 degrees, for what runs along a wall would
    /// slit it. Returns its number: 0, 1, 2 ... Cuts what faces `direction` as the face does, within three radii of its
    /// plane. Numbers of triangles change. 0.2 ms, once; allocates only beyond some hundred holes.
    int pierce(int face, const Vec3& point, const Vec3& direction, double radius);
    /// Opens a strip from `from` to `to` [m], places of the wall at rest next to the plane of this face, as far as that
    /// looks the same way: as wide as a hole of `radius` [m], and over both ends by as much. It strains with the wall.
    /// Numbers of triangles change. 0.2 ms, once.
    void slit(int face, const Vec3& from, const Vec3& to, double radius);

    /// A stiff thing in a hole: the place of it nearest to the hole's middle [m], and the way it goes there, or the
    /// opposite (unit).
    struct Wire {
        int hole;
        Vec3 at, along;
    };
    /// From the next update on rims are about these, drawn out along the wall as what goes through it aslant asks, up
    /// to 60 degrees; all others are the wall's again. However the wall bends beside a wire, it goes through its hole,
    /// and what is swaged to it comes after.
    void set_wires(std::span<const Wire> wires) { wires_.assign(wires.begin(), wires.end()); }

    int openings() const { return openings_; }  ///< Holes and slits so far: triangles keep their numbers in between.
    /// What each triangle is part of, of those that there were when parts were last forgotten.
    std::span<const Part> parts() const { return parts_; }
    void forget_parts();
    int size() const { return static_cast<int>(triangles_.size()); }
    const Triangle& operator[](int triangle) const { return triangles_[index(triangle)]; }
    const Box& box(int triangle) const { return boxes_[index(triangle)]; }
    int face(int triangle) const { return face_[index(triangle)]; }  ///< That it is part of, of the mesh.
    Side side(int triangle) const { return side_of_face(face(triangle)); }
    Vec3 normal(int triangle) const;  ///< Unit, out of the wall; zero without area.
    /// The point of the wall with these weights of the triangle's corners.
    MaterialPoint point(int triangle, const Vec3& weights) const;
    /// The same of a face, none of which a hole displaces.
    MaterialPoint point_of_face(int face, const Vec3& weights) const;
    Vec3 weights_in_face(int face, const Vec3& point) const;  ///< Of the point of its plane below `point`.
    Vec3 at_face(int face, const Vec3& weights) const;        ///< [m]
    Vec3 normal_of_face(int face) const;                      ///< Unit, out of the wall.
    Side side_of_face(int face) const { return faces_[index(face)].side; }
    std::span<const Vec3> nodes() const { return nodes_; }  ///< Of the wall, as last told [m].

    int holes() const { return static_cast<int>(holes_.size()); }
    Vec3 centre(int hole) const { return holes_[index(hole)].centre; }                ///< [m]
    Vec3 normal_of_hole(int hole) const { return holes_[index(hole)].frame.col(2); }  ///< Unit, out of the wall.
    double radius(int hole) const { return holes_[index(hole)].radius; }              ///< Of what fits through [m].
    /// The hole that a corner of a triangle goes along with, on its rim or round it; none: -1.
    int hole_at(int triangle, std::size_t corner) const { return corners_[index(triangle)][corner].hole; }
    int face_of_hole(int hole) const { return holes_[index(hole)].face; }
    /// Of the holes of its side within three radii of a place on a triangle, to where the wall goes along with their
    /// rims, the nearest; none: -1.
    int hole_about(int triangle, const Vec3& weights) const;
    MaterialPoint point_of_hole(int hole) const {
        return point_of_face(face_of_hole(hole), holes_[index(hole)].weights);
    }

    /// A place on the skin.
    struct Spot {
        int triangle = -1;            ///< None: -1.
        Vec3 weights = Vec3::Zero();  ///< Of its corners.
        Vec3 at = Vec3::Zero();       ///< [m]
        double along = 0;             ///< Of the segment asked for, 0 to 1.
        double distance = 0;          ///< [m]
    };
    /// Whether it faces outwards ...
    enum class Facing { against, along, either };
    /// The first place where a segment goes through the skin, where that faces against its way, along it or either.
    /// Edges leave no gaps.
    Spot hit(const Vec3& from, const Vec3& to, Facing facing) const;
    /// The place nearest to a segment, up to `reach` [m]; only of what looks to the side of `facing`, unless that is
    /// zero.
    Spot closest(const Vec3& a, const Vec3& b, double reach, const Vec3& facing = Vec3::Zero()) const;
    /// Appends all triangles whose boxes overlap `box`, in ascending order.
    void near(const Box& box, std::vector<int>& found) const;

  private:
    static constexpr double fade = 3;           // radii from a hole's middle to where the wall no longer goes along
    static constexpr double least_steep = 0.5;  // the sine of 30 degrees, to the wall: what runs flatter would slit it

    struct Corner {
        Vec3 weights;                // of its face's nodes
        int hole = -1;               // that it goes along with ...
        double share = 0;            // ... by so much of the way there
        Vec3 offset = Vec3::Zero();  // from the hole's centre in its frame
    };
    struct Hole {
        int face;
        double radius;
        Vec3 weights;  // of its centre, in the face
        Vec3 centre = Vec3::Zero();
        Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  // along an edge, across, normal
        Vec3 way = Vec3::UnitZ();                             // that it was pierced, in the frame
        Vec3 aside = Vec3::Zero();                            // from its middle to a wire that is in it,
        Eigen::Matrix3d reshaped = Eigen::Matrix3d::Zero();   // and how the rim's corners go to be round it
    };
    struct Outline;  // of a hole while it is cut
    struct Polygon;

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    const Vec3& node(int face, std::size_t k) const { return nodes_[index(faces_[index(face)].nodes[k])]; }
    void place(Hole& hole) const;
    static Eigen::Matrix3d drawn_out(const Vec3& in_frame, bool back);
    void put_on(const Wire& wire);
    Vec3 position(int face, const Corner& corner) const;
    void set_box(std::size_t i);
    template <class Height>
    Polygon clipped(const Polygon& all, int face, double tiny, const Height& height) const;
    bool cut(std::size_t triangle, const Outline& outline);
    void open(const Outline& outline);
    void anchor(int hole, const Outline& outline);

    std::vector<Face> faces_;
    std::vector<int> tetrahedron_;              // of each face
    std::vector<std::array<int, 3>> place_in_;  // of its nodes there
    std::vector<Vec3> rest_, nodes_, pierced_at_;
    std::vector<Triangle> triangles_;
    std::vector<Box> boxes_;
    Box all_;  // about all of them, or more
    std::vector<int> face_;
    std::vector<Part> parts_;
    std::vector<std::array<Corner, 3>> corners_;
    std::vector<Hole> holes_;
    std::vector<Wire> wires_;
    int openings_ = 0;
};

/// Weights of the corners for the point of a triangle's plane that is below `point`; each a third where the triangle
/// has no area.
Vec3 weights_in(const Triangle& triangle, const Vec3& point);

/// The point of the triangle's plane that has these weights of its corners, which sum to 1 [m].
inline Vec3 point_in(const Triangle& triangle, const Vec3& weights) {
    return weights.x() * triangle.a + weights.y() * triangle.b + weights.z() * triangle.c;
}

}  // namespace tissue
