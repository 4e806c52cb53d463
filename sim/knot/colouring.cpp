#include "sim/knot/colouring.hpp"

#include <algorithm>
#include <array>

#include "sim/geometry/at.hpp"

namespace sim::knot {

namespace {

// A permutation p: i -> p[i] of seven points (A5 leaves two of them alone). Products act left first.
using Permutation = std::array<unsigned char, 7>;

Permutation times(const Permutation& a, const Permutation& b) {
    Permutation c{};
    for (std::size_t i = 0; i < 7; ++i) c[i] = b[a[i]];
    return c;
}

Permutation inverse(const Permutation& a) {
    Permutation c{};
    for (std::size_t i = 0; i < 7; ++i) c[a[i]] = static_cast<unsigned char>(i);
    return c;
}

// The conjugates of x, and how they conjugate one another.
struct Conjugates {
    std::vector<Permutation> element;     // element[0] is x
    std::vector<std::vector<int>> moved;  // moved[y][u]: y^-1 u y
    std::vector<std::vector<int>> moved_back;
    int order;

    Conjugates(const Permutation& x, int order_of_x, const std::array<Permutation, 2>& generators)
        : element{x}, order(order_of_x) {
        const auto index_of = [&](const Permutation& p) {
            return static_cast<int>(std::find(element.begin(), element.end(), p) - element.begin());
        };
        for (std::size_t i = 0; i < element.size(); ++i)
            for (const Permutation& g : generators) {
                const Permutation c = times(times(inverse(g), element[i]), g);
                if (index_of(c) == static_cast<int>(element.size())) element.push_back(c);
            }
        moved.assign(element.size(), std::vector<int>(element.size()));
        moved_back = moved;
        for (std::size_t y = 0; y < element.size(); ++y)
            for (std::size_t u = 0; u < element.size(); ++u) {
                const int to = index_of(times(times(inverse(element[y]), element[u]), element[y]));
                moved[y][u] = to;
                moved_back[y][at(to)] = static_cast<int>(u);
            }
    }
};

const Conjugates& conjugates(Group group) {
    static const Conjugates psl27({1, 2, 3, 4, 5, 6, 0}, 7, {{{1, 2, 3, 4, 5, 6, 0}, {1, 0, 2, 6, 4, 5, 3}}});
    static const Conjugates a5({1, 2, 0, 3, 4, 5, 6}, 3, {{{1, 2, 3, 4, 0, 5, 6}, {1, 2, 0, 3, 4, 5, 6}}});
    return group == Group::psl27 ? psl27 : a5;
}

// Crossing i is the i-th under passage on the tour; arcs i and i + 1 (cyclically) meet there, under arc `over`.
struct Wirtinger {
    std::vector<int> over;
    std::vector<bool> positive;
    int writhe = 0;

    explicit Wirtinger(const Diagram& knot) {
        const auto& word = knot.strands.front();
        std::vector<int> arc_over(knot.sign.size());
        std::vector<int> unders;
        int arc = 0;
        const int arcs = knot.crossings();
        for (const Passage p : word) {
            if (p.over) {
                arc_over[at(p.crossing)] = arc;
            } else {
                unders.push_back(p.crossing);
                arc = (arc + 1) % arcs;
            }
        }
        for (const int c : unders) {
            over.push_back(arc_over[at(c)]);
            positive.push_back(knot.sign[at(c)] > 0);
            writhe += knot.sign[at(c)];
        }
    }
};

// In which order colours are found: which arcs follow from which does not depend on their colours.
struct Step {
    enum Kind { guess, out_from_in, in_from_out, check } kind;
    int at;  ///< An arc to guess, else a crossing.
};

class Plan {
  public:
    explicit Plan(const Wirtinger& knot) : knot_(knot), known_(knot.over.size(), 0), used_(knot.over.size(), 0) {
        known_[0] = 1;
        deduce();
        for (int arc = best_guess(); arc >= 0; arc = best_guess()) {
            steps.push_back({Step::guess, arc});
            known_[at(arc)] = 1;
            deduce();
        }
    }

    std::vector<Step> steps;

  private:
    void deduce() {
        const int n = static_cast<int>(known_.size());
        for (bool changed = true; changed;) {
            changed = false;
            for (int i = 0; i < n; ++i) {
                char &in = known_[at(i)], &out = known_[at((i + 1) % n)];
                if (used_[at(i)] || !known_[at(knot_.over[at(i)])] || (!in && !out)) continue;
                steps.push_back({in && out ? Step::check : in ? Step::out_from_in : Step::in_from_out, i});
                in = out = used_[at(i)] = 1;
                changed = true;
            }
        }
    }

    // The unknown arc from which most others follow; -1 when all are known.
    int best_guess() {
        const Plan before = *this;
        int best = -1;
        std::size_t most = 0;
        for (std::size_t arc = 0; arc < before.known_.size(); ++arc) {
            if (before.known_[arc]) continue;
            known_[arc] = 1;
            deduce();
            if (best < 0 || steps.size() > most) best = static_cast<int>(arc), most = steps.size();
            known_ = before.known_, used_ = before.used_, steps = before.steps;
        }
        return best;
    }

    const Wirtinger& knot_;
    std::vector<char> known_, used_;
};

class Counter {
  public:
    Counter(const Wirtinger& knot, const Conjugates& group)
        : knot_(knot), group_(group), plan_(knot), counts_(at(group.order), 0), colour_(knot.over.size(), 0) {}

    std::optional<std::vector<int>> run() {
        go_on_from(0);
        if (trials_ > most_trials) return std::nullopt;
        return counts_;
    }

  private:
    static constexpr long most_trials = 1000000;

    void go_on_from(std::size_t first) {
        const int n = static_cast<int>(colour_.size());
        for (std::size_t k = first; k < plan_.steps.size(); ++k) {
            const Step step = plan_.steps[k];
            if (step.kind == Step::guess) {
                for (int c = 0; c < static_cast<int>(group_.element.size()) && ++trials_ <= most_trials; ++c) {
                    colour_[at(step.at)] = c;
                    go_on_from(k + 1);
                }
                return;
            }
            const int y = colour_[at(knot_.over[at(step.at)])];
            int &in = colour_[at(step.at)], &out = colour_[at((step.at + 1) % n)];
            const bool positive = knot_.positive[at(step.at)];
            const auto& forth = positive ? group_.moved : group_.moved_back;
            const auto& back = positive ? group_.moved_back : group_.moved;
            if (step.kind == Step::check && forth[at(y)][at(in)] != out) return;
            if (step.kind == Step::out_from_in) out = forth[at(y)][at(in)];
            if (step.kind == Step::in_from_out) in = back[at(y)][at(out)];
        }
        count();
    }

    void count() {
        Permutation longitude{0, 1, 2, 3, 4, 5, 6};
        for (std::size_t i = 0; i < colour_.size(); ++i) {
            const Permutation& y = group_.element[at(colour_[at(knot_.over[i])])];
            longitude = times(longitude, knot_.positive[i] ? y : inverse(y));
        }
        const Permutation& x = group_.element[0];
        const Permutation x_inverse = inverse(x);
        for (int i = 0; i < std::abs(knot_.writhe); ++i) longitude = times(longitude, knot_.writhe > 0 ? x_inverse : x);
        Permutation power{0, 1, 2, 3, 4, 5, 6};
        for (int k = 0; k < group_.order; ++k, power = times(power, x))
            if (power == longitude) ++counts_[at(k)];
    }

    const Wirtinger& knot_;
    const Conjugates& group_;
    const Plan plan_;
    std::vector<int> counts_, colour_;
    long trials_ = 0;
};

}  // namespace

std::optional<std::vector<int>> colouring_vector(const Diagram& knot, Group group) {
    if (knot.crossings() == 0) {
        std::vector<int> unknot(at(conjugates(group).order), 0);
        unknot[0] = 1;
        return unknot;
    }
    const Wirtinger presentation(knot);
    return Counter(presentation, conjugates(group)).run();
}

}  // namespace sim::knot
