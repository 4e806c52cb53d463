#include "tissue/hash.hpp"

namespace tissue {

void add_to(Hash& hash, const MaterialPoint& point) {
    hash.add(point.tetrahedron, point.weights);
}
void add_to(Hash& hash, const Hold& hold) {
    hash.add(hold.node, hold.target, hold.along);
}
void add_to(Hash& hash, const PointForce& force) {
    hash.add(force.at, force.force, force.stiffness, force.along);
}
void add_to(Hash& hash, const BiteEnd& end) {
    hash.add(end.hole, end.at, end.side, end.force, end.caved_in);
}
void add_to(Hash& hash, const Bite& bite) {
    hash.add(bite.state, bite.entry, bite.exit, bite.depth, bite.angle_to_wall, bite.angle_to_axis, bite.pass,
             bite.on_needle, bite.torn, bite.both_walls);
}

static void add_lane(Hash& hash, const Lane& lane) {
    for (std::size_t k = 0; k < 4; ++k) hash.add(lane[k]);
}
static void add_volumes(Hash& hash, const std::vector<Volumes>& of_cells) {
    for (const Volumes& volumes : of_cells) {
        add_lane(hash, volumes.value);
        for (const Lanes& by_node : volumes.gradient)
            for (const Lane* lane : {&by_node.x, &by_node.y, &by_node.z}) add_lane(hash, *lane);
    }
}

// The matrix at work, its factors so far, and those that solves use.
void add_to(Hash& hash, const BlockMatrix& matrix) {
    for (const auto& columns : matrix.next_)
        for (const Lane& column : columns) add_lane(hash, column);
    hash.add(matrix.at_, matrix.positive_, matrix.finished_.numbers, matrix.factors_.numbers);
}

void add_to(Hash& hash, const Tissue& wall) {
    hash.add(wall.x_, wall.v_, wall.residual_, wall.direction_, wall.last_residual_, wall.last_product_);
    for (const Lane& swelling : wall.swelling_) add_lane(hash, swelling);
    hash.add(wall.matrix_, wall.used_stiff_, wall.factored_stiff_, wall.factored_x_, wall.factored_free_,
             wall.factored_rate_, wall.factored_drag_, wall.assembled_, wall.factoring_, wall.have_factors_,
             wall.whole_);
    for (const Lane& pressure : wall.factored_pressure_) add_lane(hash, pressure);
    add_volumes(hash, wall.used_volumes_);
    add_volumes(hash, wall.factored_volumes_);
}

void add_to(Hash& hash, const Skin& skin) {
    hash.add(skin.nodes_, skin.triangles_, skin.face_, skin.openings_);
    for (const Part& part : skin.parts_) hash.add(part.of, part.weights);
    for (const auto& corners : skin.corners_)
        for (const Skin::Corner& corner : corners) hash.add(corner.weights, corner.hole, corner.share, corner.offset);
    for (const Skin::Hole& hole : skin.holes_)
        hash.add(hole.face, hole.radius, hole.weights, hole.centre, hole.frame, hole.direction, hole.aside,
                 hole.reshaped);
    for (const Skin::Wire& wire : skin.wires_) hash.add(wire.hole, wire.at, wire.along);
}

void add_to(Hash& hash, const Bites& bites) {
    const Bites::Touch& touch = bites.touch_;
    hash.add(bites.needle_, bites.has_needle_, bites.passes_, bites.slipped_at_, bites.bites_, bites.force_);
    hash.add(touch.active, touch.inwards, touch.face, touch.weights, touch.first_side, touch.first_normal,
             touch.first_direction, touch.tip, touch.force, touch.gone, touch.gain, touch.gives_way, touch.is_through);
    for (const Bites::Crossing& crossing : bites.crossings_)
        hash.add(crossing.bite, crossing.hole, crossing.along, crossing.held);
}

}  // namespace tissue
