// What helps to see depth on a flat screen. Everything is found in the picture itself.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/draw/camera.hpp"
#include "app/draw/scene.hpp"

namespace app::draw {
namespace {

using sim::geometry::Capsule;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of Okabe and Ito.
Eigen::Vector4f color(int red, int green, int blue, float opacity) {
    return {static_cast<float>(red) / 255, static_cast<float>(green) / 255, static_cast<float>(blue) / 255, opacity};
}
Eigen::Vector4f sky_blue(float opacity) {
    return color(86, 180, 233, opacity);
}
Eigen::Vector4f yellow(float opacity) {
    return color(240, 228, 66, opacity);
}
Eigen::Vector4f orange(float opacity) {
    return color(230, 159, 0, opacity);
}
Eigen::Vector4f green(float opacity) {
    return color(0, 158, 115, opacity);
}
Eigen::Vector4f vermillion(float opacity) {
    return color(213, 94, 0, opacity);
}

std::array<Capsule, 2> jaws_of(const ToolPicture& tool) {
    const auto parts = instruments::parts_at(instruments::shape_of(tool.kind), tool.pose, tool.jaw);
    return {parts[instruments::jaw_plus], parts[instruments::jaw_minus]};
}

bool is_of_a_hand(const ToolPicture& tool) {
    return tool.kind != instruments::Kind::approximator;
}

Vec3 mouth_of(const ToolPicture& tool) {
    const auto [plus, minus] = jaws_of(tool);
    return (plus.b + minus.b) / 2;
}

/// How far a point is from a line of pieces, and where on it.
struct Nearest {
    double distance = infinity;
    Vec3 at = Vec3::Zero();
    void consider(const Vec3& point, double off) {
        if (off < distance) distance = off, at = point;
    }
};

Vec3 nearest_on(const Vec3& a, const Vec3& b, const Vec3& p) {
    const double length = (b - a).squaredNorm();
    return length > 0 ? Vec3(a + std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) * (b - a)) : a;
}

void consider_lines(const std::vector<std::vector<Vec3>>& lines, double radius, const Vec3& p, Nearest& nearest) {
    for (const auto& line : lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Vec3 on = nearest_on(line[i], line[i + 1], p);
            nearest.consider(on, (on - p).norm() - radius);
        }
}

/// By the corners and, where one is near, the faces' planes: a wall's cells are smaller than what is asked for.
void consider_vessel(const assets::Mesh& mesh, const Vec3& p, Nearest& nearest) {
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 &pa = mesh.vertices[a], &pb = mesh.vertices[b], &pc = mesh.vertices[c];
        const double reach = std::max((pb - pa).norm(), (pc - pa).norm());
        if ((p - pa).norm() - reach > nearest.distance) continue;
        for (const Vec3& on : {nearest_on(pa, pb, p), nearest_on(pb, pc, p), nearest_on(pc, pa, p)})
            nearest.consider(on, (on - p).norm());
        const Vec3 normal = (pb - pa).cross(pc - pa), foot = p - normal * (normal.dot(p - pa) / normal.squaredNorm());
        const bool inside = normal.dot((pb - pa).cross(foot - pa)) >= 0 &&
                            normal.dot((pc - pb).cross(foot - pb)) >= 0 && normal.dot((pa - pc).cross(foot - pc)) >= 0;
        if (inside) nearest.consider(foot, (foot - p).norm());
    }
}

Nearest nearest_to(const Picture& picture, const Vec3& p) {
    Nearest nearest;
    consider_lines(picture.thread, picture.thread_radius, p, nearest);
    consider_lines(picture.needles, picture.needle_radius, p, nearest);
    for (const assets::Mesh& vessel : picture.vessels) consider_vessel(vessel, p, nearest);
    return nearest;
}

/// A place on a surface, and the way out of it.
struct Place {
    Vec3 at, normal;
};

/// What lies under a point: a vessel, the drape, or nothing.
std::optional<Place> under(const Picture& picture, const Vec3& p) {
    double highest = picture.drape && *picture.drape < p.z() ? *picture.drape : -infinity;
    Vec3 normal = Vec3::UnitZ();
    for (const assets::Mesh& mesh : picture.vessels)
        for (const auto& [a, b, c] : mesh.triangles) {
            const Eigen::Vector2d pa = (mesh.vertices[a] - p).head<2>(), pb = (mesh.vertices[b] - p).head<2>(),
                                  pc = (mesh.vertices[c] - p).head<2>();
            const auto cross = [](const Eigen::Vector2d& x, const Eigen::Vector2d& y) {
                return x.x() * y.y() - x.y() * y.x();
            };
            const double u = cross(pb, pc), v = cross(pc, pa), w = cross(pa, pb), sum = u + v + w;
            if (u <= 0 || v <= 0 || w <= 0) continue;  // seen from above it would be clockwise, or is beside
            const Vec3 &qa = mesh.vertices[a], &qb = mesh.vertices[b], &qc = mesh.vertices[c];
            const double z = (u * qa.z() + v * qb.z() + w * qc.z()) / sum;
            if (z >= p.z() || z <= highest) continue;
            highest = z;
            normal = (qb - qa).cross(qc - qa).normalized();
        }
    if (highest == -infinity) return {};
    return Place{Vec3(p.x(), p.y(), highest), normal};
}

/// Nodes of one piece that a tool's closed jaws hold: the middle one.
std::optional<std::size_t> held_node(const Picture& picture, const std::vector<Vec3>& piece, const ToolPicture& tool) {
    constexpr double closed = 0.15, slack = 0.1e-3;  // [m]
    if (!is_of_a_hand(tool) || tool.jaw > closed) return {};
    const auto [plus, minus] = jaws_of(tool);
    const Vec3 root = (plus.a + minus.a) / 2, tip = (plus.b + minus.b) / 2;
    std::optional<std::size_t> found;
    double nearest = picture.thread_radius + plus.radius + slack;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const double off = (nearest_on(root, tip, piece[i]) - piece[i]).norm();
        if (off < nearest) nearest = off, found = i;
    }
    return found;
}

/// Green when slack, then orange, vermillion near breaking.
Eigen::Vector4f color_of_tension(double share) {
    const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
    return s < 0.5f ? Eigen::Vector4f(green(0.9f) + 2 * s * (orange(0.9f) - green(0.9f)))
                    : Eigen::Vector4f(orange(0.9f) + (2 * s - 1) * (vermillion(0.9f) - orange(0.9f)));
}

class Marker {
  public:
    explicit Marker(const Picture& picture)
        : picture_(picture), pixel_(2 * half_height(picture.camera) / picture.height), axes_(axes_of(picture.camera)) {}
    /// Size of so many pixels at a place [m].
    double pixels(double count, const Vec3& at) const {
        return count * pixel_ * std::max(project(picture_, at).z(), 0.0);
    }
    void add(const Surface& surface, const Eigen::Vector4f& tint, float soft, bool on_top) {
        marks.marks.push_back({tint, soft, on_top, marks.surface.indices.size(), surface.indices.size()});
        marks.surface.add(surface);
    }
    void line(const std::vector<Vec3>& points, double radius, double least_pixels, const Eigen::Vector4f& tint,
              bool on_top) {
        const auto wide = [&](const Vec3& p) { return std::max(radius, pixels(least_pixels, p)); };
        add(tube(points, wide, {.around = 6, .cap_rings = 2, .pieces = 1}), tint, 0, on_top);
    }
    void ball(const Vec3& at, double radius, double least_pixels, const Eigen::Vector4f& tint, float soft = 1) {
        const double wide = std::max(radius, pixels(least_pixels, at));
        add(tube({at}, [&](const Vec3&) { return wide; }, {.around = 24, .cap_rings = 8}), tint, soft, false);
    }
    /// A circle that faces the eye.
    void circle(const Vec3& centre, double radius, double wide_pixels, const Eigen::Vector4f& tint) {
        constexpr int sides = 48;
        std::vector<Vec3> points;
        for (int k = 0; k <= sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            points.push_back(centre +
                             radius * (std::cos(angle) * axes_.row(0) + std::sin(angle) * axes_.row(1)).transpose());
        }
        line(points, 0, wide_pixels, tint, true);
    }
    /// A disc that lies on a surface.
    void disc(const Place& place, double radius, const Eigen::Vector4f& tint) {
        constexpr unsigned sides = 24;
        Surface surface;
        const Vec3 middle = place.at + 0.1e-3 * place.normal, u = place.normal.unitOrthogonal(),
                   v = place.normal.cross(u);
        const Eigen::Vector3f normal = place.normal.cast<float>();
        surface.vertices.push_back({middle.cast<float>(), normal});
        for (unsigned k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            const Vec3 rim = middle + radius * (std::cos(angle) * u + std::sin(angle) * v);
            surface.vertices.push_back({rim.cast<float>(), normal});
            for (const unsigned i : {0u, 1 + k, 1 + (k + 1) % sides}) surface.indices.push_back(i);
        }
        add(surface, tint, 0, false);
    }
    Marks marks;

  private:
    const Picture& picture_;
    double pixel_;
    Eigen::Matrix3d axes_;
};

void mark_plumb_from(const Picture& picture, const Vec3& point, Marker& marker) {
    const auto below = under(picture, point);
    if (!below) return;
    marker.disc(*below, 0.6e-3, color(0, 0, 0, 0.45f));
    marker.line({point, below->at}, 0, 0.8, color(20, 20, 20, 0.55f), false);
}

void mark_plumb(const Picture& picture, Marker& marker) {
    for (const ToolPicture& tool : picture.tools)
        if (is_of_a_hand(tool)) mark_plumb_from(picture, mouth_of(tool), marker);
}

// A ball with a bright middle: its edge alone would be lost on the cloth.
void mark_places(const Picture& picture, Marker& marker) {
    for (const Ball& place : picture.helps.places) {
        mark_plumb_from(picture, place.centre, marker);
        marker.ball(place.centre, place.radius, 4, sky_blue(0.3f), 0);
        marker.ball(place.centre, place.radius / 5, 3, yellow(0.9f));
    }
}

// Blue from afar, orange below 1 mm, green where it is 0; its width grows as it narrows.
void mark_ring(const Picture& picture, Marker& marker) {
    const auto number = static_cast<std::size_t>(picture.helps.ring_tool);
    if (picture.helps.ring_tool < 0 || number >= picture.tools.size()) return;
    constexpr double widest = 5e-3, near = 1e-3, least = 0.35e-3;  // [m]
    const double wide = gap(picture, number);
    if (wide >= widest) return;
    const Eigen::Vector4f tint = wide <= 0.05e-3 ? green(0.95f) : wide < near ? orange(0.9f) : sky_blue(0.8f);
    marker.circle(mouth_of(picture.tools[number]), std::max(wide, least), 1.2 + 1.5 * (1 - wide / widest), tint);
}

void mark_contacts(const Picture& picture, Marker& marker) {
    constexpr double touching = 0.08e-3;  // [m]
    for (const ToolPicture& tool : picture.tools) {
        if (!is_of_a_hand(tool)) continue;
        Nearest found;
        double radius = 0;
        for (const Capsule& jaw : jaws_of(tool))
            for (const double share : {0.6, 0.8, 1.0}) {
                const Nearest near = nearest_to(picture, jaw.a + share * (jaw.b - jaw.a));
                found.consider(near.at, near.distance - jaw.radius), radius = jaw.radius;
            }
        if (found.distance < touching) marker.ball(found.at, 2.2 * radius, 5, yellow(0.75f));
    }
}

void mark_strand(const Picture& picture, Marker& marker) {
    for (const auto& piece : picture.thread) {
        std::vector<std::size_t> held;
        for (const ToolPicture& tool : picture.tools)
            if (const auto node = held_node(picture, piece, tool)) held.push_back(*node);
        std::sort(held.begin(), held.end());
        for (std::size_t i = 0; i + 1 < held.size(); ++i) {
            if (held[i] == held[i + 1]) continue;
            const std::vector<Vec3> strand(piece.begin() + static_cast<std::ptrdiff_t>(held[i]),
                                           piece.begin() + static_cast<std::ptrdiff_t>(held[i + 1]) + 1);
            const double share = std::clamp(picture.helps.tension, 0.0, 1.0), wider = 1.15 + share;
            marker.line(strand, wider * picture.thread_radius, 1.9 * wider, color_of_tension(share), false);
        }
    }
}

void mark_candidate(const Picture& picture, Marker& marker) {
    const std::vector<Vec3>& line = picture.helps.candidate;
    if (line.size() == 1) marker.ball(line.front(), 4 * picture.thread_radius, 7, yellow(0.8f));
    if (line.size() > 1) marker.line(line, 1.6 * picture.thread_radius, 2.8, yellow(0.85f), false);
}

}  // namespace

double gap(const Picture& picture, std::size_t tool) {
    return std::max(0.0, nearest_to(picture, mouth_of(picture.tools[tool])).distance);
}

Marks marks_of(const Picture& picture) {
    Marker marker(picture);
    if (picture.helps.plumb) mark_plumb(picture, marker);
    mark_places(picture, marker);
    if (picture.helps.strand) mark_strand(picture, marker);
    mark_candidate(picture, marker);
    if (picture.helps.contact) mark_contacts(picture, marker);
    mark_ring(picture, marker);
    return std::move(marker.marks);
}

}  // namespace app::draw
