#pragma once
#include <vector>

#include "sim/thread/elastic/delassus_matrix.hpp"

namespace sim::thread::elastic {

/// Pushes contact c by `more` [N] than it does, and moves the points of all. O(contacts that share a piece with it).
void push_more(ContactSet& set, const DelassusMatrix& delassus, std::size_t c, const Vec3& more);

/// The normal forces of all contacts together: a linear complementarity problem, by block principal pivoting.
class NormalSolver {
  public:
    /// Where sweeps left a contact a hundredth of a thickness nearer than it would be: finds what all push across, to
    /// rounding, with what they drag as it is but within its cone. It costs a Cholesky factorisation of the contacts
    /// that push for each change of the set. `radius`: of the thread [m].
    void part(ContactSet& set, const DelassusMatrix& delassus, double radius);

  private:
    Eigen::Map<contact::Table::Matrix> delassus_across(const ContactSet& set, const DelassusMatrix& delassus);
    bool solve_pushing(ContactSet& set, const DelassusMatrix& delassus);
    bool settle_across(ContactSet& set, const DelassusMatrix& delassus, double near);
    void find_wrong(const ContactSet& set, double near);
    void change_wrong(ContactSet& set, const DelassusMatrix& delassus);

    std::vector<int> pushing_;    // contacts that push, increasing
    std::vector<int> wrong_;      // contacts that pull, or are too near and do not push
    std::vector<double> change_;  // of each push [N]
    contact::Table across_;       // how contacts that push part for unit pushes across [m/N]
};

/// What an elastic thread touches, solved together with it.
class ContactSolver {
  public:
    /// Solves a set until all push as Coulomb's law wants it, against the rod whose step with the pushes as they were
    /// is known; returns how many sweeps over the set that took.
    int solve(State& state, ContactSet& set, const Pieces& pieces);

  private:
    double sweep(ContactSet& set) const;
    void carry_on(ContactSet& set, double again);
    int sweep_until_still(ContactSet& set, int most_sweeps);

    DelassusMatrix delassus_;
    NormalSolver normals_;
    std::vector<double> apart_before_;  // ContactSet::apart as a sweep began
    std::vector<double> apart_search_;  // where sweeps lead
};

/// Islands of contacts, each solved by itself.
class IslandSolver {
  public:
    /// Makes room for a thread of at most so many links.
    explicit IslandSolver(std::size_t most_links);

    /// Does what ContactSolver::solve() does, island by island; returns the most sweeps that one took.
    int solve(State& state, ContactSet& set);

  private:
    int island_of(int piece) const;
    int island_of(const ContactConstraint& contact) const;
    void find_islands(const State& state, const ContactSet& set);
    int solve_island(State& state, ContactSet& set, int island);

    ContactSolver solver_;
    Pieces pieces_;
    std::vector<int> island_;  // of each piece the first in its island
    ContactSet alone_;         // the contacts of one island, while it is solved
};

}  // namespace sim::thread::elastic
