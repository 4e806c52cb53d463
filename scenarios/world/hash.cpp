// Two hashes: of the state that proves a replay, and of everything that is carried from tick to tick, for tests of
// copies.
#include "tissue/hash.hpp"

#include "instruments/hash.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::world {

using sim::geometry::Hash;

// Its words and their order are those of earlier recordings, so they stay.
std::uint64_t World::hash() const {
    Hash hash(thread_.hash());
    const auto add = [&](double value) { hash.add(value); };
    for (const Tool& tool : tools_) {
        for (const ToolInput* input : {&tool.now, &tool.asked}) {
            for (int c = 0; c < 3; ++c) add(input->pose.position[c]);
            for (int c = 0; c < 4; ++c) add(input->pose.rotation.coeffs()[c]);
        }
        add(tool.now.jaw);
        add(tool.closed);
        for (const Grasp& grasp : tool.grasps) {
            add(grasp.first);
            for (int k = 0; k < grasp.count(); ++k)
                for (int c = 0; c < 3; ++c) add(grasp.anchor[static_cast<std::size_t>(k)][c]);
        }
    }
    const auto add_place = [&](const Vec3& place) {
        for (int c = 0; c < 3; ++c) add(place[c]);
    };
    for (const SoftVessel& vessel : vessels()) {
        for (const Vec3& node : vessel.tissue.nodes()) add_place(node);
        for (int t = 0; t < vessel.skin.size(); ++t)
            add_place(walls_.tree()[vessel.first + t].a);  // what is shown may be behind the tissue
        for (const tissue::Bite& bite : vessel.bites.bites())
            add(static_cast<double>(bite.state) + 4 * bite.on_needle + 8 * bite.torn);
    }
    for (const Needle& needle : needles_) {
        for (const Vec3* of_needle : {&needle.now.centre, &needle.now.to_tail, &needle.now.onwards})
            add_place(*of_needle);
        for (const Holder* holder : {&needle.holder, &needle.next}) add(holder->tool);
        add(needle.bent);
    }
    for (const std::size_t needle : {taken_, in_use_})
        if (needle > 0) add(static_cast<double>(needle));
    for (const Tool& tool : tools_)
        for (const WallGrip& grip : tool.walls) add_place(grip.anchor);
    if (strength_.pulled_s > 0) add(strength_.pulled_s);
    for (const SoftVessel& vessel : vessels()) {
        for (const Vec3& pull : vessel.pulls) add_place(pull);
        for (const Vec3& pull : vessel.mean_pulls) add_place(pull);
        for (const sim::thread::Strength& strength : vessel.strengths)
            if (strength.pulled_s > 0) add(strength.pulled_s);
    }
    return hash.value();
}

static void add_to(Hash& hash, const sim::thread::Strength& strength) {
    hash.add(strength.force, strength.pulled_s);
}
static void add_to(Hash& hash, const Grasp& grasp) {
    hash.add(grasp.first, grasp.anchor);
}
static void add_to(Hash& hash, const WallGrip& grip) {
    hash.add(grip.vessel, grip.at, grip.anchor);
}
static void add_to(Hash& hash, const Tool& tool) {
    hash.add(tool.asked, tool.before, tool.now, tool.grasps, tool.closed, tool.stopped, tool.slipping, tool.walls,
             tool.held_up, tool.crosses);
}
static void add_to(Hash& hash, const Holder& holder) {
    hash.add(holder.tool, holder.seen, holder.along);
}
static void add_to(Hash& hash, const Needle& needle) {
    hash.add(needle.node, needle.before, needle.now, needle.holder, needle.next, needle.bent);
}
static void add_to(Hash& hash, const Press& press) {
    hash.add(press.at, press.hole, press.size, press.direction, press.gone);
}
static void add_to(Hash& hash, const Event& event) {
    hash.add(event.t_s, event.kind, event.what, event.value);
}
static void add_to(Hash& hash, const Moment& moment) {
    hash.add(moment.value, moment.at_s);
}
static void add_to(Hash& hash, const Worst& worst) {
    hash.add(worst.stretch, worst.separation, worst.step_over_bound, worst.contacts);
}

static void add_name(Hash& hash, const sim::knot::Name& name) {
    hash.add(name.knot, name.surgical, name.throws, name.crossings_projected, name.crossings_reduced, name.certain,
             name.candidates, name.flat, name.half_hitches);
    for (const sim::knot::Factor& factor : name.factors) hash.add(factor.name, factor.mirror, factor.crossings);
    for (const sim::knot::Throw& one : name.throw_list) hash.add(one.turns, one.right_handed);
}

// What ticks write of it; the rest judge() finds.
static void add_to(Hash& hash, const Measures& measures) {
    add_name(hash, measures.knot);
    hash.add(measures.hitched_to, measures.piece, measures.knot_since_s, measures.needle_deg, measures.duration_s,
             measures.path_mm, measures.grasps, measures.tension_max_N, measures.lag_max_mm, measures.pass_throughs,
             measures.first_pass_through_s, measures.broke_s, measures.walls_crossed, measures.first_crossed_s);
}

static void add_to(Hash& hash, const SoftVessel& vessel) {
    hash.add(vessel.tissue, vessel.skin, vessel.bites, vessel.clamps, vessel.side, vessel.to_jaw.matrix(),
             vessel.carried.matrix(), vessel.forces, vessel.presses, vessel.pulls, vessel.mean_pulls);
    for (const sim::thread::Strength& strength : vessel.strengths) add_to(hash, strength);
    hash.add(vessel.bitten_s, vessel.first);
}

void add_to(Hash& hash, const MovingWall& wall) {
    hash.add(wall.tree_.triangles(), wall.corners_, wall.hole_, wall.places_, wall.moved_);
}

void add_to(Hash& hash, const Walls& walls) {
    hash.add(walls.vessels_, walls.shown_, walls.targets_, walls.is_new_, walls.moved_);
}

static void add_named(Hash& hash, const std::vector<NamedPiece>& pieces) {
    for (const NamedPiece& piece : pieces) {
        hash.add(piece.curve, piece.tied.round);
        add_name(hash, piece.tied.name);
    }
}

void add_to(Hash& hash, const KnotWatch& watch) {
    hash.add(watch.moved_, watch.naming_.valid(), watch.named_.size());
    if (watch.naming_.valid()) add_named(hash, watch.naming_.get());
    add_named(hash, watch.named_);
}

std::uint64_t World::hash_of_all_carried() const {
    Hash hash;
    hash.add(thread_.hash_of_all_carried(), walls_, tool_world_, tools_, needles_, taken_, in_use_);
    add_to(hash, strength_);
    hash.add(events_, measures_, worst_, ticks_, substeps_, tension_now_, stretch_now_, knot_watch_);
    return hash.value();
}

}  // namespace scenarios::world
