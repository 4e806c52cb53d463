// The state that proves a replay. Its words and their order are those of earlier recordings, so they stay.
#include <bit>

#include "scenarios/world/world.hpp"

namespace scenarios::world {

std::uint64_t World::hash() const {
    std::uint64_t hash = thread_.hash();
    const auto add = [&](double value) { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u; };
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
    return hash;
}

}  // namespace scenarios::world
