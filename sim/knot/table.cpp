#include "sim/knot/table.hpp"

#include <algorithm>
#include <sstream>
#include <tuple>

#include "sim/knot/table_text.hpp"

namespace sim::knot {

namespace {

constexpr int most_crossings = 10;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
    return parts;
}

Polynomial polynomial_from(const std::string& text) {
    Polynomial p;
    for (const std::string& term : split(text, ' ')) {
        const auto numbers = split(term, ':');
        p.push_back({std::stoi(numbers[0]), std::stoi(numbers[1]), std::stoll(numbers[2])});
    }
    return p;
}

std::vector<int> vector_from(const std::string& text) {
    std::vector<int> v;
    for (const std::string& number : split(text, ' ')) v.push_back(std::stoi(number));
    return v;
}

// Entry k counts longitudes x^k; of the mirror image of the reversed knot, x^-k.
std::vector<int> negated(const std::vector<int>& v) {
    std::vector<int> w(v.size());
    for (std::size_t k = 0; k < v.size(); ++k) w[(v.size() - k) % v.size()] = v[k];
    return w;
}

std::vector<std::vector<int>> products(const std::vector<std::vector<int>>& as,
                                       const std::vector<std::vector<int>>& bs) {
    std::vector<std::vector<int>> result;
    for (const auto& a : as)
        for (const auto& b : bs) {
            std::vector<int> c(a.size(), 0);
            for (std::size_t i = 0; i < a.size(); ++i)
                for (std::size_t j = 0; j < b.size(); ++j) c[(i + j) % a.size()] += a[i] * b[j];
            if (std::find(result.begin(), result.end(), c) == result.end()) result.push_back(c);
        }
    return result;
}

KnownKnot mirror_of(KnownKnot knot) {
    for (Factor& f : knot.factors) f.mirror = !f.mirror;
    knot.homfly = mirrored(knot.homfly);
    for (auto* vectors : {&knot.psl27, &knot.a5})
        for (auto& v : *vectors) v = negated(v);
    return knot;
}

std::vector<KnownKnot> read_primes() {
    std::vector<KnownKnot> primes;
    for (const std::string& line : split(knots_csv, '\n')) {
        const auto cell = split(line, ',');
        if (cell.size() < 8 || cell[0] == "name") continue;
        const int crossings = std::stoi(cell[1]);
        KnownKnot knot{{{cell[0], false, crossings}},
                       crossings,
                       polynomial_from(cell[3]),
                       {vector_from(cell[4]), vector_from(cell[5])},
                       {vector_from(cell[6]), vector_from(cell[7])}};
        primes.push_back(knot);
        if (cell[2] == "0") primes.push_back(mirror_of(knot));
    }
    return primes;
}

// Every sum of primes from `first` on, added to `sum`, that stays within the table's crossings.
void add_sums(const std::vector<KnownKnot>& primes, std::size_t first, const KnownKnot& so_far,
              std::vector<KnownKnot>& all) {
    for (std::size_t i = first; i < primes.size(); ++i) {
        if (so_far.crossings + primes[i].crossings > most_crossings) continue;
        KnownKnot knot{so_far.factors, so_far.crossings + primes[i].crossings, product(so_far.homfly, primes[i].homfly),
                       products(so_far.psl27, primes[i].psl27), products(so_far.a5, primes[i].a5)};
        knot.factors.push_back(primes[i].factors.front());
        sort_factors(knot.factors);
        all.push_back(knot);
        add_sums(primes, i, knot, all);
    }
}

bool less(const Polynomial& a, const Polynomial& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](const Term& s, const Term& t) {
        return std::tie(s.v, s.z, s.coefficient) < std::tie(t.v, t.z, t.coefficient);
    });
}

std::vector<KnownKnot> all_knots() {
    const KnownKnot unknot{{}, 0, {{0, 0, 1}}, {{1, 0, 0, 0, 0, 0, 0}}, {{1, 0, 0}}};
    std::vector<KnownKnot> all{unknot};
    add_sums(read_primes(), 0, unknot, all);
    std::stable_sort(all.begin(), all.end(),
                     [](const KnownKnot& a, const KnownKnot& b) { return less(a.homfly, b.homfly); });
    return all;
}

std::vector<KnownLink> all_links() {
    std::vector<KnownLink> all;
    for (const std::string& line : split(links_csv, '\n')) {
        const auto cell = split(line, ',');
        if (cell.size() < 4 || cell[0] == "name") continue;
        const KnownLink link{cell[0], std::stoi(cell[1]), polynomial_from(cell[2]), polynomial_from(cell[3])};
        const KnownLink mirror{"m" + link.name, link.crossings, mirrored(link.homfly),
                               mirrored(link.homfly_second_reversed)};
        all.push_back(link);
        const bool same = mirror.homfly == link.homfly || mirror.homfly == link.homfly_second_reversed;
        if (!same) all.push_back(mirror);
    }
    return all;
}

const std::vector<KnownKnot>& known_knots() {
    static const std::vector<KnownKnot> all = all_knots();
    return all;
}

// "10_132" -> 10, 132
std::pair<int, int> order_of(const std::string& name) {
    const auto parts = split(name, '_');
    return {std::stoi(parts[0]), std::stoi(parts[1])};
}

}  // namespace

std::vector<const KnownKnot*> knots_with(const Polynomial& homfly) {
    const std::vector<KnownKnot>& all = known_knots();
    std::vector<const KnownKnot*> found;
    auto i = std::lower_bound(all.begin(), all.end(), homfly,
                              [](const KnownKnot& knot, const Polynomial& p) { return less(knot.homfly, p); });
    for (; i != all.end() && i->homfly == homfly; ++i) found.push_back(&*i);
    return found;
}

const Polynomial& listed_homfly(const Factor& factor) {
    const std::vector<KnownKnot>& all = known_knots();
    const auto same = [&](const KnownKnot& k) {
        return k.factors.size() == 1 && k.factors[0].name == factor.name && k.factors[0].mirror == factor.mirror;
    };
    return std::find_if(all.begin(), all.end(), same)->homfly;
}

const std::vector<KnownLink>& known_links() {
    static const std::vector<KnownLink> all = all_links();
    return all;
}

std::string name_of(const Factor& factor) {
    return (factor.mirror ? "m" : "") + factor.name;
}

void sort_factors(std::vector<Factor>& factors) {
    std::sort(factors.begin(), factors.end(), [](const Factor& a, const Factor& b) {
        return std::pair(order_of(a.name), a.mirror) < std::pair(order_of(b.name), b.mirror);
    });
}

std::vector<Factor> taken_from(std::vector<Factor> all, const std::vector<Factor>& taken) {
    for (const Factor& t : taken) {
        const auto same = [&](const Factor& f) { return f.name == t.name && f.mirror == t.mirror; };
        const auto i = std::find_if(all.begin(), all.end(), same);
        if (i != all.end()) all.erase(i);
    }
    return all;
}

std::string name_of(std::vector<Factor> factors) {
    if (factors.empty()) return "0_1";
    sort_factors(factors);
    std::string name;
    for (const Factor& f : factors) name += (name.empty() ? "" : "#") + name_of(f);
    return name;
}

}  // namespace sim::knot
