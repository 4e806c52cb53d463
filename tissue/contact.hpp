#pragma once
#include "tissue/skin.hpp"
#include "tissue/tissue.hpp"

namespace tissue {

using sim::geometry::Capsule;

/// How hard what touches a wall is. SI.
struct ContactDef {
    double stiffness = 500;  ///< Of each contact [N/m]. Met implicitly: however stiff, it stays stable; what is softer
                             ///< sinks in further.
    double friction = 0;     ///< Coulomb's coefficient; a creeping one: what is held aslant slips by some um a second.
};

/// Parts of tools against a wall, as PointForces for its next step. Contacts are the places of the skin's triangles
/// that are nearest to a capsule's axis, at most one a triangle. A skin that the axis is through by more than half of
/// the radius, before a step, counts as passed. Deterministic; allocates only for more contacts than ever before.
class CapsuleContact {
  public:
    explicit CapsuleContact(const ContactDef& def) : def_(def) {}

    /// Appends to `forces` what pushes the wall out of `now`; with friction drawn along as the capsule went from
    /// `before`. 5 us where nothing touches.
    void press(const Skin& skin, const Capsule& now, const Capsule& before, std::vector<PointForce>& forces);
    /// On the capsule, pressure alone, as wall and capsule are [N]: after Skin::update().
    Vec3 force(const Skin& skin, const Capsule& capsule);

  private:
    struct Place {
        int triangle;
        Vec3 at, way;         // of the wall, where it is pushed
        double along, depth;  // of the axis, 0 to 1; [m]
    };
    void find(const Skin& skin, const Capsule& capsule, const Capsule& before);

    ContactDef def_;
    std::vector<int> near_;
    std::vector<Place> places_;
};

/// Walls against each other and themselves: nodes of the surface that are behind the triangle they are nearest to, by
/// up to half the wall, pushed along the normal between those of its corners, each the mean of the faces about it (as
/// Yang, Laursen and Meng 2005 do in a plane). What lay next to each other at rest does not touch. Each side is held
/// with twice the stiffness, so that both may give way at once and come to the same as one. Deterministic; allocates
/// only for more contacts than ever before.
class WallContact {
  public:
    /// For walls of this thickness, the thinner of two [m].
    WallContact(const ContactDef& def, double thickness) : def_(def), thickness_(thickness) {}

    /// Two walls; appends to the forces of each. 2 us where their boxes are apart, some 160 us for two vessels of 900
    /// triangles whose ends lie over each other.
    void press(const Mesh& rest_a, const Skin& a, std::vector<PointForce>& on_a, const Mesh& rest_b, const Skin& b,
               std::vector<PointForce>& on_b);
    /// A wall and itself, what holds it having `carried` it from its rest. 4 us where no node is further from there
    /// than a quarter of the wall, else more, the more nodes are: up to 0.2 ms for 900 triangles.
    void press(const Mesh& rest, const Skin& skin, std::vector<PointForce>& forces,
               const Eigen::Isometry3d& carried = Eigen::Isometry3d::Identity());

    int contacts() const { return contacts_; }  ///< Of the last press().

  private:
    struct Nearest {
        int triangle;
        double distance, depth;  // from its nearest place, and behind its plane; negative: before [m]
        Vec3 place;
    };
    void sort_nodes(const Mesh& rest, const Skin& skin, const Box& where);
    void find(const Mesh& rest, const Skin& nodes_of, const Skin& triangles_of, bool same);
    void look_at(const Mesh& rest, const Skin& nodes_of, int node, const Skin& triangles_of, int triangle,
                 const Vec3& up, bool same);
    void find_normals(const Mesh& rest, const Skin& skin);
    Vec3 steady_normal(const Mesh& rest, const Skin& skin, int triangle, const Vec3& place) const;
    void push(const Mesh& rest, const Skin& nodes_of, std::vector<PointForce>& on_nodes, const Mesh& rest_of_triangles,
              const Skin& triangles_of, std::vector<PointForce>& on_triangles);
    std::array<int, 3> cell(const Vec3& at) const;
    int column(int x, int y) const { return x * size_[1] + y; }
    int number(int x, int y, int z) const { return column(x, y) * size_[2] + z; }

    ContactDef def_;
    double thickness_;
    int contacts_ = 0;
    Box grid_;
    double edge_ = 0;  // of a cell of the grid [m]
    std::array<int, 3> size_{};
    std::vector<int> face_;                   // of a node, one of its faces; -1
    std::vector<bool> is_bent_;               // nodes that have gone from their rest
    std::vector<std::array<int, 2>> sorted_;  // cells and nodes in them
    std::vector<int> first_;                  // of a column of cells, the first of these
    Box about_, about_bent_;                  // boxes of the nodes in cells, and of the bent ones among them
    std::vector<Nearest> nearest_;
    std::array<std::vector<Vec3>, 4> normals_;  // of each side of the wall, at its nodes; of any length
};

}  // namespace tissue
