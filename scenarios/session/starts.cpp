#include "scenarios/session/starts.hpp"

#include <string>

#include "scenarios/session/fault.hpp"
#include "scenarios/world/soft_vessel.hpp"

namespace scenarios::session {

namespace {

using scenarios::world::VesselDef;
using scenarios::world::WorldDef;
using sim::geometry::Vec3;

bool holds(const tissue::Mesh& wall, const Vec3& point) {
    return tissue::is_in_wall(wall.tetrahedra, wall.nodes, point);
}

// At every diameter of the thread.
bool goes_through(const tissue::Mesh& wall, const Vec3& from, const Vec3& to, double diameter) {
    const int steps = 1 + static_cast<int>((to - from).norm() / diameter);
    for (int i = 0; i <= steps; ++i)
        if (holds(wall, from + static_cast<double>(i) / steps * (to - from))) return true;
    return false;
}

bool goes_through(const tissue::Mesh& wall, const sim::geometry::Arc& needle) {
    const int steps = 1 + static_cast<int>(needle.length() / needle.wire);
    for (int i = 0; i <= steps; ++i)
        if (holds(wall, needle.at(needle.length() * i / steps))) return true;
    return false;
}

// By cells' middles: ends that just touch are not in each other.
bool are_in_each_other(const tissue::Mesh& a, const tissue::Mesh& b) {
    for (const tissue::Tetrahedron& tet : a.tetrahedra) {
        Vec3 middle = Vec3::Zero();
        for (const int node : tet) middle += 0.25 * a.nodes[static_cast<std::size_t>(node)];
        if (holds(b, middle)) return true;
    }
    return false;
}

class Start {
  public:
    explicit Start(const WorldDef& def) : def_(def) {
        for (const VesselDef& vessel : def.vessels)
            walls_.push_back(vessel.is_soft && vessel.bitten.empty() ? scenarios::world::wall_of(vessel)
                                                                     : tissue::Mesh());
    }

    void check() const {
        for (std::size_t i = 0; i < walls_.size(); ++i) {
            check_thread(i, def_.thread.start, "/thread/");
            if (!def_.needle_code.empty()) check_needle(i, def_.needle, "/thread/");
            for (std::size_t k = 0; k < def_.spares.size(); ++k) {
                const std::string pointer = "/thread/spares/" + std::to_string(k) + "/";
                check_thread(i, def_.spares[k].start, pointer);
                check_needle(i, def_.spares[k].needle, pointer);
            }
            for (std::size_t k = 0; k < i; ++k)
                if (are_in_each_other(walls_[i], walls_[k]))
                    refuse(i, "it starts in the wall of \"" + def_.vessels[k].name +
                                  "\", expected a centre_mm apart from that");
        }
    }

  private:
    [[noreturn]] void refuse(std::size_t vessel, const std::string& what) const {
        throw InputFault("vessel \"" + def_.vessels[vessel].name + "\": error: /vessels/" + std::to_string(vessel) +
                         ": " + what);
    }

    void check_thread(std::size_t vessel, const std::vector<Vec3>& start, const std::string& pointer) const {
        for (std::size_t k = 0; k + 1 < start.size(); ++k)
            if (goes_through(walls_[vessel], start[k], start[k + 1], def_.thread.diameter))
                refuse(vessel, "the thread starts in its wall, behind corner " + std::to_string(k) + " of " + pointer +
                                   "start_mm, expected to start clear of it");
    }

    void check_needle(std::size_t vessel, const sim::geometry::Arc& needle, const std::string& pointer) const {
        if (goes_through(walls_[vessel], needle))
            refuse(vessel, "the needle of " + pointer + "needle starts in its wall, expected to start clear of it");
    }

    const WorldDef& def_;
    std::vector<tissue::Mesh> walls_;  // of a rigid one: none
};

}  // namespace

void check_soft_starts(const WorldDef& def) {
    Start(def).check();
}

}  // namespace scenarios::session
