#include "sim/knot/homfly.hpp"

#include <map>
#include <string>

#include "sim/geometry/at.hpp"

namespace sim::knot {

namespace {

// First passage, on a tour from the given starts, where a crossing is met first on the wrong level.
struct Tour {
    int bad = 0, first_bad = -1;
};

Tour tour(const Diagram& diagram, const std::vector<int>& starts, bool descending) {
    Tour result;
    std::vector<char> met(diagram.sign.size(), 0);
    for (std::size_t s = 0; s < diagram.strands.size(); ++s) {
        const auto& word = diagram.strands[s];
        for (std::size_t i = 0; i < word.size(); ++i) {
            const Passage p = word[(i + at(starts[s])) % word.size()];
            if (met[at(p.crossing)]) continue;
            met[at(p.crossing)] = 1;
            if (p.over == descending) continue;
            if (result.bad++ == 0) result.first_bad = p.crossing;
        }
    }
    return result;
}

// The tour with the fewest wrong crossings, its starts improved strand by strand.
Tour best_tour(const Diagram& diagram) {
    Tour best{1 << 30, -1};
    for (const bool descending : {true, false}) {
        std::vector<int> starts(diagram.strands.size(), 0);
        Tour here = tour(diagram, starts, descending);
        for (std::size_t s = 0; s < starts.size(); ++s)
            for (int i = 1; i < static_cast<int>(diagram.strands[s].size()); ++i) {
                std::vector<int> other = starts;
                other[s] = i;
                const Tour there = tour(diagram, other, descending);
                if (there.bad < here.bad) here = there, starts = other;
            }
        if (here.bad < best.bad) best = here;
    }
    return best;
}

Diagram switched(Diagram diagram, int crossing) {
    for (auto& word : diagram.strands)
        for (Passage& p : word)
            if (p.crossing == crossing) p.over = !p.over;
    diagram.sign[at(crossing)] = -diagram.sign[at(crossing)];
    return diagram;
}

// The crossing replaced by two strands side by side that keep their directions.
Diagram smoothed(const Diagram& diagram, int crossing) {
    const Places where = places(diagram);
    const Place a = where.over[at(crossing)], b = where.under[at(crossing)];
    const auto tail = [&](Place from, std::size_t count) {
        const auto& word = diagram.strands[at(from.strand)];
        std::vector<Passage> part;
        for (std::size_t k = 1; k <= count; ++k) part.push_back(word[(at(from.index) + k) % word.size()]);
        return part;
    };
    Diagram result{{}, diagram.sign};
    for (int s = 0; s < static_cast<int>(diagram.strands.size()); ++s)
        if (s != a.strand && s != b.strand) result.strands.push_back(diagram.strands[at(s)]);
    const std::size_t na = diagram.strands[at(a.strand)].size(), nb = diagram.strands[at(b.strand)].size();
    if (a.strand == b.strand) {
        const std::size_t from_a = (at(b.index) + na - at(a.index)) % na;
        result.strands.push_back(tail(a, from_a - 1));
        result.strands.push_back(tail(b, na - from_a - 1));
    } else {
        auto joined = tail(a, na - 1);
        const auto rest = tail(b, nb - 1);
        joined.insert(joined.end(), rest.begin(), rest.end());
        result.strands.push_back(std::move(joined));
    }
    std::vector<char> gone(diagram.sign.size(), 0);
    gone[at(crossing)] = 1;
    return without(result, gone);
}

// Crossings renumbered in the order they are met, so that equal diagrams give equal keys more often.
std::string key_of(const Diagram& diagram) {
    std::vector<int> number(diagram.sign.size(), -1);
    int next = 0;
    std::string key;
    for (const auto& word : diagram.strands) {
        for (const Passage p : word) {
            int& n = number[at(p.crossing)];
            if (n < 0) n = next++;
            key.push_back(static_cast<char>(1 + 4 * n + 2 * p.over + (diagram.sign[at(p.crossing)] > 0)));
            key.push_back(static_cast<char>(n >> 6));
        }
        key.push_back(0);
    }
    return key;
}

class Skein {
  public:
    explicit Skein(Work& work) : work_(work) {}

    std::optional<Polynomial> value(Diagram diagram) {
        remove_curls_and_bigons(diagram);
        const int circles = drop_circles(diagram);
        if (diagram.strands.empty()) return unlink(circles);
        std::optional<Polynomial> p = remembered(diagram);
        if (p && circles > 0) p = product(*p, unlink(circles + 1));
        return p;
    }

  private:
    static int drop_circles(Diagram& diagram) {
        const std::size_t before = diagram.strands.size();
        std::erase_if(diagram.strands, [](const auto& word) { return word.empty(); });
        return static_cast<int>(before - diagram.strands.size());
    }

    std::optional<Polynomial> remembered(const Diagram& diagram) {
        const std::string key = key_of(diagram);
        if (const auto known = memory_.find(key); known != memory_.end()) return known->second;
        work_.spend_on_skein(diagram);
        if (work_.is_spent()) return std::nullopt;
        std::optional<Polynomial> p = by_skein(diagram);
        if (p) memory_.emplace(key, *p);
        return p;
    }

    std::optional<Polynomial> by_skein(const Diagram& diagram) {
        const Tour best = best_tour(diagram);
        if (best.bad == 0) return unlink(static_cast<int>(diagram.strands.size()));
        const auto other = value(switched(diagram, best.first_bad));
        if (!other) return std::nullopt;
        const auto joined = value(smoothed(diagram, best.first_bad));
        if (!joined) return std::nullopt;
        return diagram.sign[at(best.first_bad)] > 0 ? sum(scaled(*other, {2, 0, 1}), scaled(*joined, {1, 1, 1}))
                                                    : sum(scaled(*other, {-2, 0, 1}), scaled(*joined, {-1, 1, -1}));
    }

    std::map<std::string, Polynomial> memory_;
    Work& work_;
};

}  // namespace

std::optional<Polynomial> homfly(const Diagram& diagram, Work& work) {
    return Skein(work).value(diagram);
}

}  // namespace sim::knot
