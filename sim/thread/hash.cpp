#include "sim/thread/hash.hpp"

#include "sim/geometry/hash.hpp"

namespace sim::thread {

using contact::Contact;
using contact::Row;

namespace {

// Lists without their length, as earlier recordings have them.
class Hash {
  public:
    std::uint64_t value() const { return words_.value(); }

    void add(double number) { words_.add(number); }
    void add(const Vec3& v) {
        for (int c = 0; c < 3; ++c) add(v[c]);
    }
    void add(const geometry::Triangle& t) { add(t.a), add(t.b), add(t.c); }
    void add(const Capsule& c) { add(c.a), add(c.b), add(c.radius); }
    void add_pushes(const Row& row) { add(row.normal_push), add(row.tangent_push); }
    void add(const Row& row) {
        for (const double number :
             {double(row.against), double(row.link), double(row.other), row.thickness, row.friction, row.target, row.s,
              row.t, row.distance, row.mobility, row.friction_ratio, row.friction_ratio_before, row.slip_before,
              double(row.in_wrap), double(row.pressed), row.slip, double(row.is_there_still)})
            add(number);
        for (const Vec3* v : {&row.normal, &row.start, &row.fixed, &row.began}) add(*v);
        add_pushes(row);
    }
    void add(const Contact& c) {
        for (const double number : {double(c.against), double(c.link), double(c.other), c.thickness, c.measured,
                                    c.measured_at, c.place, c.gap})
            add(number);
    }
    void add(const ftl::Wrap& wrap) { add(wrap.friction_ratio), add(wrap.presses); }
    void add(const ftl::StepControl& step_control) {
        add(step_control.trust_region);
        add(step_control.refused_in_a_row);
        add(step_control.jams_in_a_row);
        add(step_control.waits);
        add(step_control.stuck);
        add(step_control.refused);
    }
    void add(const elastic::SleepingContact& contact) { add(contact.row), add(contact.wall); }
    void add(const SurfaceForce& force) {
        add(force.triangle), add(force.link);
        add(force.at), add(force.force), add(force.deeper);
        add(force.asleep.has_value());
        if (force.asleep) add(*force.asleep);
    }
    template <class T>
    void add(const std::vector<T>& values) {
        for (const T& value : values) add(value);
    }
    // With their number, so that nothing moves unseen from one list to the next.
    template <class... Lists>
    void add_counted(const Lists&... lists) {
        (..., (add(static_cast<double>(lists.size())), add(lists)));
    }

  private:
    geometry::Hash words_;
};

// What Follow-The-Leader remembers of its last substep. An elastic thread remembers nothing of the kind: for it
// recordings hold what a thread that has never drifted nor been refused would say.
void add_drift(Hash& hash, const Mover& mover) {
    if (const auto* ftl = std::get_if<ftl::Mover>(&mover)) return hash.add(ftl->state().last.drift);
    for (std::size_t i = 0; i < state_of(mover).nodes.size(); ++i) hash.add(Vec3(Vec3::Zero()));
}
void add_following(Hash& hash, const Mover& mover) {
    if (const auto* ftl = std::get_if<ftl::Mover>(&mover)) return hash.add(ftl->state().last.following);
    for (std::size_t i = 0; i < state_of(mover).nodes.size(); ++i) hash.add(1);
}
void add_paces(Hash& hash, const Mover& mover) {
    static const ftl::StepControl untried;
    if (const auto* ftl = std::get_if<ftl::Mover>(&mover)) return hash.add(ftl->state().step_controls);
    const std::size_t tools = state_of(mover).progress.size();
    for (std::size_t i = 0; tools > 0 && i <= tools; ++i) hash.add(untried);
}

void add_own(Hash& hash, const ftl::State& state) {
    hash.add(state.settled);
    if (state.slides) hash.add(1);
    hash.add(state.last.wraps);
    hash.add(state.pulled);
    hash.add(state.unfinished.step_control);
    if (state.unfinished.step_control < 0) return;
    hash.add(state.unfinished.share);
    hash.add(state.unfinished.tries);
    hash.add(state.unfinished.nodes);
    for (const Row& row : state.rows) hash.add_pushes(row);
}

void add_own(Hash& hash, const elastic::State& state) {
    hash.add(false);  // it never settles
    for (const Vec3& v : state.rod.velocity()) hash.add(v);
    if (state.def.elastic->yield_strain > 0)
        for (const double bend : state.rod.natural_bends()) hash.add(bend);
    for_all_pressed(state, [&](const Row& row) { hash.add_pushes(row); });
    hash.add(state.asleep);
    hash.add(state.watched);
    hash.add(state.watched_ticks);
    hash.add(-1);  // it leaves nothing unfinished
}

void add_all_of(Hash& hash, const ftl::State& state) {
    const ftl::Unfinished& unfinished = state.unfinished;
    for (const double number : {state.last.path, double(state.slides), double(state.settled),
                                double(unfinished.step_control), unfinished.share, double(unfinished.tries)})
        hash.add(number);
    hash.add_counted(state.last.drift, state.last.following, state.step_controls, unfinished.nodes, state.last.wraps,
                     state.on_steel, state.pulled, state.last.pulled, state.carried);
}

void add_all_of(Hash& hash, const elastic::State& state) {
    hash.add_counted(state.pressed, state.sleeping, state.watched);
    hash.add(state.watched_ticks);
    state.rod.for_all_carried([&](double number) { hash.add(number); });
}

}  // namespace

std::uint64_t hash_of(const Mover& mover) {
    const contact::State& state = state_of(mover);
    const auto* ftl = std::get_if<ftl::Mover>(&mover);
    Hash hash;
    hash.add(state.nodes);
    add_drift(hash, mover);
    hash.add(state.rest_length);
    for (const Contact& c : state.contacts) hash.add(c.measured - 2 * c.measured_at);
    add_following(hash, mover);
    hash.add(state.moved);
    hash.add(ftl ? ftl->state().last.path : 0);
    add_paces(hash, mover);
    std::visit([&](const auto& one) { add_own(hash, one.state()); }, mover);
    return hash.value();
}

std::uint64_t hash_of_all_carried(const Mover& mover) {
    const contact::State& state = state_of(mover);
    Hash hash;
    for (const double number : {state.def.radius, state.def.friction, state.def.friction_tool,
                                state.def.axial_stiffness, state.def.shortest_link, double(state.def.contacts_per_tick),
                                state.longest_link, state.reach, state.moved, double(state.is_rest_due)})
        hash.add(number);
    hash.add_counted(state.nodes, state.rest_length, state.arc, state.tension, state.surface_forces, state.progress,
                     state.bound, state.capsules, state.rows, state.contacts, state.seen, state.asleep);
    std::visit([&](const auto& one) { add_all_of(hash, one.state()); }, mover);
    return hash.value();
}

}  // namespace sim::thread
