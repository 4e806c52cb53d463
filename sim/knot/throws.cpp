#include "sim/knot/throws.hpp"

#include <algorithm>
#include <array>

#include "sim/geometry/at.hpp"
#include "sim/knot/table.hpp"

namespace sim::knot {

namespace {

std::optional<Throw> throw_of(const Factor& factor) {
    static const std::array<const char*, 4> torus{"3_1", "5_1", "7_1", "9_1"};
    for (int turns = 1; turns <= 4; ++turns)
        if (factor.name == torus[at(turns - 1)]) return Throw{turns, !factor.mirror};
    return std::nullopt;
}

// The gap between passages that most crossings span: the far end of the loop, both strands of every throw beside it.
int middle_of_loop(const Reading& reading) {
    const Places where = places(reading.diagram());
    std::vector<int> spanning(at(reading.passages() + 1), 0);
    for (std::size_t c = 0; c < where.over.size(); ++c) {
        const auto [low, high] = std::minmax(where.over[c].index, where.under[c].index);
        for (int gap = low + 1; gap <= high; ++gap) ++spanning[at(gap)];
    }
    const auto best = std::max_element(spanning.begin(), spanning.end());
    auto last = best;
    for (auto i = best; i != spanning.end() && *i == *best; ++i) last = i;
    return static_cast<int>((best - spanning.begin()) + (last - spanning.begin()) + 1) / 2;
}

// Smallest number in [low, high] for which `holds`, found by halving; `high` when it holds nowhere below.
template <class Holds>
int first_where(int low, int high, const Holds& holds) {
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (holds(middle)) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

// Two knots one after the other, each on its own piece of the strand, are not throws on one loop: where the head first
// is a knot, the tail is another.
bool one_after_the_other(const Reading& reading) {
    const int n = reading.passages();
    const int cut = first_where(6, n, [&](int count) { return knotted(reading.type(0, count)); });
    return knotted(reading.type(cut, n - cut));
}

// `whole` without one factor, if `part` is that; which one.
std::optional<Factor> missing_factor(const std::vector<Factor>& whole, const std::vector<Factor>& part) {
    const std::vector<Factor> missing = taken_from(whole, part);
    return missing.size() == 1 && part.size() + 1 == whole.size() ? std::optional(missing.front()) : std::nullopt;
}

// Throws from the loop outwards, found from the last back: growing from the middle, the largest stretch that lacks
// exactly one throw lacks the last.
std::optional<std::vector<Throw>> throws_in_order(const Reading& reading, std::vector<Factor> factors) {
    const int middle = middle_of_loop(reading), n = reading.passages();
    const auto type_within = [&](int reach) {
        const int first = std::max(0, middle - reach), last = std::min(n, middle + reach);
        return reading.type(first, last - first);
    };
    std::vector<Throw> order;
    int reach = std::max(middle, n - middle);
    while (factors.size() > 1) {
        reach = first_where(0, reach, [&](int r) {
            const auto type = type_within(r);
            return type && type->factors.size() >= factors.size();
        });
        std::optional<Factor> missing;
        while (!missing && --reach > 0)
            if (const auto type = type_within(reach)) missing = missing_factor(factors, type->factors);
        if (!missing) return std::nullopt;
        order.insert(order.begin(), *throw_of(*missing));
        factors = taken_from(factors, {*missing});
    }
    order.insert(order.begin(), *throw_of(factors.front()));
    return order;
}

struct Stretch {
    int first, count;
    bool holds(int passage) const { return first < passage && passage < first + count; }
};

// The shortest stretch that holds both passages of each of its crossings; the whole word at last.
Stretch shortest_closed_stretch(const Diagram& open) {
    const auto& word = open.strands.front();
    const int n = static_cast<int>(word.size());
    Stretch best{0, n};
    for (int first = 0; first < n; ++first) {
        std::vector<char> met(open.sign.size(), 0);
        int halves = 0;
        for (int count = 1; count < best.count && first + count <= n; ++count) {
            char& seen = met[at(word[at(first + count - 1)].crossing)];
            halves += seen ? -1 : 1;
            seen = 1;
            if (halves == 0) best = {first, count};
        }
    }
    return best;
}

Diagram without_stretch(const Diagram& open, const Stretch& stretch) {
    std::vector<char> gone(open.sign.size(), 0);
    for (int k = 0; k < stretch.count; ++k) gone[at(open.strands.front()[at(stretch.first + k)].crossing)] = 1;
    return without(open, gone);
}

// The throws from the loop outwards where they are plain to see, each round the one before: the innermost is closed in
// itself, and when it is taken away the next one is. Nothing where a strand that lies across hides it.
std::optional<std::vector<Throw>> throws_within_each_other(const Reading& reading) {
    std::vector<Throw> throws;
    int innermost = -1;  // where the last throw was
    for (Diagram open = reading.diagram(); open.crossings() > 0;) {
        const Stretch stretch = shortest_closed_stretch(open);
        const auto type = type_of_stretch(open, stretch.first, stretch.count, false, reading.work());
        if (!type || type->factors.size() > 1) return std::nullopt;
        if (!type->factors.empty()) {
            if (innermost >= 0 && !stretch.holds(innermost)) return std::nullopt;
            const auto found = throw_of(type->factors.front());
            if (!found) return std::nullopt;
            throws.push_back(*found);
        }
        open = without_stretch(open, stretch);
        if (!type->factors.empty())
            innermost = stretch.first;
        else if (innermost > stretch.first)
            innermost -= stretch.holds(innermost) ? innermost - stretch.first : stretch.count;
    }
    return throws;
}

bool are_the_same(std::vector<Throw> a, std::vector<Throw> b) {
    const auto before = [](const Throw& s, const Throw& t) {
        return std::pair(s.turns, s.right_handed) < std::pair(t.turns, t.right_handed);
    };
    std::sort(a.begin(), a.end(), before);
    std::sort(b.begin(), b.end(), before);
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Throw& s, const Throw& t) {
        return s.turns == t.turns && s.right_handed == t.right_handed;
    });
}

}  // namespace

std::vector<Throw> throws_of(const std::vector<Factor>& factors) {
    std::vector<Throw> throws;
    for (const Factor& factor : factors)
        if (const auto t = throw_of(factor)) throws.push_back(*t);
    return throws;
}

std::optional<std::vector<Throw>> in_order(const std::vector<Throw>& throws, std::vector<Reading> views,
                                           const Identity& whole) {
    for (const Reading& view : views)
        if (auto plain = throws_within_each_other(view); plain && are_the_same(*plain, throws)) return plain;
    const std::size_t all = views.size();
    const std::vector<Reading> good = good_ones(std::move(views), whole, all);
    if (good.empty() || one_after_the_other(good.front())) return std::nullopt;
    for (const Reading& view : good)
        if (auto found = throws_in_order(view, whole.factors)) return found;
    const bool order_matters = throws.size() > 2 || throws[0].turns != throws[1].turns;
    return order_matters ? std::nullopt : std::optional(throws);
}

std::string notation(const std::vector<Throw>& throws) {
    std::string text;
    for (std::size_t i = 0; i < throws.size(); ++i) {
        if (i > 0) text += throws[i].right_handed == throws[i - 1].right_handed ? 'x' : '=';
        text += std::to_string(throws[i].turns);
    }
    return text;
}

std::string half_hitches(const std::vector<Throw>& throws) {
    std::string text = "S";
    for (std::size_t i = 1; i < throws.size(); ++i)
        text += throws[i].right_handed == throws[i - 1].right_handed ? "=S" : "xS";
    return text;
}

std::string surgeons_name(const std::string& throws) {
    static const std::array<std::pair<const char*, const char*>, 15> names{{{"1", "overhand"},
                                                                            {"2", "double throw"},
                                                                            {"3", "triple throw"},
                                                                            {"1=1", "square"},
                                                                            {"1x1", "granny"},
                                                                            {"2=1", "surgeon's"},
                                                                            {"2x1", "crossed surgeon's"},
                                                                            {"1=2", "reversed surgeon's"},
                                                                            {"2=2", "double square"},
                                                                            {"2x2", "double granny"},
                                                                            {"3=1", "triple surgeon's"},
                                                                            {"1=1=1", "square + square"},
                                                                            {"1x1x1", "triple granny"},
                                                                            {"2=1=1", "surgeon's + square"},
                                                                            {"1=1=1=1", "square + square + square"}}};
    for (const auto& [notation, name] : names)
        if (throws == notation) return name;
    return "throws";
}

}  // namespace sim::knot
