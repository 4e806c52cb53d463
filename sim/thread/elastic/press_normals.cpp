#include <Eigen/Cholesky>
#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/thread/elastic/press.hpp"

namespace sim::thread {

namespace {

using Matrix = Eigen::Map<Table::Matrix>;

double normal_push(const Press& press) {
    return press.push.dot(press.normal);
}

// How much nearer contact c is than it would be; negative: farther.
double lacks(const State& state, std::size_t c) {
    const Press& press = state.presses[c];
    const Vec3& n = press.normal;
    return (press.rest - Eigen::Map<const Vec3>(state.apart.data() + 3 * c)).dot(n) - press.give * normal_push(press);
}

bool share_piece(const Press& a, const Press& b) {
    return &a == &b || std::any_of(a.piece.begin(), a.piece.end(), [&](int piece) {
        return piece >= 0 && (piece == b.piece[0] || piece == b.piece[1]);
    });
}

// How contacts that push part for unit pushes across.
Matrix responses_across(State& state, const Responses& responses) {
    const std::vector<int>& pushing = state.pushing;
    const auto size = static_cast<Eigen::Index>(pushing.size());
    Matrix across = state.press_across.resized(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto c = static_cast<std::size_t>(pushing[static_cast<std::size_t>(i)]);
        for (Eigen::Index j = 0; j <= i; ++j) {
            const auto d = static_cast<std::size_t>(pushing[static_cast<std::size_t>(j)]);
            across(i, j) =
                share_piece(state.presses[c], state.presses[d])
                    ? state.presses[c].normal.dot(responses.block<3, 3>(axes(c), axes(d)) * state.presses[d].normal)
                    : 0;
        }
    }
    return across;
}

// All that push do so as if they could pull as well.
bool solve_pushing(State& state, const Responses& responses) {
    if (state.pushing.empty()) return true;
    constexpr double softer =
        1e-3;  // than they are, as contacts of the same strand at nearly the same place tell nearly the same
    Matrix across = responses_across(state, responses);
    const double more = softer * across.diagonal().mean();
    for (Eigen::Index i = 0; i < across.rows(); ++i)
        across(i, i) += state.presses[at(state.pushing[at(i)])].give + more;
    const Eigen::LLT<Eigen::Ref<Table::Matrix>> in_place(across);
    if (in_place.info() != Eigen::Success) return false;
    state.push_change.resize(state.pushing.size());
    for (std::size_t i = 0; i < state.pushing.size(); ++i)
        state.push_change[i] = lacks(state, static_cast<std::size_t>(state.pushing[i]));
    Eigen::Map<Eigen::VectorXd> change(state.push_change.data(), across.rows());
    across.triangularView<Eigen::Lower>().solveInPlace(change);
    across.transpose().triangularView<Eigen::Upper>().solveInPlace(change);
    for (std::size_t i = 0; i < state.pushing.size(); ++i) {
        const auto c = static_cast<std::size_t>(state.pushing[i]);
        push_more(state, responses, c, state.push_change[i] * state.presses[c].normal);
    }
    return true;
}

// What does not push any more drags nothing either.
void let_go(State& state, const Responses& responses, std::size_t c) {
    const Vec3 push = state.presses[c].push;
    if (push.squaredNorm() > 0) push_more(state, responses, c, -push);
}

void drag_within_cone(State& state, const Responses& responses) {
    for (std::size_t c = 0; c < state.presses.size(); ++c) {
        const Press& press = state.presses[c];
        const double normal = normal_push(press), most = press.friction * std::max(0.0, normal);
        const Vec3 drag = press.push - normal * press.normal;
        if (const double size = drag.norm(); size > most) push_more(state, responses, c, (most / size - 1) * drag);
    }
}

// Until none pulls and none is too near.
bool settle_across(State& state, const Responses& responses, double near) {
    constexpr int patience = 3, most = 30;
    std::size_t least = state.presses.size() + 1;
    int left = patience;
    for (int turn = 0; turn < most && solve_pushing(state, responses); ++turn) {
        state.wrong.clear();
        for (std::size_t c = 0; c < state.presses.size(); ++c) {
            const bool pushes = std::binary_search(state.pushing.begin(), state.pushing.end(), static_cast<int>(c));
            if (pushes ? normal_push(state.presses[c]) < 0 : lacks(state, c) > near)
                state.wrong.push_back(static_cast<int>(c));
        }
        if (state.wrong.empty()) return true;
        if (state.wrong.size() < least) {
            least = state.wrong.size();
            left = patience;
        } else if (--left < 0) {
            state.wrong.assign(1, state.wrong.back());  // one at a time ends for sure
        }
        for (const int c : state.wrong) {
            const auto known = std::lower_bound(state.pushing.begin(), state.pushing.end(), c);
            if (known != state.pushing.end() && *known == c) {
                state.pushing.erase(known);
                let_go(state, responses, static_cast<std::size_t>(c));
            } else {
                state.pushing.insert(known, c);
            }
        }
    }
    return false;
}

void take_back(State& state, const Responses& responses) {
    for (std::size_t c = 0; c < state.presses.size(); ++c)
        push_more(state, responses, c, state.presses[c].before - state.presses[c].push);
}

}  // namespace

void part_presses(State& state, const Responses& responses) {
    constexpr int rounds = 2;  // of pushes across and drags within what those allow
    const double near = 1e-2 * 2 * state.def.radius;
    const auto is_too_near = [&](std::size_t c) { return lacks(state, c) > near; };
    std::size_t right = 0;
    while (right < state.presses.size() && !is_too_near(right)) ++right;
    if (right == state.presses.size()) return;
    state.pushing.clear();
    for (Press& press : state.presses) press.before = press.push;
    for (std::size_t c = 0; c < state.presses.size(); ++c) {
        if (normal_push(state.presses[c]) > 0) state.pushing.push_back(static_cast<int>(c));
    }
    for (int round = 0; round < rounds; ++round) {
        if (!settle_across(state, responses, near)) return take_back(state, responses);
        if (round + 1 < rounds) drag_within_cone(state, responses);
    }
}

}  // namespace sim::thread
