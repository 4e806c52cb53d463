#include "app/commands/tool_starts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/fault.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"

namespace app {

namespace {

using sim::geometry::Box;
using sim::geometry::Capsule;
using sim::geometry::Triangle;
using sim::geometry::Vec3;

// Every edge is one triangle's one way and another's the other way.
bool is_closed(const assets::Mesh& mesh) {
    std::map<std::array<int, 2>, int> open;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            open[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    return std::all_of(open.begin(), open.end(), [](const auto& edge) { return edge.second == 0; });
}

// The solid angle that a triangle takes up, seen from a point [sr] [van Oosterom and Strackee 1983].
double solid_angle(const Triangle& t, const Vec3& from) {
    const Vec3 a = t.a - from, b = t.b - from, c = t.c - from;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

class Vessel {
  public:
    Vessel(const assets::Mesh& mesh, std::string name)
        : name_(std::move(name)), tree_(mesh.soup()), is_closed_(is_closed(mesh)) {}

    const std::string& name() const { return name_; }

    bool holds(const Capsule& part) const { return touches(part) || (is_closed_ && encloses(part.a)); }

  private:
    bool touches(const Capsule& part) const {
        Box box;
        for (const Vec3& end : {part.a, part.b})
            for (const double side : {-part.radius, part.radius}) box.include(end + side * Vec3::Ones());
        std::vector<int> near;
        tree_.near(box, near);
        return std::any_of(near.begin(), near.end(), [&](int i) {
            return sim::geometry::closest_points(part.a, part.b, tree_[i]).distance_squared < part.radius * part.radius;
        });
    }

    // A closed surface takes up the whole sphere seen from inside, and nothing seen from outside.
    bool encloses(const Vec3& point) const {
        double seen = 0;
        for (const Triangle& t : tree_.triangles()) seen += solid_angle(t, point);
        return std::abs(seen) > 2 * std::numbers::pi;
    }

    std::string name_;
    sim::geometry::TriangleTree tree_;
    bool is_closed_;
};

// "shaft", "jaws", "shaft and jaws"; empty: none.
std::string parts_in(const Vessel& vessel, instruments::Kind kind, const instruments::ToolInput& start) {
    const auto parts = instruments::parts_at(instruments::shape_of(kind), start.pose, start.jaw);
    const bool shaft = vessel.holds(parts[instruments::shaft]);
    const bool jaws = vessel.holds(parts[instruments::jaw_plus]) || vessel.holds(parts[instruments::jaw_minus]);
    return std::string(shaft ? "shaft" : "") + (shaft && jaws ? " and " : "") + (jaws ? "jaws" : "");
}

}  // namespace

void check_tool_starts(const scenarios::drill::Drill& drill, const std::vector<assets::Mesh>& rigid,
                       std::span<const instruments::ToolInput> start, const std::string& motion_file) {
    std::vector<Vessel> vessels;
    for (const auto& vessel : drill.world.vessels)
        if (!vessel.is_soft) vessels.emplace_back(rigid[vessels.size()], vessel.name);
    for (std::size_t i = 0; i < start.size(); ++i)
        for (const Vessel& vessel : vessels) {
            const auto& tool = drill.world.instruments[i];
            const std::string parts = parts_in(vessel, tool.kind, start[i]);
            if (!parts.empty())
                throw InputFault(motion_file + ": error: the " + parts + " of \"" + tool.name +
                                 "\" start in the rigid vessel \"" + vessel.name() +
                                 "\", which would hold it fast, expected to start clear of it: places in mm, and a "
                                 "rotation that lays the shaft, behind the jaws along -z, outside");
        }
}

}  // namespace app
