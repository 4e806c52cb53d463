#include "sim/thread/thread.hpp"

#include <bit>
#include <cmath>
#include <utility>

#include "sim/thread/state.hpp"

namespace sim::thread {

// Links nearer than half a turn of the tightest bend cannot be told from the bend itself.
static int neighbours(double radius, double link) { return static_cast<int>(std::ceil(3.14159265358979 * radius / link)) + 1; }

static std::vector<double> lengths_of(const std::vector<Vec3>& nodes) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) lengths.push_back((nodes[i + 1] - nodes[i]).norm());
    return lengths;
}

static std::vector<double> spans_of(const std::vector<double>& rest, double radius) {
    std::vector<double> spans(rest.size(), 0.0);
    for (std::size_t i = 1; i < rest.size(); ++i) spans[i] = least_span(0.5 * (rest[i - 1] + rest[i]), radius);
    return spans;
}

State::State(const ThreadDef& thread_def, std::vector<Vec3> start_nodes)
    : def(thread_def),
      nodes(std::move(start_nodes)),
      rest(lengths_of(nodes)),
      skip(neighbours(def.radius, *std::min_element(rest.begin(), rest.end()))),
      least_span(spans_of(rest, def.radius)),
      inverse_mass(nodes.size(), 1.0),
      before(nodes),
      bound(nodes.size(), 0.0),
      drift(nodes.size(), Vec3::Zero()),
      tension(rest.size(), 0.0),
      tree(static_cast<int>(rest.size())),
      unit(rest.size()),
      lower(rest.size()), pivot(rest.size()), upper(rest.size()),
      multiplier(rest.size()),
      pulled(rest.size(), 0.0),
      carried(nodes.size()),
      forward(nodes.size()) {}

TickReport tick(State& state, const TickInput& input);

struct Thread::Impl {
    State state;
};

Thread::Thread(const ThreadDef& def, std::vector<Vec3> nodes) : impl_(new Impl{State(def, std::move(nodes))}) {}
Thread::~Thread() { delete impl_; }
Thread::Thread(Thread&& other) noexcept : impl_(std::exchange(other.impl_, nullptr)) {}
Thread& Thread::operator=(Thread&& other) noexcept {
    std::swap(impl_, other.impl_);
    return *this;
}

TickReport Thread::tick(const TickInput& input) { return thread::tick(impl_->state, input); }

const ThreadDef& Thread::def() const { return impl_->state.def; }
std::span<const Vec3> Thread::nodes() const { return impl_->state.nodes; }
std::span<const double> Thread::rest_lengths() const { return impl_->state.rest; }
std::span<const double> Thread::tension() const { return impl_->state.tension; }
double Thread::progress(int owner) const { return impl_->state.progress[static_cast<std::size_t>(owner + 1)]; }

// FNV-1a over the words of everything a tick carries to the next.
std::uint64_t Thread::hash() const {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](double value) { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u; };
    for (const Vec3& p : impl_->state.nodes)
        for (int c = 0; c < 3; ++c) add(p[c]);
    for (const Vec3& p : impl_->state.drift)
        for (int c = 0; c < 3; ++c) add(p[c]);
    for (const Contact& c : impl_->state.contacts) add(c.measured - 2 * c.measured_at);
    add(impl_->state.moved);
    add(impl_->state.drift_way);
    for (const Pace& pace : impl_->state.paces) {
        add(pace.trust);
        add(pace.refused_in_a_row);
        add(pace.jams_in_a_row);
        add(pace.waits);
    }
    add(impl_->state.settled);
    return hash;
}

std::vector<Vec3> resample(std::span<const Vec3> path, int links) {
    double total = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) total += (path[i + 1] - path[i]).norm();
    std::vector<Vec3> nodes{path.front()};
    double passed = 0;
    std::size_t i = 0;
    for (int k = 1; k < links; ++k) {
        const double wanted = total * k / links;
        double piece = (path[i + 1] - path[i]).norm();
        while (passed + piece < wanted && i + 2 < path.size()) {
            passed += piece;
            ++i;
            piece = (path[i + 1] - path[i]).norm();
        }
        nodes.push_back(path[i] + (wanted - passed) / piece * (path[i + 1] - path[i]));
    }
    nodes.push_back(path.back());
    return nodes;
}

}  // namespace sim::thread
