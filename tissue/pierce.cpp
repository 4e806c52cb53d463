// Openings in the skin.
//
// Method: the outline, a regular octagon or one drawn out to a slit, is cut out of each triangle that it meets: eight
// rays from its middle divide the triangle into sectors, each of which is clipped by the outline's edge there
// (Sutherland and Hodgman 1974) and split into triangles as a fan. Neighbours are split by the same rays, so that they
// keep fitting.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tissue/skin.hpp"

namespace tissue {

namespace {

constexpr double rounding = 1e-9;  // in radii: what is nearer than this to an edge of the outline is on it

}  // namespace

// What is cut out, seen along the direction in which it is pierced; edges are numbered counter-clockwise from x. A slit
// is a hole drawn out along x: the edges on that side are further on.
struct Skin::Outline {
    Vec3 centre, direction, x, y, up;
    double radius, length = 0;

    double beyond(std::size_t edge, const Vec3& point) const {  // [m]
        const double u = x.dot(point - centre) - (edge < 2 || edge == 7 ? length : 0), v = y.dot(point - centre),
                     d = std::sqrt(0.5);
        const std::array<double, 4> half{u, d * (u + v), v, d * (v - u)};
        return (edge < 4 ? half[edge] : -half[edge - 4]) - radius;
    }
    double left_of_ray(std::size_t corner, const Vec3& point)
        const {  // from the centre through the corner after an edge of that number [m]
        const double u = x.dot(point - centre) - (corner < 2 || corner > 5 ? length : 0), v = y.dot(point - centre),
                     c = std::sqrt(0.5 + 0.5 * std::sqrt(0.5)), s = std::sqrt(0.5 - 0.5 * std::sqrt(0.5));
        const std::array<double, 4> half{c * v - s * u, s * v - c * u, -s * v - c * u, -c * v - s * u};
        return corner < 4 ? half[corner] : -half[corner - 4];
    }
    double height(const Vec3& point) const { return std::abs(up.dot(point - centre)); }
    double radii(const Vec3& point) const {  // from the middle, 1 on the rim, up to two radii above and below it
        double most = 0.5 * height(point) - radius;
        for (std::size_t edge = 0; edge < 8; ++edge) most = std::max(most, beyond(edge, point));
        return 1 + most / radius;
    }
};

struct Skin::Polygon {  // convex, a triangle less what is beyond some edges
    struct Vertex {
        Vec3 at;
        Corner corner;
    };
    std::array<Vertex, 12> vertices;
    std::size_t count = 0;

    void add(const Vertex& vertex) { vertices[count++] = vertex; }
    const Vertex& operator[](std::size_t k) const { return vertices[k]; }
};

// The part of a polygon whose height is above nothing; new vertices are the wall's where they are.
template <class Height>
Skin::Polygon Skin::clipped(const Polygon& all, int face, double tiny, const Height& height) const {
    Polygon kept;
    for (std::size_t k = 0; k < all.count; ++k) {
        const Polygon::Vertex &here = all[k], &next = all[(k + 1) % all.count];
        const double a = height(here.at), b = height(next.at);
        if (a >= -tiny) kept.add(here);
        if (!(a > tiny && b < -tiny) && !(a < -tiny && b > tiny)) continue;
        const Vec3 at = here.at + a / (a - b) * (next.at - here.at);
        kept.add({at, {weights_in_face(face, at)}});
    }
    return kept;
}

// Cuts a triangle. Each sector beyond its edge of the outline is a convex piece that stays. Triangles that only go
// along with a hole are split by the same rays, so that neighbours keep fitting.
bool Skin::cut(std::size_t i, const Outline& outline) {
    const double tiny = rounding * outline.radius;
    const Triangle before = triangles_[i];
    const int face = face_[i];
    Polygon whole;
    whole.add({before.a, corners_[i][0]}), whole.add({before.b, corners_[i][1]}), whole.add({before.c, corners_[i][2]});
    const auto area = [&](const Polygon& p, std::size_t k) {
        return std::abs(outline.direction.dot((p[k - 1].at - p[0].at).cross(p[k].at - p[0].at)));
    };
    const double no_area = tiny * outline.radius;
    Polygon about = whole;
    for (std::size_t edge = 0; edge < 8; ++edge)
        about = clipped(about, face, tiny,
                        [&](const Vec3& at) { return (fade - 1) * outline.radius - outline.beyond(edge, at); });
    double reach = fade * outline.radius, near = 0;
    for (std::size_t k = 0; k < about.count; ++k) reach = std::min(reach, outline.height(about[k].at));
    for (std::size_t k = 2; k < about.count; ++k) near += area(about, k);
    if (near <= no_area || reach >= fade * outline.radius) return false;
    for (std::size_t edge = 0; edge < 8; ++edge) {
        Polygon piece =
            clipped(whole, face, tiny, [&](const Vec3& at) { return outline.left_of_ray((edge + 7) % 8, at); });
        piece = clipped(piece, face, tiny, [&](const Vec3& at) { return -outline.left_of_ray(edge, at); });
        piece = clipped(piece, face, tiny, [&](const Vec3& at) { return outline.beyond(edge, at); });
        for (std::size_t k = 2; k < piece.count; ++k) {
            if (area(piece, k) <= no_area) continue;
            Eigen::Matrix3d weights;
            weights << weights_in(before, piece[0].at), weights_in(before, piece[k - 1].at),
                weights_in(before, piece[k].at);
            parts_.push_back({parts_[i].of, parts_[i].weights * weights});
            triangles_.push_back({piece[0].at, piece[k - 1].at, piece[k].at});
            corners_.push_back({piece[0].corner, piece[k - 1].corner, piece[k].corner});
            face_.push_back(face);
        }
    }
    return true;
}

// Corners near a new hole go along with it. A corner that goes along with another hole stays with that one, unless it
// is on the new one's rim.
void Skin::anchor(int hole, const Outline& outline) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const std::array<Vec3, 3> at{triangles_[i].a, triangles_[i].b, triangles_[i].c};
        for (std::size_t k = 0; k < 3; ++k) {
            Corner& corner = corners_[i][k];
            const double radii = outline.radii(at[k]);
            const bool rim = radii <= 1 + 4 * rounding;
            if (radii >= fade || (corner.hole >= 0 && !rim)) continue;
            corner.hole = hole;
            corner.share = rim ? 1 : (fade - radii) / (fade - 1);
            corner.offset = holes_.back().frame.transpose() * (at[k] - outline.centre);
        }
    }
}

// A hole is cut out of the wall as it is at rest: the dimple in which it is pierced does not stay, and a rim of its
// shape would stand out of the wall.
int Skin::pierce(int face, const Vec3& point, const Vec3& direction_now, double radius) {
    assert(face >= 0 && index(face) < faces_.size() && radius > 0 && "a hole in a face of this wall");
    Hole& hole = holes_.emplace_back(Hole{face, radius, weights_in_face(face, point)});
    place(hole);
    const Vec3 in_frame = hole.frame.transpose() * direction_now;
    pierced_at_.assign(nodes_.begin(), nodes_.end());
    std::vector<Wire> wires = std::exchange(wires_, {});
    update(rest_);
    const Vec3 up = hole.frame.col(2), direction = hole.frame * in_frame;
    const double steep = direction.dot(up),
                 most_aslant = std::sqrt(1 / (least_steep * least_steep) - 1) * std::abs(steep);
    const Vec3 aslant = direction - steep * up;
    const double bend = aslant.norm() > most_aslant ? most_aslant / aslant.norm() : 1;
    const Vec3 through = steep == 0 ? up : Vec3((steep * up + bend * aslant).normalized());
    const Vec3 x = (hole.frame.col(0) - through.dot(hole.frame.col(0)) * through).normalized();
    const Outline outline{hole.centre, through, x, through.cross(x), up, radius};
    open(outline);
    anchor(holes() - 1, outline);
    hole.direction = hole.frame.transpose() * through;
    wires_ = std::move(wires);
    update(pierced_at_);
    return holes() - 1;
}

void Skin::open(const Outline& outline) {
    ++openings_;
    const std::size_t count = triangles_.size();
    for (std::size_t i = 0; i < count; ++i)
        if (normal(static_cast<int>(i)).dot(outline.direction) * outline.up.dot(outline.direction) > 0 &&
            cut(i, outline))
            face_[i] = -1;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        if (face_[i] < 0) continue;
        triangles_[kept] = triangles_[i], corners_[kept] = corners_[i], face_[kept] = face_[i],
        parts_[kept] = parts_[i];
        ++kept;
    }
    triangles_.resize(kept), corners_.resize(kept), face_.resize(kept), parts_.resize(kept), boxes_.resize(kept);
    for (std::size_t i = 0; i < kept; ++i) set_box(i);
}

// A slit is cut out of the wall at rest as a hole is. Nothing goes along with it: a rim as long as this is not rigid.
void Skin::slit(int face, const Vec3& from, const Vec3& to, double radius) {
    assert(face >= 0 && index(face) < faces_.size() && radius > 0 && "a slit in a face of this wall");
    pierced_at_.assign(nodes_.begin(), nodes_.end());
    std::vector<Wire> wires = std::exchange(wires_, {});
    update(rest_);
    const Vec3 up = normal_of_face(face), span = to - from, along = span - span.dot(up) * up;
    const double length = along.norm();
    const Vec3 x = length > 0 ? Vec3(along / length) : Vec3((node(face, 1) - node(face, 0)).normalized());
    open({from, up, x, up.cross(x), up, radius, length});
    wires_ = std::move(wires);
    update(pierced_at_);
}

}  // namespace tissue
