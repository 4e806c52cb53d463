#pragma once
#include <span>
#include <vector>

#include "sim/thread/contact/table.hpp"
#include "sim/thread/elastic/contact_constraint.hpp"

namespace sim::thread::elastic {

/// Which piece of a cut thread each node belongs to.
struct Pieces {
    std::vector<int> of_node;  ///< n + 1 numbers of pieces, from 0 in their order along the thread.
    std::size_t count = 1;     ///< How many pieces there are.

    /// Numbers the pieces of a thread as it is now. O(n).
    void find(const State& state);
};

/// The Delassus matrix of the contacts: how far apart a unit push at each moves the points of every other [m/N].
class DelassusMatrix {
  public:
    /// Three rows and columns of the matrix, seen in place.
    using Block = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>, 0, Eigen::OuterStride<>>;

    /// Makes room for so many contacts at so many nodes, not a number until written.
    void reserve(std::size_t contacts, std::size_t nodes);

    /// Measures the matrix of these contacts with the rod's inverse at the nodes that they touch; O(m n + m^2) for m
    /// contacts that touch n nodes. Where contacts share no piece of the thread nothing is written. Tells each contact
    /// where its list of those that move with it is.
    void measure(State& state, std::vector<ContactConstraint>& contacts, const Pieces& pieces);

    /// The contacts that move when one pushes, increasing: those that share a piece of thread with it, itself among
    /// them unless nothing moves.
    std::span<const Run> coupled_with(const ContactConstraint& contact) const;
    /// How the points of contact c move for pushes at contact d, where they share a piece [m/N]; valid until the next
    /// measure(). By rows, as the whole matrix is: Eigen sums the other way round by columns, to other last bits.
    Block block(std::size_t c, std::size_t d) const;
    /// How every contact's points move for a unit push at contact c along `axis`, 0 to 2: one number an axis [m/N].
    const double* row(std::size_t c, std::size_t axis) const {
        return table_.data() + (3 * c + axis) * static_cast<std::size_t>(size_);
    }

  private:
    void find_touching(const std::vector<ContactConstraint>& contacts);
    void find_places(const State& state, std::vector<ContactConstraint>& contacts, const Pieces& pieces);
    void add_coupled(const std::vector<ContactConstraint>& contacts, const std::array<int, 2>& pieces);
    void find_coupled(std::vector<ContactConstraint>& contacts, const Pieces& pieces);
    void find_inverses(State& state, const Pieces& pieces);
    void find_moves(const ContactConstraint& contact, Eigen::Index axis);
    void forget_moves(const ContactConstraint& contact);
    void mirror(const std::vector<ContactConstraint>& contacts);

    contact::Table table_;
    Eigen::Index size_ = 0;                    // rows and columns, one an axis of a contact
    std::vector<int> touching_;                // nodes that pushes act on, increasing
    std::vector<Eigen::Index> place_;          // of each where its three axes begin among theirs
    std::vector<std::size_t> first_touching_;  // of each piece, among what touches; past the last its end
    std::vector<double> inverses_;  // ChainMatrix::inverse_at each piece's nodes that touch, one after the other
    std::vector<std::size_t> first_inverse_;  // where each begins
    std::vector<Run> coupled_;                // lists of contacts that move together, in runs
    std::vector<std::size_t> first_coupled_;  // where each list begins
    std::vector<double> moves_;               // of what touches, for a unit push at one contact along one axis [m/N]
};

}  // namespace sim::thread::elastic
