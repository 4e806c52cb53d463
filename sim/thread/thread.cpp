#include "sim/thread/thread.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/hash.hpp"
#include "sim/thread/links.hpp"
#include "sim/thread/mover.hpp"

namespace sim::thread {

struct Thread::Impl {
    explicit Impl(Mover start) : mover(std::move(start)), fitter(state().most_links()) {}
    const contact::State& state() const { return state_of(mover); }

    Mover mover;
    LinkFitter fitter;
};

Thread::Thread(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts)
    : impl_(new Impl(make_mover(def, std::move(nodes), cuts))) {}
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
    assert(impl_ && "not a thread that was moved from");
    return thread::tick(impl_->mover, input);
}

bool Thread::fit_links(std::span<int> held) {
    for ([[maybe_unused]] const int node : held)
        assert(node < static_cast<int>(nodes().size()) && "a node of the thread, or -1");
    return impl_->fitter.fit(impl_->mover, held);
}
bool Thread::cut(int link, double share, std::span<int> held) {
    assert(link >= 0 && static_cast<std::size_t>(link) < rest_lengths().size() && "a link of the thread");
    assert(share >= 0 && share <= 1);
    return thread::cut(impl_->mover, static_cast<std::size_t>(link), share, held);
}
int Thread::most_loaded() const {
    return thread::most_loaded(impl_->mover);
}

std::vector<Piece> Thread::pieces() const {
    std::vector<Piece> pieces{{0, impl_->state().links()}};
    for (int k = 0; k < impl_->state().links(); ++k)
        if (is_cut(k)) {
            pieces.back().last = k;
            pieces.push_back({k + 1, impl_->state().links()});
        }
    return pieces;
}

const ThreadDef& Thread::def() const {
    return impl_->state().def;
}
std::span<const Vec3> Thread::nodes() const {
    return impl_->state().nodes;
}
std::span<const double> Thread::rest_lengths() const {
    return impl_->state().rest_length;
}
std::span<const double> Thread::tension() const {
    return impl_->state().tension;
}
std::span<const SurfaceForce> Thread::surface_forces() const {
    return impl_->state().surface_forces;
}

void Thread::surface_room(std::span<double> rooms, std::vector<SurfaceGap>& gaps) const {
    const contact::State& state = impl_->state();
    assert((!state.input.surface || rooms.size() >= static_cast<std::size_t>(state.input.surface->size())) &&
           "room for each triangle");
    std::fill(rooms.begin(), rooms.end(), std::max(0.0, state.reach - 2 * state.moved));
    gaps.clear();
    for (const contact::Contact& c : state.contacts) {
        if (c.against != contact::Against::surface) continue;
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
    assert(owner >= -1 && static_cast<std::size_t>(owner + 1) < impl_->state().progress.size() &&
           "a tool of the last tick, or -1");
    return impl_->state().progress[static_cast<std::size_t>(owner + 1)];
}

std::uint64_t Thread::hash() const {
    return thread::hash_of(impl_->mover);
}
std::uint64_t Thread::hash_of_all_carried() const {
    return thread::hash_of_all_carried(impl_->mover);
}

bool Strength::gives_way(double pull, double tick_s, bool is_elastic) {
    assert(tick_s > 0);
    const double stands_s = is_elastic ? 0 : 0.1;
    const bool gave_way = pulled_s > stands_s;
    pulled_s = pull > force ? pulled_s + tick_s : 0;
    return !gave_way && pulled_s > stands_s;
}

}  // namespace sim::thread
