// Brings links to given lengths, moving nodes as little as possible: Newton's method on all lengths together, whose
// matrix is tridiagonal (L D L^T, time and room that grow with the number of links). Two rounds, of which each squares
// the error, are enough wherever a piece is bent or has a free end.
//
// A piece between held nodes gets shorter as a whole only by straightening, longer only by bending more, and where it
// is straight it can do neither: the matrix is singular there, and nearly so where it is nearly straight. Then Newton's
// method would move nodes aside by leaps, which stretch links far more than what was asked of them. What such a piece
// would have to give, all its links share as one strain.
#include <algorithm>
#include <cmath>

#include "sim/rod/rod.hpp"

namespace sim::rod {

void Rod::bring_to(const std::vector<double>& lengths, std::vector<Vec3>& x) {
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round) {
        find_excess(lengths, x);
        share_between_held(x);
        shorten(x);
    }
}

// What each link is too long by, into shorten_.
void Rod::find_excess(const std::vector<double>& lengths, const std::vector<Vec3>& x) {
    measure(x, tried_);
    shorten_.resize(lengths.size());
    for (std::size_t k = 0; k < lengths.size(); ++k) shorten_[k] = can_give(k) ? tried_[k].length - lengths[k] : 0;
}

void Rod::share_between_held(const std::vector<Vec3>& x) {
    const std::size_t n = shorten_.size();
    for (std::size_t first = 0, past; first < n; first = past) {
        past = first + 1;
        if (!held_[first] || !can_give(first)) continue;
        while (past < n && can_give(past) && !held_[past]) ++past;
        if (held_[past]) share_excess(first, past, (x[past] - x[first]).norm());
    }
}

// Of a piece whose ends are held this far apart, the links from `first` to before `past`: makes them share their
// excess, unless it has slack to give it. Slack comes of bends, and Newton's method takes the excess where bends are
// sharpest, which is well only while it is a small share of the slack: a smaller one the straighter the piece is.
void Rod::share_excess(std::size_t first, std::size_t past, double apart) {
    constexpr double rounding = 1e-12;  // of a length, as the difference of two places has it
    double excess = 0, path = 0, length = 0;
    for (std::size_t k = first; k < past; ++k)
        excess += shorten_[k], path += tried_[k].length, length += rest_length_[k];
    const double slack = path - apart;
    if (std::abs(excess) <= std::max(rounding * length, slack * slack / length)) return;
    for (std::size_t k = first; k < past; ++k) shorten_[k] -= excess / length * rest_length_[k];
}

// One round of Newton's method. A node that is moved along one link changes the length of its neighbour too, by the
// cosine of their angle.
void Rod::shorten(std::vector<Vec3>& x) {
    const std::size_t n = shorten_.size();
    for (auto* of_links : {&pivot_, &upper_}) of_links->resize(n);
    const auto mobility = [&](std::size_t i) { return held_[i] ? 0.0 : 1.0; };
    for (std::size_t k = 0; k < n; ++k) {
        pivot_[k] = can_give(k) ? mobility(k) + mobility(k + 1) : 1;
        if (k == 0) continue;
        upper_[k - 1] = is_cut(k - 1) || is_cut(k) ? 0 : -mobility(k) * tried_[k - 1].along.dot(tried_[k].along);
        const double factor = upper_[k - 1] / pivot_[k - 1];
        pivot_[k] -= factor * upper_[k - 1], shorten_[k] -= factor * shorten_[k - 1];
        // The last pivot of a straight piece between held nodes is nought: it is kept to a millionth of the others,
        // which are about one.
        pivot_[k] = std::max(pivot_[k], 1e-6);
    }
    for (std::size_t k = n; k-- > 0;)
        shorten_[k] = (shorten_[k] - (k + 1 < n ? upper_[k] * shorten_[k + 1] : 0)) / pivot_[k];
    for (std::size_t k = 0; k < n; ++k) {
        x[k] += mobility(k) * shorten_[k] * tried_[k].along;
        x[k + 1] -= mobility(k + 1) * shorten_[k] * tried_[k].along;
    }
}

}  // namespace sim::rod
