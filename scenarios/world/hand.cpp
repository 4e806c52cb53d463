#include "scenarios/world/world.hpp"

// A hand feels what it pulls, a motion file does not: with InstrumentDef::pull a tool gives way to a strand that pulls
// at it harder than that.
namespace scenarios::world {

// How much shorter the strand from this link on would be with `excess` less pull, as far as it pulls harder than
// `least`; a radius of the thread at most [m].
double World::stretch_by(double excess, int link, int outwards, double least) const {
    const int links = static_cast<int>(thread_.tension().size());
    const auto at = [](std::span<const double> values, int k) { return values[static_cast<std::size_t>(k)]; };
    double length = 0;
    for (int k = link; k >= 0 && k < links && at(thread_.tension(), k) > least; k += outwards)
        length += at(thread_.rest_lengths(), k);
    return std::min(excess / thread_.def().elastic->axial_stiffness(at(thread_.rest_lengths(), link)) * length,
                    thread_.def().radius);
}

// The strand that pulls hardest at a tool; one that pulls with nothing where the tool holds none.
World::Strand World::hardest_pulling(int tool) const {
    Strand hardest;
    const auto look = [&](int inner, int outwards, double pull) {
        if (pull > hardest.pull) hardest = {inner, outwards, pull};
    };
    for (const Grasp& grasp : tools_[static_cast<std::size_t>(tool)].grasps) {
        look(grasp.first, -1, tension_before(grasp));
        look(grasp.first + grasp.count() - 1, 1, tension_after(grasp));
    }
    for (const Needle& needle : needles_)
        if (needle.holder.tool == tool)
            look(needle.node + 1, 1, thread_.tension()[static_cast<std::size_t>(needle.node) + 1]);
    return hardest;
}

// Where the next input takes the tool, limited by force: no farther against the strand than by what stretches it to the
// tool's pull, and back by what stretches it beyond, as far as it is tight now; by a radius of the thread a tick at
// most.
ToolInput World::force_limited(int number, ToolInput next) const {
    // A hand feels pulls above this share of its own; strands that pull by less than this share of what it feels are
    // slack.
    constexpr double feels = 0.5;
    const Tool& tool = tools_[static_cast<std::size_t>(number)];
    const Strand strand = hardest_pulling(number);
    if (strand.pull <= feels * tool.def.pull) return next;
    const auto node = [&](int k) -> const Vec3& { return thread_.nodes()[static_cast<std::size_t>(k)]; };
    const int link = strand.outwards > 0 ? strand.inner : strand.inner - 1;
    const double recoil = stretch_by(strand.pull - tool.def.pull, link, strand.outwards, feels * strand.pull);
    const Vec3 towards = (node(strand.inner + strand.outwards) - node(strand.inner)).normalized();
    const double goes = (next.pose.position - tool.now.pose.position).dot(towards);
    next.pose.position += std::max(0.0, recoil - goes) * towards;
    return next;
}

}  // namespace scenarios::world
