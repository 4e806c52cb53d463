#pragma once
#include <Eigen/Core>
#include <array>

#include "sim/geometry/vec.hpp"

namespace sim::rod {

/// Between two links, as the difference of their tangents: twice the sine of half the angle, which makes the curvature
/// that of the circle through their three nodes. The tangent of half the angle (Bergou et al. 2008, eq. 1) has five
/// times the error.
struct Bend {
    using Block = Eigen::Matrix3d;
    using Vec3 = geometry::Vec3;

    Bend(const Vec3& a, const Vec3& b) : la(a.norm()), lb(b.norm()), ta(a / la), tb(b / lb), difference(tb - ta) {}

    // Half its square changes with the nodes before it, at it and after it by these: with the first, with the last;
    // what the node at it adds makes all of them nought.
    Vec3 by_first() const { return aside(ta) / la; }
    Vec3 by_last() const { return aside(tb) / lb; }

    // Second derivatives by the first node twice, by the last twice, by first and last. `whole`: with how the links'
    // ends turn, without which all of them together are positive.
    struct Second {
        Block first, last, both;
    };
    Second second(bool whole) const {
        const double c = ta.dot(tb);
        const Block both =
            (Block::Identity() - ta * ta.transpose() - tb * tb.transpose() + c * ta * tb.transpose()) / (la * lb);
        Block first = across(ta), last = across(tb);
        if (whole) first += turning(ta), last -= turning(tb);
        return {first / (la * la), last / (lb * lb), both};
    }

    // Twice the tangent of half the angle, along the axis that they bend about.
    Vec3 binormal() const { return 2 / (1 + ta.dot(tb)) * ta.cross(tb); }

    // Upper blocks of the second derivative, by the same nodes, of the angle by which a vector carried from link to
    // link turns (Bergou et al. 2010, "Discrete viscous threads", appendix).
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

    double la, lb;
    Vec3 ta, tb, difference;

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
