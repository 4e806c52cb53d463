#include "scenarios/session/guide.hpp"

#include <algorithm>

namespace scenarios::session {

namespace {

using drill::Held;
using world::World;

bool holds_needle(const World& world, std::size_t instrument) {
    return std::ranges::any_of(
        world.needles(), [&](const world::Needle& needle) { return needle.is_held_by(static_cast<int>(instrument)); });
}

bool holds(const World& world, const drill::HeldCondition& condition) {
    const world::Tool& tool = world.tools()[condition.instrument];
    switch (condition.what) {
        case Held::thread:
            return !tool.grasps.empty();
        case Held::needle:
            return holds_needle(world, condition.instrument);
        case Held::wall:
            return !tool.walls.empty();
        case Held::nothing:
            break;
    }
    return tool.grasps.empty() && tool.walls.empty() && !holds_needle(world, condition.instrument);
}

bool is_near(const World& world, const drill::NearCondition& condition) {
    const auto& tip = world.tools()[condition.instrument].now.pose.position;
    return (tip - condition.place).squaredNorm() <= condition.within * condition.within;
}

// As scored, but for the thread, which may still be on its way into the hole.
int bites_in(const World& world) {
    int count = 0;
    for (const world::SoftVessel& vessel : world.vessels())
        for (const tissue::Bite& bite : vessel.bites.bites())
            count += bite.state == tissue::BiteState::open && !bite.partial() && !bite.both_walls && !bite.torn;
    return count;
}

bool is_tied(const World& world, const drill::Done& done) {
    const sim::knot::Name& name = world.measures().knot;
    if (!done.knot.empty() && name.surgical != done.knot) return false;
    if (!done.notation.empty() && name.throws != done.notation) return false;
    return static_cast<int>(name.throw_list.size()) >= done.throws;
}

// An event says "left", "left by the thread" or "left, graft": names have neither blanks nor commas.
bool is_of(const std::string& what, const std::string& name) {
    return name.empty() ||
           (what.starts_with(name) && (what.size() == name.size() || what.find_first_of(" ,") == name.size()));
}

}  // namespace

bool Guide::is_done(const drill::Done& done, const World& world) const {
    const auto all = [](const auto& conditions, const auto& hold) {
        return std::all_of(conditions.begin(), conditions.end(), hold);
    };
    return all(done.held, [&](const auto& held) { return holds(world, held); }) &&
           all(done.near, [&](const auto& near) { return is_near(world, near); }) && is_tied(world, done) &&
           (done.bites == 0 || bites_in(world) >= done.bites);
}

void Guide::after_tick(const World& world) {
    const drill::Step* current = now();
    if (!current) return;
    for (const auto all = world.events(); events_seen_ < all.size(); ++events_seen_) {
        const auto& [t_s, kind, what, value] = all[events_seen_];
        if (const auto& asked = current->done.event) event_came_ |= kind == asked->kind && is_of(what, asked->what);
    }
    const auto is_behind = [&](std::size_t i) {
        const drill::Done& done = steps_[i].done;
        const bool counts = i == step() ? !done.event || event_came_ : done.is_milestone() && !done.event;
        return counts && is_done(done, world);
    };
    for (std::size_t i = step(); i < steps_.size(); ++i) {
        if (!is_behind(i)) continue;
        while (marks_.size() < i) marks_.push_back({world.time_s(), true});
        marks_.push_back({world.time_s(), false});
        event_came_ = false;
        return;
    }
}

}  // namespace scenarios::session
