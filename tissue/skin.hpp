#pragma once
#include "sim/geometry/hash.hpp"
#include "sim/geometry/shapes.hpp"
#include "tissue/mesh.hpp"

namespace tissue {

using sim::geometry::Box;
using sim::geometry::Triangle;

/// A triangle that is part of another one.
struct Part {
    int of = 0;  ///< That other one's number.
    /// A column for each corner of the part: weights of the other one's corners, which sum to 1.
    Eigen::Matrix3d weights = Eigen::Matrix3d::Identity();
};

/// A wall's surface as others touch it: triangles that move with the wall, with openings where it was pierced. Thread
/// passes through an opening and rests against its rim by ordinary contact.
///
/// An opening is a regular octagon, seen in the direction in which it was pierced. Its rim is as rigid as what
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
    /// faces the same side: as wide as a hole of `radius` [m], and over both ends by as much. It strains with the wall.
    /// Numbers of triangles change. 0.2 ms, once.
    void slit(int face, const Vec3& from, const Vec3& to, double radius);

    /// A stiff thing in a hole.
    struct Wire {
        int hole;    ///< Its number.
        Vec3 at;     ///< The point of the wire nearest to the hole's middle [m].
        Vec3 along;  ///< The wire's direction there, or the opposite, unit.
    };
    /// From the next update on rims are about these, drawn out along the wall as what goes through it aslant asks, up
    /// to 60 degrees; all others are the wall's again. However the wall bends beside a wire, it goes through its hole,
    /// and what is swaged to it comes after.
    void set_wires(std::span<const Wire> wires) { wires_.assign(wires.begin(), wires.end()); }

    int openings() const { return openings_; }  ///< Holes and slits so far: triangles keep their numbers in between.
    /// What each triangle is part of, of those that there were when parts were last forgotten.
    std::span<const Part> parts() const { return parts_; }
    /// From now on each triangle is its own only part.
    void forget_parts();
    int size() const { return static_cast<int>(triangles_.size()); }  ///< How many triangles.
    /// A triangle, 0 to size() - 1, where it is [m].
    const Triangle& operator[](int triangle) const { return triangles_[index(triangle)]; }
    const Box& box(int triangle) const { return boxes_[index(triangle)]; }  ///< About a triangle [m].
    int face(int triangle) const { return face_[index(triangle)]; }  ///< Of the mesh, that a triangle is part of.
    Side side(int triangle) const { return side_of_face(face(triangle)); }  ///< Of the wall, that a triangle is on.
    Vec3 normal(int triangle) const;  ///< Unit, out of the wall; zero without area.
    /// The point of the wall with these weights of the triangle's corners, which sum to 1.
    MaterialPoint point(int triangle, const Vec3& weights) const;
    /// The point of the wall with these weights of a face's nodes, as if no hole displaced it.
    MaterialPoint point_of_face(int face, const Vec3& weights) const;
    Vec3 weights_in_face(int face, const Vec3& point) const;  ///< Of the point of a face's plane that is below `point`.
    Vec3 at_face(int face, const Vec3& weights) const;        ///< Where such a point is [m].
    Vec3 normal_of_face(int face) const;                      ///< Unit, out of the wall.
    Side side_of_face(int face) const { return faces_[index(face)].side; }  ///< Of the wall, that a face is on.
    std::span<const Vec3> nodes() const { return nodes_; }                  ///< Of the wall, as last told [m].

    int holes() const { return static_cast<int>(holes_.size()); }                     ///< How many so far.
    Vec3 centre(int hole) const { return holes_[index(hole)].centre; }                ///< Where its middle is [m].
    Vec3 normal_of_hole(int hole) const { return holes_[index(hole)].frame.col(2); }  ///< Unit, out of the wall.
    double radius(int hole) const { return holes_[index(hole)].radius; }              ///< Of what fits through [m].
    /// The hole that a corner of a triangle goes along with, on its rim or round it; none: -1.
    int hole_at(int triangle, std::size_t corner) const { return corners_[index(triangle)][corner].hole; }
    int face_of_hole(int hole) const { return holes_[index(hole)].face; }  ///< Of the mesh, that its middle is in.
    /// The hole nearest to a place on a triangle, of those of its side within three radii, as far as the wall goes
    /// along with rims; none: -1.
    int hole_about(int triangle, const Vec3& weights) const;
    /// The point of the wall that a hole's middle is.
    MaterialPoint point_of_hole(int hole) const {
        return point_of_face(face_of_hole(hole), holes_[index(hole)].weights);
    }

    /// A place on the skin.
    struct Spot {
        int triangle = -1;            ///< Which it is on; none: -1.
        Vec3 weights = Vec3::Zero();  ///< Of the triangle's corners.
        Vec3 at = Vec3::Zero();       ///< Where it is [m].
        double along = 0;             ///< Place on the segment that was asked for, 0 to 1.
        double distance = 0;          ///< From that segment [m].
    };
    /// Which skin a segment is to meet: one that faces against its direction, along it, or either.
    enum class Facing { against, along, either };
    /// The first place where a segment [m] goes through such skin; triangle -1 where there is none. Edges leave no
    /// gaps.
    Spot hit(const Vec3& from, const Vec3& to, Facing facing) const;
    /// The place nearest to a segment [m], up to `reach` [m]; only of skin that looks to the side of `facing`, unless
    /// that is zero.
    Spot closest(const Vec3& a, const Vec3& b, double reach, const Vec3& facing = Vec3::Zero()) const;
    /// Appends the numbers of all triangles whose boxes overlap `box` [m], in ascending order.
    void near(const Box& box, std::vector<int>& found) const;
    /// Adds where it is, its holes and what is in them.
    friend void add_to(sim::geometry::Hash& hash, const Skin& skin);

  private:
    static constexpr double fade = 3;           // radii from a hole's middle to where the wall no longer goes along
    static constexpr double least_steep = 0.5;  // sine of 30 degrees to the wall: a flatter hole would slit it

    struct Corner {
        Vec3 weights;                // of its face's nodes
        int hole = -1;               // the hole that it goes along with; none: -1
        double share = 0;            // how much of the displacement to its place on that hole's rim it makes, 0 to 1
        Vec3 offset = Vec3::Zero();  // from the hole's centre in the hole's frame [m]
    };
    struct Hole {
        int face;                                             // of the mesh
        double radius;                                        // [m]
        Vec3 weights;                                         // of its centre, in the face
        Vec3 centre = Vec3::Zero();                           // [m]
        Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  // along an edge, across, normal
        Vec3 direction = Vec3::UnitZ();                       // in which it was pierced, in the frame
        Vec3 aside = Vec3::Zero();                            // from its middle to a wire that is in it [m]
        Eigen::Matrix3d reshaped = Eigen::Matrix3d::Zero();   // how its rim's corners go to be round that wire
    };
    struct Outline;  // of a hole or slit while it is cut
    struct Polygon;  // what of a triangle is left while it is cut

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

    std::vector<Face> faces_;                     // of the mesh
    std::vector<int> tetrahedron_;                // of each face
    std::vector<std::array<int, 3>> place_in_;    // of a face's nodes in its tetrahedron
    std::vector<Vec3> rest_;                      // nodes at rest [m]
    std::vector<Vec3> nodes_;                     // nodes as last told [m]
    std::vector<Vec3> pierced_at_;                // scratch: nodes while a hole is cut out of the wall at rest [m]
    std::vector<Triangle> triangles_;             // where they are [m]
    std::vector<Box> boxes_;                      // of each triangle
    Box all_;                                     // about all triangles, or more
    std::vector<int> face_;                       // of each triangle
    std::vector<Part> parts_;                     // of each triangle
    std::vector<std::array<Corner, 3>> corners_;  // of each triangle
    std::vector<Hole> holes_;
    std::vector<Wire> wires_;
    int openings_ = 0;  // holes and slits so far
};

/// Weights of the corners for the point of a triangle's plane that is below `point`; each a third where the triangle
/// has no area.
Vec3 weights_in(const Triangle& triangle, const Vec3& point);

/// The point of the triangle's plane that has these weights of its corners, which sum to 1 [m].
inline Vec3 point_in(const Triangle& triangle, const Vec3& weights) {
    return weights.x() * triangle.a + weights.y() * triangle.b + weights.z() * triangle.c;
}

}  // namespace tissue
