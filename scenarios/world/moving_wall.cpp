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
    room_.resize(targets_.size());
    ways_.resize(targets_.size());
}

void MovingWall::renew(std::vector<Triangle> triangles) {
    const std::vector<Vec3> were = targets_, shown = places_;
    std::map<std::array<double, 3>, std::size_t> known;
    for (std::size_t c = 0; c < were.size(); ++c) known[{were[c].x(), were[c].y(), were[c].z()}] = c;
    moved_ = std::move(triangles);
    number_corners();
    places_.clear();
    for (const Vec3& target : targets_) {
        const auto nearer = [&](const Vec3& a, const Vec3& b) { return (a - target).squaredNorm() < (b - target).squaredNorm(); };
        const auto same = known.find({target.x(), target.y(), target.z()});
        const std::size_t nearest = same != known.end() ? same->second : static_cast<std::size_t>(std::min_element(were.begin(), were.end(), nearer) - were.begin());
        places_.push_back(target + (shown[nearest] - were[nearest]));
    }
    show();
    tree_ = sim::geometry::TriangleTree(moved_);
}

void MovingWall::show() {
    for (std::size_t t = 0; t < moved_.size(); ++t) moved_[t] = {places_[at(corners_[t][0])], places_[at(corners_[t][1])], places_[at(corners_[t][2])]};
}

// What of a way comes nearer by more than it may is left out; the rest slides.
static void hold_off(Vec3& way, const Vec3& normal, double may) {
    if (const double nearer = way.dot(normal); nearer > may) way -= (nearer - may) * normal;
}

double MovingWall::follow(std::span<const Triangle> targets, std::span<const double> rooms, std::span<const sim::thread::SurfaceGap> gaps) {
    // A thread that touches is pushed on by a fifth of its radius a tick, and no farther into than two fifths: what tools may press it.
    constexpr double share = 0.45, left_at_least = 0.6;
    constexpr int sweeps = 3;  // a corner between links that look different ways; what is left after them shortens its way
    const auto may = [&](double room) { return share * std::max(0.0, room - left_at_least * radius_); };
    std::fill(room_.begin(), room_.end(), 1e300);
    for (std::size_t t = 0; t < targets.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = at(corners_[t][k]);
            targets_[corner] = *corners_of(targets[t])[k];
            room_[corner] = std::min(room_[corner], rooms[t]);
        }
    for (std::size_t c = 0; c < places_.size(); ++c) ways_[c] = targets_[c] - places_[c];
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const auto& gap : gaps)
            for (const int corner : corners_[at(gap.triangle)]) hold_off(ways_[at(corner)], gap.normal, may(gap.gap));
    for (const auto& gap : gaps)
        for (const int corner : corners_[at(gap.triangle)])
            if (const double nearer = ways_[at(corner)].dot(gap.normal); nearer > may(gap.gap)) ways_[at(corner)] *= may(gap.gap) / nearer;
    double most = 0;
    for (std::size_t c = 0; c < places_.size(); ++c) {
        const double far = ways_[c].norm(), most_here = may(room_[c]);
        places_[c] += far > most_here ? Vec3(most_here / far * ways_[c]) : ways_[c];
        most = std::max(most, std::min(far, most_here));
    }
    if (most == 0) return 0;
    show();
    tree_.move(moved_);
    return most;
}

}  // namespace scenarios::world
