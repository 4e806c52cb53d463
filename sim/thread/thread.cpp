#include "sim/thread/thread.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "sim/geometry/closest_points.hpp"
#include "sim/thread/stages.hpp"

namespace sim::thread {

static std::vector<double> lengths_of(const std::vector<Vec3>& nodes, std::span<const int> cuts) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) lengths.push_back((nodes[i + 1] - nodes[i]).norm());
    for (const int cut : cuts) lengths[static_cast<std::size_t>(cut)] = 0;
    return lengths;
}

// So many links there are at most.
static std::size_t most_links(const ThreadDef& def, const std::vector<double>& rest) {
    if (def.shortest_link <= 0) return rest.size();
    double length = 0;
    for (const double link : rest) length += link;
    return rest.size() +
           static_cast<std::size_t>(1.5 * length / def.shortest_link);  // none is shorter by more than the root of two
}

State::State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes, std::span<const int> cuts)
    : def(thread_def),
      nodes(std::move(start_nodes)),
      rest(lengths_of(nodes, cuts)),
      longest_link(1.001 * *std::max_element(rest.begin(), rest.end())),  // equal ones differ by rounding
      drift(nodes.size(), Vec3::Zero()),
      following(nodes.size(), 1.0),
      tension(rest.size(), 0.0),
      tree(static_cast<int>(most_links(def, rest))) {
    const std::size_t most = most_links(def, rest);
    for (auto* of_nodes :
         {&nodes, &before, &drift, &unfinished.nodes, &carried, &forward, &coupled_move, &unit, &line, &glided})
        of_nodes->reserve(most + 1);
    for (auto* of_links : {&rest, &arc, &least_span, &nearest, &inverse_mass, &bound, &following, &tension, &profile,
                           &rubbed, &lower, &pivot, &upper, &multiplier, &pulled, &pulled_before, &weight_at, &stiff})
        of_links->reserve(most + 1);
    for (auto* boxes : {&audit_boxes, &audit_links}) boxes->reserve(most);
    kept.reserve(most + 1);
    wraps.reserve(most);
    unknowns.reserve(2 * most);
    on_steel.reserve(most);
    unknown.reserve(2 * most);
    band.reserve(2 * most);
    middles.reserve(most);
    room_at_walls.reserve(most + 1);
    // What a knot pulled tight takes, with links no longer than the thread is thick; what takes more allocates.
    surface_forces.reserve(most);
    contacts.reserve(24 * most);
    rows.reserve(8 * most);
    pushed_rows.reserve(rows.capacity());
    responses.resized(3 * most_coupled, 3 * most_coupled);
    for (Table* of_links : {&effects, &answers}) of_links->resized(8 * most_coupled, 3 * most_coupled);
    touched.reserve(8 * most_coupled);
    inverse.reserve(8 * most_coupled);
    size_for_links();
    if (!def.elastic) return;
    def.elastic->radius = def.radius;
    rod.emplace(*def.elastic, nodes);
    for (const int cut : cuts) rod->leave_out(static_cast<std::size_t>(cut), static_cast<std::size_t>(cut) + 1);
    rod->resize();
    rod->reserve(most);
    watched = nodes;
    asleep.assign(nodes.size(), 0);
    watched.reserve(most + 1), asleep.reserve(most + 1), sleeping.reserve(2 * most);
    for (auto* of_presses : {&presses, &all_presses}) of_presses->reserve(2 * most);
    all_apart.reserve(6 * most), piece_of.reserve(most + 1);
    pressed.reserve(2 * most);
}

void State::size_for_links() {
    const std::size_t n = rest.size();
    arc.assign(1, 0.0);
    for (std::size_t k = 0; k < n; ++k) arc.push_back(arc.back() + (is_cut(k) ? looked_around * def.radius : rest[k]));
    least_span.assign(n, 0.0);
    for (std::size_t i = 1; i < n; ++i)
        if (!is_end(i)) least_span[i] = thread::least_span(rest[i - 1], rest[i], def.radius);
    before = unfinished.nodes = nodes;
    for (auto* of_nodes : {&carried, &forward, &glided, &line}) of_nodes->resize(n + 1);
    unit.resize(n);
    inverse_mass.assign(n + 1, 1.0);
    for (auto* of_nodes : {&bound, &weight_at}) of_nodes->assign(n + 1, 0.0);
    for (auto* of_links : {&profile, &rubbed, &lower, &pivot, &upper, &multiplier, &pulled, &pulled_before})
        of_links->assign(n, 0.0);
    wraps.assign(n, {});
    tree.resize(static_cast<int>(n));
}

TickReport tick(State& state, const TickInput& input);

struct Thread::Impl {
    State state;
};

Thread::Thread(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts)
    : impl_(new Impl{State(def, std::move(nodes), cuts)}) {}
Thread::~Thread() {
    delete impl_;
}
Thread::Thread(const Thread& other) : impl_(other.impl_ ? new Impl(*other.impl_) : nullptr) {}
Thread& Thread::operator=(const Thread& other) {
    return *this = Thread(other);
}
Thread::Thread(Thread&& other) noexcept : impl_(std::exchange(other.impl_, nullptr)) {}
Thread& Thread::operator=(Thread&& other) noexcept {
    std::swap(impl_, other.impl_);
    return *this;
}

TickReport Thread::tick(const TickInput& input) {
    return thread::tick(impl_->state, input);
}

bool Thread::fit_links(std::span<int> held) {
    return thread::fit_links(impl_->state, held);
}
bool Thread::cut(int link, double share, std::span<int> held) {
    return thread::cut(impl_->state, static_cast<std::size_t>(link), share, held);
}
int Thread::most_loaded() const {
    return thread::most_loaded(impl_->state);
}

std::vector<Piece> Thread::pieces() const {
    std::vector<Piece> pieces{{0, impl_->state.links()}};
    for (int k = 0; k < impl_->state.links(); ++k)
        if (is_cut(k)) {
            pieces.back().last = k;
            pieces.push_back({k + 1, impl_->state.links()});
        }
    return pieces;
}

const ThreadDef& Thread::def() const {
    return impl_->state.def;
}
std::span<const Vec3> Thread::nodes() const {
    return impl_->state.nodes;
}
std::span<const double> Thread::rest_lengths() const {
    return impl_->state.rest;
}
std::span<const double> Thread::tension() const {
    return impl_->state.tension;
}
std::span<const SurfaceForce> Thread::surface_forces() const {
    return impl_->state.surface_forces;
}

void Thread::surface_room(std::span<double> rooms, std::vector<SurfaceGap>& gaps) const {
    const State& state = impl_->state;
    std::fill(rooms.begin(), rooms.end(), std::max(0.0, state.reach - 2 * state.moved));
    gaps.clear();
    for (const Contact& c : state.contacts) {
        if (c.against != Against::surface) continue;
        const double at_least = c.measured - 2 * (state.moved - c.measured_at);
        double& room = rooms[static_cast<std::size_t>(c.other)];
        const auto link = static_cast<std::size_t>(c.link);
        if (at_least < 3 * state.def.radius) {
            const auto pair =
                geometry::closest_points(state.nodes[link], state.nodes[link + 1], (*state.input.surface)[c.other]);
            const double gap = std::sqrt(pair.distance_squared);
            if (gap > 0)
                gaps.push_back({c.other, (pair.on_a - pair.on_b) / gap, gap});
            else
                room = 0;
        } else {
            room = std::min(room, at_least);
        }
    }
}

double Thread::progress(int owner) const {
    return impl_->state.progress[static_cast<std::size_t>(owner + 1)];
}

// FNV-1a over the words of everything a tick carries to the next.
std::uint64_t Thread::hash() const {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](double value) { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u; };
    for (const Vec3& p : impl_->state.nodes)
        for (int c = 0; c < 3; ++c) add(p[c]);
    for (const Vec3& p : impl_->state.drift)
        for (int c = 0; c < 3; ++c) add(p[c]);
    for (const double link : impl_->state.rest) add(link);
    for (const Contact& c : impl_->state.contacts) add(c.measured - 2 * c.measured_at);
    for (const double share : impl_->state.following) add(share);
    add(impl_->state.moved);
    add(impl_->state.drift_way);
    for (const Pace& pace : impl_->state.paces) {
        add(pace.trust);
        add(pace.refused_in_a_row);
        add(pace.jams_in_a_row);
        add(pace.waits);
        add(pace.stuck);
        for (const Vec3& way : pace.refused)
            for (int c = 0; c < 3; ++c) add(way[c]);
    }
    add(impl_->state.settled);
    if (impl_->state.slides) add(1);
    if (!impl_->state.rod) {
        for (const Wrap& wrap : impl_->state.wraps) {
            add(wrap.grip);
            add(wrap.presses);
        }
        for (const double pull : impl_->state.pulled) add(pull);
    }
    if (impl_->state.rod) {
        for (const Vec3& v : impl_->state.rod->velocity())
            for (int c = 0; c < 3; ++c) add(v[c]);
        if (impl_->state.def.elastic->yield_strain > 0)
            for (const double bend : impl_->state.rod->natural_bends()) add(bend);
        for_all_pressed(impl_->state, [&](const Row& row) {
            add(row.normal_push);
            for (int c = 0; c < 3; ++c) add(row.tangent_push[c]);
        });
        for (const char asleep : impl_->state.asleep) add(asleep);
        for (const Vec3& p : impl_->state.watched)
            for (int c = 0; c < 3; ++c) add(p[c]);
        add(impl_->state.watched_ticks);
    }
    const Unfinished& unfinished = impl_->state.unfinished;
    add(unfinished.pace);
    if (unfinished.pace < 0) return hash;
    add(unfinished.share);
    add(unfinished.tries);
    for (const Vec3& p : unfinished.nodes)
        for (int c = 0; c < 3; ++c) add(p[c]);
    for (const Row& row : impl_->state.rows) {
        add(row.normal_push);
        for (int c = 0; c < 3; ++c) add(row.tangent_push[c]);
    }
    return hash;
}

bool Strength::gives_way(double pull, double tick_s, bool is_elastic) {
    const double stands_s = is_elastic ? 0 : 0.1;
    const bool gave_way = pulled_s > stands_s;
    pulled_s = pull > force ? pulled_s + tick_s : 0;
    return !gave_way && pulled_s > stands_s;
}

}  // namespace sim::thread
