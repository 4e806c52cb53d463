#pragma once
#include "tissue/skin.hpp"
#include "tissue/tissue.hpp"

namespace tissue {

using sim::geometry::Capsule;

/// How hard what touches a wall is. SI.
struct ContactDef {
    /// Stiffness of each contact [N/m]. Solved implicitly: however stiff, it stays stable; with less things sink in
    /// further.
    double stiffness = 500;
    /// Coulomb's coefficient, of a friction that creeps: what is held aslant slips by some um a second.
    double friction = 0;
};

/// Parts of tools against a wall, as PointForces for its next step. Contacts are the places of the skin's triangles
/// that are nearest to a capsule's axis, at most one a triangle. A skin that the axis is through by more than half of
/// the radius, before a step, counts as passed. Deterministic; allocates only for more contacts than ever before.
class CapsuleContact {
  public:
    /// Makes contact with parts as stiff and rough as this.
    explicit CapsuleContact(const ContactDef& def) : def_(def) {}

    /// Appends to `forces` what pushes the wall out of the capsule `now`; with friction the wall is drawn along as the
    /// capsule went from `before`. 5 us where nothing touches.
    void press(const Skin& skin, const Capsule& now, const Capsule& before, std::vector<PointForce>& forces);
    /// Force of the wall on the capsule by pressure alone, as both are after Skin::update() [N].
    Vec3 force(const Skin& skin, const Capsule& capsule);

  private:
    struct Place {
        int triangle;
        Vec3 at;         // of the wall [m]
        Vec3 direction;  // in which the wall is pushed, unit
        double along;    // the capsule's axis, 0 to 1
        double depth;    // [m]
    };
    void find(const Skin& skin, const Capsule& capsule, const Capsule& before);

    ContactDef def_;

    // Scratch.
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
    /// Makes contact of walls of this thickness, the thinner of two, above 0 [m].
    WallContact(const ContactDef& def, double thickness) : def_(def), thickness_(thickness) {}

    /// Two walls; appends to the forces of each. 2 us where their boxes are apart, some 160 us for two vessels of 900
    /// triangles whose ends lie over each other.
    void press(const Mesh& rest_a, const Skin& a, std::vector<PointForce>& on_a, const Mesh& rest_b, const Skin& b,
               std::vector<PointForce>& on_b);
    /// A wall and itself, what holds it having `carried` it from its rest. 4 us where no node is further from there
    /// than a quarter of the wall, else more, the more nodes are: up to 0.2 ms for 900 triangles.
    void press(const Mesh& rest, const Skin& skin, std::vector<PointForce>& forces,
               const Eigen::Isometry3d& carried = Eigen::Isometry3d::Identity());

    int contacts() const { return contacts_; }  ///< How many the last press() found.

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

    // Scratch of one press().
    Box grid_;
    double edge_ = 0;                           // of a cell of the grid [m]
    std::array<int, 3> size_{};                 // of the grid, in cells
    std::vector<int> face_;                     // of each node, one of its faces; none: -1
    std::vector<bool> is_bent_;                 // nodes that have gone from their rest
    std::vector<std::array<int, 2>> sorted_;    // cells and nodes in them
    std::vector<int> first_;                    // of each column of cells, the first of these
    Box about_;                                 // box of the nodes in cells
    Box about_bent_;                            // box of the bent ones among them
    std::vector<Nearest> nearest_;              // of each node
    std::array<std::vector<Vec3>, 4> normals_;  // of each side of the wall, at its nodes; of any length
};

}  // namespace tissue
