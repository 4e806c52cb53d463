// Walls come after their tissue as fast as the thread makes room: once a tick each corner's displacement is projected
// onto what all strands near it allow, the nearest point of a convex set, by Hildreth's method (Hildreth 1957;
// Dykstra's projections on half spaces).
#include "scenarios/world/moving_wall.hpp"

#include <algorithm>
#include <cassert>
#include <map>

#include "sim/geometry/at.hpp"

namespace scenarios::world {

using sim::at;
using sim::geometry::Vec3;

static std::array<const Vec3*, 3> corners_of(const Triangle& t) {
    return {&t.a, &t.b, &t.c};
}

MovingWall::MovingWall(std::vector<Triangle> triangles, double radius)
    : radius_(radius), tree_(triangles), moved_(std::move(triangles)) {
    number_corners(std::vector<Holes>(moved_.size(), {-1, -1, -1}));
    places_ = targets_;
}

void MovingWall::number_corners(const std::vector<Holes>& holes) {
    corners_.clear();
    targets_.clear();
    hole_.clear();
    std::map<std::array<double, 3>, int> known;
    for (std::size_t t = 0; t < moved_.size(); ++t) {
        auto& mine = corners_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = *corners_of(moved_[t])[k];
            const auto [found, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(targets_.size()));
            if (is_new) targets_.push_back(p), hole_.push_back(holes[t][k]);
            mine[k] = found->second;
        }
    }
    room_.resize(targets_.size());
    steps_.resize(targets_.size());
    share_.resize(hole_.empty() ? 0 : static_cast<std::size_t>(1 + *std::max_element(hole_.begin(), hole_.end())));
}

void MovingWall::renew(std::vector<Triangle> triangles, std::span<const tissue::Part> parts,
                       const std::vector<Holes>& holes) {
    assert(parts.size() == triangles.size() && holes.size() == triangles.size() && "one of each for each triangle");
    const std::vector<Triangle> shown = moved_;
    moved_ = std::move(triangles);
    number_corners(holes);
    places_.resize(targets_.size());
    for (std::size_t t = 0; t < moved_.size(); ++t) {
        const Triangle& whole = shown[at(parts[t].of)];
        for (std::size_t k = 0; k < 3; ++k)
            places_[at(corners_[t][k])] = tissue::point_in(whole, parts[t].weights.col(static_cast<Eigen::Index>(k)));
    }
    show();
    tree_ = sim::geometry::TriangleTree(moved_);
}

void MovingWall::show() {
    for (std::size_t t = 0; t < moved_.size(); ++t)
        moved_[t] = {places_[at(corners_[t][0])], places_[at(corners_[t][1])], places_[at(corners_[t][2])]};
}

// How far a corner may come nearer to thread that is `room` off [m]. Thread that it touches is pushed on by a fifth of
// its radius a tick, and no farther into than two fifths: what tools may press it.
double MovingWall::most_step(double room) const {
    constexpr double share = 0.45, left_at_least = 0.6;
    return share * std::max(0.0, room - left_at_least * radius_);
}

void MovingWall::move_holes(std::span<const sim::thread::SurfaceGap> gaps) {
    std::fill(share_.begin(), share_.end(), 1.0);
    const auto shorten = [&](std::size_t corner, double step, double most) {
        if (hole_[corner] >= 0 && step > most)
            share_[at(hole_[corner])] = std::min(share_[at(hole_[corner])], most / step);
    };
    for (std::size_t c = 0; c < steps_.size(); ++c) shorten(c, steps_[c].norm(), most_step(room_[c]));
    for (const auto& gap : gaps)
        for (const int corner : corners_[at(gap.triangle)])
            shorten(at(corner), steps_[at(corner)].dot(gap.normal), most_step(gap.gap));
    for (std::size_t c = 0; c < steps_.size(); ++c)
        if (hole_[c] >= 0) steps_[c] *= share_[at(hole_[c])];
}

// The part of a step that comes nearer to a strand than it may is left out; the rest slides. That is the displacement
// nearest to the one asked for that no strand forbids, found by Hildreth's method: what each strand took is remembered
// and returned where others take it. Without that, strands on all sides, as in a knot, turn a corner's step round one
// after the other, and the corner runs off.
void MovingWall::move_rest(std::span<const sim::thread::SurfaceGap> gaps) {
    constexpr int sweeps = 6;  // after them a step that still comes too near is shortened
    taken_.assign(3 * gaps.size(), 0);
    for (int sweep = 0; sweep <= sweeps; ++sweep)
        for (std::size_t g = 0; g < gaps.size(); ++g)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t corner = at(corners_[at(gaps[g].triangle)][k]);
                if (hole_[corner] >= 0) continue;
                Vec3& step = steps_[corner];
                const double nearer = step.dot(gaps[g].normal), most = most_step(gaps[g].gap);
                double& taken = taken_[3 * g + k];
                const double more = std::max(-taken, nearer - most);
                if (sweep < sweeps)
                    step -= more * gaps[g].normal, taken += more;
                else if (nearer > most)
                    step *= most / nearer;
            }
}

double MovingWall::follow(std::span<const Triangle> targets, std::span<const double> rooms,
                          std::span<const sim::thread::SurfaceGap> gaps) {
    assert(targets.size() == moved_.size() && rooms.size() == moved_.size() && "one of each for each triangle");
    std::fill(room_.begin(), room_.end(), 1e300);
    for (std::size_t t = 0; t < targets.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = at(corners_[t][k]);
            targets_[corner] = *corners_of(targets[t])[k];
            room_[corner] = std::min(room_[corner], rooms[t]);
        }
    for (std::size_t c = 0; c < places_.size(); ++c) steps_[c] = targets_[c] - places_[c];
    move_holes(gaps);
    move_rest(gaps);
    double most = 0;
    for (std::size_t c = 0; c < places_.size(); ++c) {
        if (steps_[c].dot(targets_[c] - places_[c]) <= 0) continue;  // it is still turned round
        const double far = steps_[c].norm(), most_here = most_step(room_[c]),
                     share = far > most_here ? most_here / far : 1;
        places_[c] += share * steps_[c];
        most = std::max(most, share * far);
    }
    if (most == 0) return 0;
    show();
    tree_.move(moved_);
    return most;
}

}  // namespace scenarios::world
