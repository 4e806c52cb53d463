#include "sim/knot/colour.hpp"

#include <algorithm>
#include <array>

namespace sim::knot {

namespace {

using Permutation = std::array<int, 7>;

constexpr Permutation identity = {0, 1, 2, 3, 4, 5, 6};
constexpr Permutation x = {1, 2, 3, 4, 5, 6, 0};  // Generates PSL(2,7) together with `other`, acting on seven points.
constexpr Permutation other = {1, 0, 2, 6, 4, 5, 3};

// First a, then b.
Permutation product(const Permutation& a, const Permutation& b) {
    Permutation result{};
    for (size_t i = 0; i < 7; ++i) result[i] = b[a[i]];
    return result;
}

Permutation inverse(const Permutation& a) {
    Permutation result{};
    for (size_t i = 0; i < 7; ++i) result[a[i]] = static_cast<int>(i);
    return result;
}

Permutation conjugate(const Permutation& a, const Permutation& by) {
    return product(product(inverse(by), a), by);
}

// The 24 conjugates of x, x first, and what conjugation by one does to another.
struct Class {
    std::vector<Permutation> members = {x};
    std::vector<std::vector<int>> conjugated, back;  // [a][b]: b^-1 a b and b a b^-1

    int index(const Permutation& p) const {
        return static_cast<int>(std::find(members.begin(), members.end(), p) - members.begin());
    }

    Class() {
        for (size_t i = 0; i < members.size(); ++i)
            for (const Permutation& by : {x, other})
                if (const Permutation c = conjugate(members[i], by); index(c) == static_cast<int>(members.size()))
                    members.push_back(c);
        for (const Permutation& a : members) {
            conjugated.emplace_back();
            back.emplace_back();
            for (const Permutation& b : members) {
                conjugated.back().push_back(index(conjugate(a, b)));
                back.back().push_back(index(conjugate(a, inverse(b))));
            }
        }
    }
};

// The arcs of a crossing; arcs run from under passage to under passage.
struct Rule {
    int in = 0, out = 0, over = 0, sign = 0;
};

std::vector<Rule> rules_of(const Diagram& knot) {
    const Word& word = knot.words.front();
    const int arcs = static_cast<int>(word.size() / 2);
    std::vector<Rule> by_crossing(knot.sign.size()), result;
    int arc = 0;
    std::vector<int> order;
    for (const Passage& p : word) {
        Rule& rule = by_crossing[p.crossing];
        if (p.over) {
            rule.over = arc % arcs;
        } else {
            rule.in = arc, rule.out = (arc + 1) % arcs, rule.sign = knot.sign[p.crossing];
            order.push_back(p.crossing);
            ++arc;
        }
    }
    for (const int crossing : order) result.push_back(by_crossing[crossing]);
    return result;
}

class Counter {
  public:
    explicit Counter(const std::vector<Rule>& rules) : rules_(rules), colour_(rules.size(), -1), counts_(7) {}

    Colours count() {
        colour_[0] = 0;
        extend();
        return counts_;
    }

  private:
    // Colours what follows, then tries every colour for the arc from which most would follow.
    void extend() {
        const std::vector<int> before = colour_;
        if (follow()) {
            const int arc = best_arc();
            if (arc < 0) {
                tally();
            } else {
                for (size_t c = 0; c < group().members.size(); ++c) {
                    colour_[arc] = static_cast<int>(c);
                    extend();
                    colour_[arc] = -1;
                }
            }
        }
        colour_ = before;
    }

    bool follow() {
        for (bool changed = true; changed;) {
            changed = false;
            for (const Rule& r : rules_) {
                const int y = colour_[r.over];
                if (y < 0) continue;
                int &in = colour_[r.in], &out = colour_[r.out];
                if (in < 0 && out < 0) continue;
                const auto& forth = r.sign > 0 ? group().conjugated : group().back;
                const auto& home = r.sign > 0 ? group().back : group().conjugated;
                if (in < 0) in = home[out][y], changed = true;
                if (out < 0) out = forth[in][y], changed = true;
                if (forth[in][y] != out) return false;
            }
        }
        return true;
    }

    int best_arc() const {
        int best = -1, most = -1;
        for (size_t arc = 0; arc < colour_.size(); ++arc) {
            if (colour_[arc] >= 0) continue;
            int helped = 0;
            for (const Rule& r : rules_) {
                const bool over = r.over == static_cast<int>(arc),
                           under = r.in == static_cast<int>(arc) || r.out == static_cast<int>(arc);
                helped += over && (colour_[r.in] >= 0 || colour_[r.out] >= 0);
                helped += under && colour_[r.over] >= 0;
            }
            if (helped > most) most = helped, best = static_cast<int>(arc);
        }
        return best;
    }

    void tally() {
        Permutation longitude = identity;
        int writhe = 0;
        for (const Rule& r : rules_) {
            const Permutation& y = group().members[colour_[r.over]];
            longitude = product(longitude, r.sign > 0 ? y : inverse(y));
            writhe += r.sign;
        }
        // It commutes with x, so it is a power of x: x^k sends 0 to k.
        counts_[((longitude[0] - writhe) % 7 + 7) % 7] += 1;
    }

    static const Class& group() {
        static const Class the_class;
        return the_class;
    }

    const std::vector<Rule>& rules_;
    std::vector<int> colour_;
    Colours counts_;
};

}  // namespace

Colours colours(const Diagram& knot) {
    if (knot.crossings() == 0) return {1, 0, 0, 0, 0, 0, 0};
    const std::vector<Rule> rules = rules_of(knot);
    return Counter(rules).count();
}

}  // namespace sim::knot
