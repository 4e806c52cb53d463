// A wall's surface as others touch it. Each triangle's corners are fixed in a face of the mesh and, near a hole, go
// along with its rim by a share that falls with the distance; so an update is a linear map of the mesh's nodes. Queries
// go through all boxes in order: some thousand triangles need no tree.
#include "tissue/skin.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "sim/geometry/closest_points.hpp"

namespace tissue {

Vec3 weights_in(const Triangle& triangle, const Vec3& point) {
    const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, ap = point - triangle.a,
               normal = ab.cross(ac);
    const double nn = normal.squaredNorm();
    if (!(nn > 0)) return Vec3::Constant(1.0 / 3);
    const double v = normal.dot(ap.cross(ac)) / nn, w = normal.dot(ab.cross(ap)) / nn;
    return {1 - v - w, v, w};
}

Skin::Skin(const Mesh& rest)
    : faces_(rest.faces),
      tetrahedron_(faces_.size()),
      place_in_(faces_.size()),
      rest_(rest.nodes),
      nodes_(rest.nodes),
      pierced_at_(rest.nodes) {
    std::map<std::array<int, 3>, std::size_t> known;
    const auto sorted = [](std::array<int, 3> nodes) { return std::sort(nodes.begin(), nodes.end()), nodes; };
    for (std::size_t f = 0; f < faces_.size(); ++f) known[sorted(faces_[f].nodes)] = f;
    for (std::size_t t = 0; t < rest.tetrahedra.size(); ++t)
        for (std::size_t left_out = 0; left_out < 4; ++left_out) {
            const Tetrahedron& tet = rest.tetrahedra[t];
            const auto found =
                known.find(sorted({tet[(left_out + 1) % 4], tet[(left_out + 2) % 4], tet[(left_out + 3) % 4]}));
            if (found == known.end()) continue;
            tetrahedron_[found->second] = static_cast<int>(t);
            for (std::size_t k = 0; k < 3; ++k)
                place_in_[found->second][k] =
                    static_cast<int>(std::find(tet.begin(), tet.end(), faces_[found->second].nodes[k]) - tet.begin());
        }
    const std::size_t with_holes = 4 * faces_.size() + 4096;  // a hole adds some thirty
    triangles_.reserve(with_holes), boxes_.reserve(with_holes), face_.reserve(with_holes), parts_.reserve(with_holes),
        corners_.reserve(with_holes), holes_.reserve(128), wires_.reserve(128);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        face_.push_back(static_cast<int>(f));
        corners_.push_back({Corner{Vec3::UnitX()}, Corner{Vec3::UnitY()}, Corner{Vec3::UnitZ()}});
    }
    triangles_.resize(faces_.size()), boxes_.resize(faces_.size());
    update(rest.nodes);
    forget_parts();
}

Vec3 Skin::at_face(int face, const Vec3& weights) const {
    return weights.x() * node(face, 0) + weights.y() * node(face, 1) + weights.z() * node(face, 2);
}

Vec3 Skin::normal_of_face(int face) const {
    return (node(face, 1) - node(face, 0)).cross(node(face, 2) - node(face, 0)).normalized();
}

Vec3 Skin::weights_in_face(int face, const Vec3& point) const {
    return weights_in({node(face, 0), node(face, 1), node(face, 2)}, point);
}

void Skin::place(Hole& hole) const {
    const Vec3 edge = node(hole.face, 1) - node(hole.face, 0), along = edge.normalized(),
               up = edge.cross(node(hole.face, 2) - node(hole.face, 0)).normalized();
    hole.centre = at_face(hole.face, hole.weights);
    hole.frame << along, up.cross(along), up;
    hole.aside = Vec3::Zero(), hole.reshaped = Eigen::Matrix3d::Zero();
}

// Stretches the wall in the direction in which something goes through it aslant: seen along it, the opening is then as
// wide as across.
Eigen::Matrix3d Skin::drawn_out(const Vec3& in_frame, bool back) {
    const Vec3 flat = Vec3(in_frame.x(), in_frame.y(), 0).normalized();
    const double steep = std::max(std::abs(in_frame.z()), least_steep);
    return Eigen::Matrix3d::Identity() + ((back ? steep : 1 / steep) - 1) * flat * flat.transpose();
}

// The rim is drawn out as the wire in it asks, instead of as the direction in which it was pierced did.
void Skin::put_on(const Wire& wire) {
    Hole& hole = holes_[index(wire.hole)];
    hole.aside = wire.at - hole.centre;
    hole.reshaped =
        hole.frame * (drawn_out(hole.frame.transpose() * wire.along, false) * drawn_out(hole.direction, true) -
                      Eigen::Matrix3d::Identity());
}

Vec3 Skin::position(int face, const Corner& corner) const {
    const Vec3 carried = at_face(face, corner.weights);
    if (corner.hole < 0) return carried;
    const Hole& hole = holes_[index(corner.hole)];
    const double radii = fade - corner.share * (fade - 1);  // further out nothing goes farther than the rim
    return carried + corner.share * (hole.centre + hole.frame * corner.offset - carried + hole.aside +
                                     hole.reshaped * (corner.offset / radii));
}

void Skin::set_box(std::size_t i) {
    const Triangle& t = triangles_[i];
    boxes_[i] = {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
    all_.include(boxes_[i]);
}

void Skin::update(std::span<const Vec3> nodes) {
    assert((nodes_.empty() || nodes.size() == nodes_.size()) && "a place for each node");
    nodes_.assign(nodes.begin(), nodes.end());
    for (Hole& hole : holes_) place(hole);
    for (const Wire& wire : wires_) put_on(wire);
    all_ = {};
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        triangles_[i] = {position(face_[i], corners_[i][0]), position(face_[i], corners_[i][1]),
                         position(face_[i], corners_[i][2])};
        set_box(i);
    }
}

Vec3 Skin::normal(int triangle) const {
    const Triangle& t = (*this)[triangle];
    return (t.b - t.a).cross(t.c - t.a).normalized();
}

MaterialPoint Skin::point_of_face(int face, const Vec3& weights) const {
    MaterialPoint found{tetrahedron_[index(face)], {}};
    for (std::size_t k = 0; k < 3; ++k)
        found.weights[index(place_in_[index(face)][k])] = weights[static_cast<Eigen::Index>(k)];
    return found;
}

MaterialPoint Skin::point(int triangle, const Vec3& weights) const {
    const auto& [a, b, c] = corners_[index(triangle)];
    return point_of_face(face(triangle), weights.x() * a.weights + weights.y() * b.weights + weights.z() * c.weights);
}

// Signs of the volumes that the segment spans with the edges. Two neighbours find exactly opposite ones for their edge,
// so that one of them is hit.
Skin::Spot Skin::hit(const Vec3& from, const Vec3& to, Facing facing) const {
    Spot best;
    Box reach;
    reach.include(from), reach.include(to);
    if (!all_.overlaps(reach)) return best;
    const Vec3 segment = to - from;
    for (int i = 0; i < size(); ++i) {
        if (!box(i).overlaps(reach)) continue;
        const Vec3 a = (*this)[i].a - from, b = (*this)[i].b - from, c = (*this)[i].c - from;
        const Vec3 share(segment.dot(b.cross(c)), segment.dot(c.cross(a)), segment.dot(a.cross(b)));
        const double sum = share.sum();  // positive where segment and normal agree
        if (sum == 0 || (facing == Facing::against && sum > 0) || (facing == Facing::along && sum < 0) ||
            (sum > 0 ? share.minCoeff() < 0 : share.maxCoeff() > 0))
            continue;
        const Vec3 weights = share / sum, at = weights.x() * a + weights.y() * b + weights.z() * c;
        const double along = at.dot(segment) / segment.squaredNorm();
        if (along < 0 || along > 1 || (best.triangle >= 0 && along >= best.along)) continue;
        best = {i, weights, from + at, along, 0};
    }
    return best;
}

Skin::Spot Skin::closest(const Vec3& a, const Vec3& b, double reach, const Vec3& facing) const {
    Spot best;
    best.distance = reach;
    Box around;
    around.include(a), around.include(b);
    if (!all_.overlaps(around.grown(reach))) return best;
    const bool any = facing.isZero(0);
    for (int i = 0; i < size(); ++i) {
        if (!box(i).overlaps(around.grown(best.distance))) continue;
        const Triangle& t = (*this)[i];
        if (!any && !((t.b - t.a).cross(t.c - t.a).dot(facing) > 0)) continue;
        const auto pair = sim::geometry::closest_points(a, b, t);
        if (!(pair.distance_squared < best.distance * best.distance)) continue;
        best = {i, weights_in(t, pair.on_b), pair.on_b, pair.s, std::sqrt(pair.distance_squared)};
    }
    return best;
}

void Skin::forget_parts() {
    parts_.clear();
    for (int i = 0; i < size(); ++i) parts_.push_back({i});
}

int Skin::hole_about(int triangle, const Vec3& weights) const {
    const Vec3 point = point_in((*this)[triangle], weights);
    int best = -1;
    double least = 1;
    for (int hole = 0; hole < holes(); ++hole) {
        const double far = (point - centre(hole)).norm() / (fade * radius(hole));
        if (far < least && side_of_face(face_of_hole(hole)) == side(triangle)) best = hole, least = far;
    }
    return best;
}

void Skin::near(const Box& where, std::vector<int>& found) const {
    if (!all_.overlaps(where)) return;
    for (int i = 0; i < size(); ++i)
        if (box(i).overlaps(where)) found.push_back(i);
}

}  // namespace tissue
