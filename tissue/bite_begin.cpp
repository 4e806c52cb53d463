// Bites that a scene begins with.
#include <algorithm>
#include <cmath>

#include "tissue/bite.hpp"

namespace tissue {

void Bites::begin_with(const Vec3& from, const Vec3& to, Skin& skin) {
    ++passes_;
    const Vec3 direction = (to - from).normalized();
    Vec3 at = from;
    while (true) {
        const Skin::Spot in = skin.hit(at, to, Skin::Facing::against),
                         out = in.triangle < 0 ? in : skin.hit(in.at, to, Skin::Facing::along);
        if (out.triangle < 0) return;
        const int entry_face = skin.face(in.triangle), exit_face = skin.face(out.triangle);
        const auto end = [&](int face, const Vec3& place) {
            const int hole = skin.pierce(face, place, direction, def_.hole);
            return BiteEnd{hole, skin.point_of_hole(hole), skin.side_of_face(face), 0};
        };
        Bite bite;
        bite.state = BiteState::open, bite.pass = passes_, bite.on_needle = false;
        bite.entry = end(entry_face, in.at), bite.exit = end(exit_face, out.at);
        const double steep = std::abs(direction.dot(skin.normal_of_face(entry_face)));
        bite.depth = steep * (out.at - in.at).norm();
        bite.angle_to_wall = sim::geometry::portable_atan2(steep, std::sqrt(std::max(0.0, 1 - steep * steep)));
        if (at != from && !bites_.empty() && bites_.back().exit.side == Side::inner && bite.entry.side == Side::inner)
            bites_.back().both_walls = bite.both_walls = true;
        bites_.push_back(bite);
        at = out.at;
    }
}

}  // namespace tissue
