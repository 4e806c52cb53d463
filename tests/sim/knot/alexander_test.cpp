#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "sim/knot/table.hpp"
#include "tests/bench/lab/random.hpp"
#include "tests/sim/knot/ropes.hpp"

// Names checked by a slow plain way that shares no code with them: Alexander's polynomial at two numbers modulo a
// prime, from every crossing of one raw view, by elimination; and the same of what the name says.

using bench::lab::Random;
using ropes::Rope;
using ropes::Vec3;

namespace {

constexpr std::int64_t prime = 2147483647;

std::int64_t times(std::int64_t a, std::int64_t b) {
    return a * b % prime;
}

std::int64_t inverse(std::int64_t a) {
    std::int64_t result = 1;
    for (std::int64_t e = prime - 2; e > 0; e /= 2, a = times(a, a))
        if (e % 2) result = times(result, a);
    return result;
}

struct Under {
    double at;       // edge and place along it where the strand passes under,
    double over_at;  // and where the strand above it passes
    bool positive;
};

// Seen along z; the rope lies anyhow.
std::vector<Under> unders_of(const Rope& rope) {
    std::vector<Under> unders;
    const std::size_t n = rope.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue;
            const Vec3 &a = rope[i], &c = rope[j];
            const Vec3 u = rope[i + 1] - a, v = rope[(j + 1) % n] - c, w = c - a;
            const double turn = u.x() * v.y() - u.y() * v.x();
            const double s = (w.x() * v.y() - w.y() * v.x()) / turn, t = (w.x() * u.y() - w.y() * u.x()) / turn;
            if (s <= 0 || s >= 1 || t <= 0 || t >= 1) continue;
            const bool first_over = a.z() + s * u.z() > c.z() + t * v.z();
            const double at_i = static_cast<double>(i) + s, at_j = static_cast<double>(j) + t;
            unders.push_back({first_over ? at_j : at_i, first_over ? at_i : at_j, (turn > 0) == first_over});
        }
    std::sort(unders.begin(), unders.end(), [](const Under& a, const Under& b) { return a.at < b.at; });
    return unders;
}

// Up to sign and powers of t. Arc k ends at the k-th under passage; the determinant without one row and column.
std::int64_t alexander_at(std::int64_t t, const std::vector<Under>& unders) {
    const std::size_t n = unders.size();
    if (n < 2) return 1;
    std::vector<std::vector<std::int64_t>> m(n, std::vector<std::int64_t>(n, 0));
    for (std::size_t k = 0; k < n; ++k) {
        const auto above = std::lower_bound(unders.begin(), unders.end(), unders[k].over_at,
                                            [](const Under& u, double at) { return u.at < at; });
        const std::size_t over = static_cast<std::size_t>(above - unders.begin()) % n, out = (k + 1) % n;
        const auto add = [&](std::size_t arc, std::int64_t x) { m[k][arc] = (m[k][arc] + x + prime) % prime; };
        add(over, 1 - t);
        add(unders[k].positive ? k : out, t);
        add(unders[k].positive ? out : k, -1);
    }
    std::int64_t determinant = 1;
    for (std::size_t c = 0; c + 1 < n; ++c) {
        std::size_t pivot = c;
        while (pivot + 1 < n && m[pivot][c] == 0) ++pivot;
        if (pivot + 1 == n) return 0;
        std::swap(m[c], m[pivot]);
        determinant = times(determinant, m[c][c]);
        const std::int64_t by = inverse(m[c][c]);
        for (std::size_t r = c + 1; r + 1 < n; ++r) {
            if (m[r][c] == 0) continue;
            const std::int64_t factor = times(m[r][c], by);
            for (std::size_t k = c; k + 1 < n; ++k) m[r][k] = (m[r][k] + prime - times(factor, m[c][k])) % prime;
        }
    }
    return determinant;
}

// P(v = 1, z^2 = t - 2 + 1/t) of each factor.
std::int64_t alexander_at(std::int64_t t, const sim::knot::Name& name) {
    const std::int64_t z2 = (t - 2 + inverse(t) + prime) % prime;
    std::int64_t product = 1;
    for (const auto& factor : name.factors) {
        std::int64_t sum = 0;
        for (const auto& term : sim::knot::listed_homfly(factor)) {
            std::int64_t power = 1;
            for (int i = 0; i < term.z; i += 2) power = times(power, z2);
            sum = (sum + times(power, (term.coefficient % prime + prime) % prime)) % prime;
        }
        product = times(product, sum);
    }
    return product;
}

bool equal_up_to_units(std::int64_t a, std::int64_t b, std::int64_t t, std::size_t most_powers) {
    for (std::size_t k = 0; k <= most_powers; ++k, a = times(a, t))
        if (a == b || a == (prime - b) % prime) return true;
    return false;
}

Rope closed_polygon(std::uint64_t seed) {
    Random random(seed);
    const int vertices = 8 + random.below(seed % 2 ? 40 : 150);
    Rope rope{Vec3::Zero()};
    for (int i = 1; i < vertices; ++i) {
        const Vec3 drawn(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        rope.push_back(seed % 2 ? drawn : Vec3(rope.back() + drawn));
    }
    return rope;
}

}  // namespace

TEST(Alexander, OfRandomPolygonsIsThatOfTheirNames) {
    int named = 0, knotted = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Rope rope = closed_polygon(seed);
        const auto name = sim::knot::name_knot(rope, true);
        if (name.knot == "unknown") continue;
        ++named, knotted += !name.factors.empty();
        const auto unders = unders_of(rope);
        for (const std::int64_t t : {3, 10})
            EXPECT_TRUE(equal_up_to_units(alexander_at(t, name), alexander_at(t, unders), t, 2 * unders.size()) ||
                        equal_up_to_units(alexander_at(t, unders), alexander_at(t, name), t, 2 * unders.size()))
                << "seed " << seed << ": " << name.knot << ", " << unders.size() << " crossings";
    }
    EXPECT_GT(named, 150);
    EXPECT_GT(knotted, 50);
}

// The oracle itself: a wrong name is told from a right one.
TEST(Alexander, TellsKnotsApart) {
    const auto trefoil = ropes::torus_knot(3), five = ropes::torus_knot(5);
    std::mt19937 random(1);
    const auto unders = unders_of(ropes::turned(trefoil, random));
    EXPECT_TRUE(
        equal_up_to_units(alexander_at(3, sim::knot::name_knot(trefoil, true)), alexander_at(3, unders), 3, 100));
    EXPECT_FALSE(equal_up_to_units(alexander_at(3, sim::knot::name_knot(five, true)), alexander_at(3, unders), 3, 100));
}
