#pragma once
#include <Eigen/Core>
#include <array>

#include "sim/geometry/vec.hpp"

namespace sim::rod {

/// The bend between two links, measured as the difference of their unit tangents: its length is twice the sine of half
/// the angle, which makes the curvature that of the circle through their three nodes. The tangent of half the angle
/// (Bergou et al. 2008, eq. 1) has five times the error.
struct Bend {
    using Block = Eigen::Matrix3d;  ///< A 3 x 3 matrix: derivatives by one node's place and another's.
    using Vec3 = geometry::Vec3;    ///< A vector in the world's frame.

    /// The bend from a link along `a` to the next along `b` [m], neither of length zero.
    Bend(const Vec3& a, const Vec3& b) : la(a.norm()), lb(b.norm()), ta(a / la), tb(b / lb), difference(tb - ta) {}

    /// The derivative of half the bend's square by the place of the first of the three nodes [1/m]. The derivative by
    /// the middle node is minus the sum of this and by_last().
    Vec3 by_first() const { return aside(ta) / la; }
    /// The derivative of half the bend's square by the place of the last of the three nodes [1/m].
    Vec3 by_last() const { return aside(tb) / lb; }

    /// Second derivatives of half the bend's square [1/m^2].
    struct Second {
        Block first;  ///< By the first node twice.
        Block last;   ///< By the last node twice.
        Block both;   ///< By the first node and the last.
    };
    /// The second derivatives: with `whole` exact; else without how the links' ends turn, which leaves them positive
    /// semidefinite together.
    Second second(bool whole) const {
        const double c = ta.dot(tb);
        const Block both =
            (Block::Identity() - ta * ta.transpose() - tb * tb.transpose() + c * ta * tb.transpose()) / (la * lb);
        Block first = across(ta), last = across(tb);
        if (whole) first += turning(ta), last -= turning(tb);
        return {first / (la * la), last / (lb * lb), both};
    }

    /// The curvature binormal (Bergou et al. 2008, eq. 1): along the axis of the bend, twice the tangent of half its
    /// angle long.
    Vec3 binormal() const { return 2 / (1 + ta.dot(tb)) * ta.cross(tb); }

    /// Upper blocks of the second derivative, by the three nodes in order, of the angle by which a vector carried from
    /// link to link turns [1/m^2] (Bergou et al. 2010, "Discrete viscous threads", appendix); blocks below the diagonal
    /// are zero.
    std::array<std::array<Block, 3>, 3> turn_by_nodes() const {
        const double chi = 1 + ta.dot(tb);
        const Vec3 k = binormal(), middle = (ta + tb) / chi;
        const auto own = [&](const Vec3& t, double l) -> Block {
            return -0.25 / (l * l) * (k * (t + middle).transpose() + (t + middle) * k.transpose());
        };
        const Block a = own(ta, la), b = own(tb, lb), none = Block::Zero();
        const Block ab = 0.5 / (la * lb) * (2 / chi * cross_matrix(ta) - k * middle.transpose());
        return {{{a, ab - a, -ab}, {none, a - ab - ab.transpose() + b, ab - b}, {none, none, b}}};
    }

    double la, lb;    ///< Lengths of the two links [m].
    Vec3 ta, tb;      ///< Unit tangents of the two links.
    Vec3 difference;  ///< The bend: tb - ta, of length 0 to 2.

  private:
    static Block cross_matrix(const Vec3& v) {
        Block m;
        m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
        return m;
    }
    static Block across(const Vec3& t) { return Block::Identity() - t * t.transpose(); }
    Vec3 aside(const Vec3& t) const { return difference - difference.dot(t) * t; }
    Block turning(const Vec3& t) const {
        const Vec3 u = aside(t);
        return u * t.transpose() + t * u.transpose() + difference.dot(t) * across(t);
    }
};

}  // namespace sim::rod
