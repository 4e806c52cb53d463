#include "scenarios/world/moving_wall.hpp"

#include <algorithm>
#include <map>

namespace scenarios::world {

using sim::geometry::Vec3;

static std::size_t at(int i) { return static_cast<std::size_t>(i); }

static std::array<const Vec3*, 3> corners_of(const Triangle& t) { return {&t.a, &t.b, &t.c}; }

MovingWall::MovingWall(std::vector<Triangle> triangles, double radius) : radius_(radius), tree_(triangles), moved_(std::move(triangles)) {
    number_corners();
    places_ = targets_;
}

void MovingWall::number_corners() {
    corners_.clear();
    targets_.clear();
    std::map<std::array<double, 3>, int> known;
    for (const Triangle& t : moved_) {
        auto& mine = corners_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = *corners_of(t)[k];
            const auto [found, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(targets_.size()));
            if (is_new) targets_.push_back(p);
            mine[k] = found->second;
        }
    }
    room_.resize(targets_.size()), ways_.resize(targets_.size());
}

void MovingWall::renew(std::vector<Triangle> triangles, std::span<const tissue::Part> parts) {
    const std::vector<Triangle> shown = moved_;
    moved_ = std::move(triangles);
    number_corners();
    places_.resize(targets_.size());
    for (std::size_t t = 0; t < moved_.size(); ++t) {
        const Triangle& whole = shown[at(parts[t].of)];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto weights = parts[t].weights.col(static_cast<Eigen::Index>(k));
            places_[at(corners_[t][k])] = weights.x() * whole.a + weights.y() * whole.b + weights.z() * whole.c;
        }
    }
    show();
    tree_ = sim::geometry::TriangleTree(moved_);
}

void MovingWall::show() {
    for (std::size_t t = 0; t < moved_.size(); ++t) moved_[t] = {places_[at(corners_[t][0])], places_[at(corners_[t][1])], places_[at(corners_[t][2])]};
}

// A thread that touches is pushed on by a fifth of its radius a tick, and no farther into than two fifths: what tools may press it.
double MovingWall::may_near(double width) const {
    constexpr double share = 0.45, left_at_least = 0.6;
    return share * std::max(0.0, width - left_at_least * radius_);
}

double MovingWall::follow(std::span<const Triangle> targets, std::span<const double> rooms, std::span<const sim::thread::SurfaceGap> near) {
    std::fill(room_.begin(), room_.end(), 1e300);
    for (std::size_t t = 0; t < targets.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = at(corners_[t][k]);
            targets_[corner] = *corners_of(targets[t])[k];
            room_[corner] = std::min(room_[corner], rooms[t]);
        }
    for (const sim::thread::SurfaceGap& gap : near)
        for (const int corner : corners_[at(gap.triangle)]) room_[at(corner)] = std::min(room_[at(corner)], std::max(gap.width, radius_));
    for (std::size_t c = 0; c < places_.size(); ++c) {
        const Vec3 way = targets_[c] - places_[c];
        const double far = way.norm(), may = may_near(room_[c]);
        ways_[c] = far > may ? Vec3(may / far * way) : way;
    }
    stop_at(near);
    double most = 0;
    for (std::size_t c = 0; c < places_.size(); ++c) {
        places_[c] = ways_[c] == targets_[c] - places_[c] ? targets_[c] : Vec3(places_[c] + ways_[c]);
        most = std::max(most, ways_[c].norm());
    }
    if (most == 0) return 0;
    show();
    tree_.move(moved_);
    return most;
}

// Along the thread, and away from it, corners go on; what several links leave of a way may be little.
void MovingWall::stop_at(std::span<const sim::thread::SurfaceGap> near) {
    const auto each = [&](const auto& stop) {
        for (const sim::thread::SurfaceGap& gap : near)
            for (const int corner : corners_[at(gap.triangle)]) {
                Vec3& way = ways_[at(corner)];
                const double nearer = -way.dot(gap.away), may = may_near(gap.width);
                if (nearer > may) stop(way, gap.away, nearer, may);
            }
    };
    constexpr int sweeps = 4;
    for (int i = 0; i < sweeps; ++i) each([](Vec3& way, const Vec3& away, double nearer, double may) { way += (nearer - may) * away; });
    each([](Vec3& way, const Vec3&, double nearer, double may) { way *= may / nearer; });
}

}  // namespace scenarios::world
