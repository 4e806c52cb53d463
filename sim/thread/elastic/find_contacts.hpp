#pragma once
#include <vector>

#include "sim/thread/elastic/contact_constraint.hpp"

namespace sim::thread::elastic {

/// Whether a row is too far off to push in the next step, which leaves it just touching at most.
bool is_far(const State& state, const Row& row);

/// The compliance of a soft wall to what a push on it has changed by since the wall was moved [m/N]; 0 of a hard one.
double compliance_of_wall(const State& state, const Row& row);

/// Finds what of all that an elastic thread is near may press on it in a step.
class ContactFinder {
  public:
    /// Makes room for a thread of at most so many links.
    explicit ContactFinder(std::size_t most_links);

    /// Puts the rows that press, or may come to in this step, into `contacts`, nearest first. O(rows log rows + rows
    /// contacts).
    void find(State& state, std::vector<ContactConstraint>& contacts);

    /// The forces on the rod of the contacts found last.
    std::span<const Pair> pairs() const { return pairs_; }
    /// The links of the contacts found last that roll on what they are pressed against.
    std::span<const Rolling> rolling() const { return rolling_; }

  private:
    void sort_by_distance(State& state);
    void add_contact(State& state, std::vector<ContactConstraint>& contacts, Row& row);
    void add_rolling(const State& state, const Row& row);
    void set_rest(const State& state, ContactConstraint& contact);

    std::vector<Row*> nearest_rows_;
    std::vector<Pair> pairs_;
    std::vector<Rolling> rolling_;
};

}  // namespace sim::thread::elastic
