#include <Eigen/Cholesky>
#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/thread/elastic/contact_solver.hpp"

// What contacts push along their normals is a linear complementarity problem: none pulls, none is too near, and what
// pushes is just where it would be. Block principal pivoting [Judice and Pires 1994] from the contacts that push now:
// all that are wrong change sides at once, one at a time where that goes on without gain. Direct and exact where sweeps
// creep; a Cholesky factorisation a change, of which there are few as the set is nearly right. O(m^3) for m that push.

namespace sim::thread::elastic {

namespace {

using Matrix = Eigen::Map<contact::Table::Matrix>;

double normal_push(const ContactConstraint& contact) {
    return contact.push.dot(contact.normal);
}

// How much nearer contact c is than it would be; negative: farther.
double lacks(const ContactSet& set, std::size_t c) {
    const ContactConstraint& contact = set.contacts[c];
    const Vec3& n = contact.normal;
    return (contact.rest - set.apart_of(c)).dot(n) - contact.compliance * normal_push(contact);
}

bool share_piece(const ContactConstraint& a, const ContactConstraint& b) {
    return &a == &b || std::any_of(a.piece.begin(), a.piece.end(), [&](int piece) {
        return piece >= 0 && (piece == b.piece[0] || piece == b.piece[1]);
    });
}

// What does not push any more drags nothing either.
void let_go(ContactSet& set, const DelassusMatrix& delassus, std::size_t c) {
    const Vec3 push = set.contacts[c].push;
    if (push.squaredNorm() > 0) push_more(set, delassus, c, -push);
}

void drag_within_cone(ContactSet& set, const DelassusMatrix& delassus) {
    for (std::size_t c = 0; c < set.contacts.size(); ++c) {
        const ContactConstraint& contact = set.contacts[c];
        const double normal = normal_push(contact), most = contact.friction * std::max(0.0, normal);
        const Vec3 drag = contact.push - normal * contact.normal;
        if (const double size = drag.norm(); size > most) push_more(set, delassus, c, (most / size - 1) * drag);
    }
}

void take_back(ContactSet& set, const DelassusMatrix& delassus) {
    for (std::size_t c = 0; c < set.contacts.size(); ++c)
        push_more(set, delassus, c, set.contacts[c].before - set.contacts[c].push);
}

}  // namespace

// How contacts that push part for unit pushes across.
Matrix NormalSolver::delassus_across(const ContactSet& set, const DelassusMatrix& delassus) {
    const std::vector<int>& pushing = pushing_;
    const auto size = static_cast<Eigen::Index>(pushing.size());
    Matrix across = across_.resized(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto c = static_cast<std::size_t>(pushing[static_cast<std::size_t>(i)]);
        for (Eigen::Index j = 0; j <= i; ++j) {
            const auto d = static_cast<std::size_t>(pushing[static_cast<std::size_t>(j)]);
            across(i, j) = share_piece(set.contacts[c], set.contacts[d])
                               ? set.contacts[c].normal.dot(delassus.block(c, d) * set.contacts[d].normal)
                               : 0;
        }
    }
    return across;
}

// All that push do so as if they could pull as well.
bool NormalSolver::solve_pushing(ContactSet& set, const DelassusMatrix& delassus) {
    if (pushing_.empty()) return true;
    constexpr double softer =
        1e-3;  // than they are, as contacts of the same strand at nearly the same place tell nearly the same
    Matrix across = delassus_across(set, delassus);
    const double more = softer * across.diagonal().mean();
    for (Eigen::Index i = 0; i < across.rows(); ++i)
        across(i, i) += set.contacts[at(pushing_[at(i)])].compliance + more;
    const Eigen::LLT<Eigen::Ref<contact::Table::Matrix>> in_place(across);
    if (in_place.info() != Eigen::Success) return false;
    change_.resize(pushing_.size());
    for (std::size_t i = 0; i < pushing_.size(); ++i) change_[i] = lacks(set, static_cast<std::size_t>(pushing_[i]));
    Eigen::Map<Eigen::VectorXd> change(change_.data(), across.rows());
    across.triangularView<Eigen::Lower>().solveInPlace(change);
    across.transpose().triangularView<Eigen::Upper>().solveInPlace(change);
    for (std::size_t i = 0; i < pushing_.size(); ++i) {
        const auto c = static_cast<std::size_t>(pushing_[i]);
        push_more(set, delassus, c, change_[i] * set.contacts[c].normal);
    }
    return true;
}

void NormalSolver::find_wrong(const ContactSet& set, double near) {
    wrong_.clear();
    for (std::size_t c = 0; c < set.contacts.size(); ++c) {
        const bool pushes = std::binary_search(pushing_.begin(), pushing_.end(), static_cast<int>(c));
        if (pushes ? normal_push(set.contacts[c]) < 0 : lacks(set, c) > near) wrong_.push_back(static_cast<int>(c));
    }
}

// What is wrong changes sides.
void NormalSolver::change_wrong(ContactSet& set, const DelassusMatrix& delassus) {
    for (const int c : wrong_) {
        const auto known = std::lower_bound(pushing_.begin(), pushing_.end(), c);
        if (known != pushing_.end() && *known == c) {
            pushing_.erase(known);
            let_go(set, delassus, static_cast<std::size_t>(c));
        } else {
            pushing_.insert(known, c);
        }
    }
}

// Until none pulls and none is too near.
bool NormalSolver::settle_across(ContactSet& set, const DelassusMatrix& delassus, double near) {
    constexpr int patience = 3, most = 30;
    std::size_t least = set.contacts.size() + 1;
    int left = patience;
    for (int turn = 0; turn < most && solve_pushing(set, delassus); ++turn) {
        find_wrong(set, near);
        if (wrong_.empty()) return true;
        if (wrong_.size() < least) {
            least = wrong_.size();
            left = patience;
        } else if (--left < 0) {
            wrong_.assign(1, wrong_.back());  // one at a time ends for sure
        }
        change_wrong(set, delassus);
    }
    return false;
}

void NormalSolver::part(ContactSet& set, const DelassusMatrix& delassus, double radius) {
    constexpr int rounds = 2;  // of pushes across and drags within what those allow
    const double near = 1e-2 * 2 * radius;
    const auto is_too_near = [&](std::size_t c) { return lacks(set, c) > near; };
    std::size_t right = 0;
    while (right < set.contacts.size() && !is_too_near(right)) ++right;
    if (right == set.contacts.size()) return;
    pushing_.clear();
    for (ContactConstraint& contact : set.contacts) contact.before = contact.push;
    for (std::size_t c = 0; c < set.contacts.size(); ++c) {
        if (normal_push(set.contacts[c]) > 0) pushing_.push_back(static_cast<int>(c));
    }
    for (int round = 0; round < rounds; ++round) {
        if (!settle_across(set, delassus, near)) return take_back(set, delassus);
        if (round + 1 < rounds) drag_within_cone(set, delassus);
    }
}

}  // namespace sim::thread::elastic
