#include "sim/knot/table.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace sim::knot {

extern const char* const table_text;  // table.csv, as it is.

namespace {

// "10_132" sorts by crossings, then number, then the listed image before its mirror.
bool earlier(const Factor& a, const Factor& b) {
    const auto number = [](const Factor& f) { return std::stoi(f.name.substr(f.name.find('_') + 1)); };
    if (a.crossings != b.crossings) return a.crossings < b.crossings;
    if (a.name != b.name) return number(a) < number(b);
    return a.mirror < b.mirror;
}

std::vector<Factor> parse_factors(const std::string& text) {
    std::vector<Factor> factors;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, '#');) {
        const bool is_mirror = part.front() == 'm';
        const std::string name = part.substr(is_mirror);
        factors.push_back({name, is_mirror, std::stoi(name)});
    }
    return factors;
}

Polynomial parse_polynomial(const std::string& text) {
    Polynomial result;
    std::istringstream in(text);
    char colon = 0;
    for (Term t; in >> t.v >> colon >> t.z >> colon >> t.coefficient;) result.push_back(t);
    return result;
}

Colours parse_colours(const std::string& text) {
    Colours result;
    std::istringstream in(text);
    for (int n; in >> n;) result.push_back(n);
    return result;
}

// The longitude's image x^k becomes x^-k.
Colours inverse(Colours c) {
    std::reverse(c.begin() + 1, c.end());
    return c;
}

using Table = std::map<Polynomial, std::vector<Entry>>;

Table read_table() {
    Table table;
    table[{{0, 0, 1}}].push_back({{}, 0, {1, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0}});
    std::istringstream lines(table_text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream in(line);
        std::string name, crossings, amphichiral, polynomial, colours, reverse;
        for (std::string* field : {&name, &crossings, &amphichiral, &polynomial, &colours, &reverse})
            std::getline(in, *field, ',');
        const Entry entry{parse_factors(name), std::stoi(crossings), parse_colours(colours), parse_colours(reverse)};
        const Polynomial p = parse_polynomial(polynomial);
        table[p].push_back(entry);
        if (amphichiral == "1" || entry.factors.size() > 1) continue;
        Entry other = entry;  // The mirror image of a knot is that of its reverse, up to the direction we ignore.
        other.factors.front().mirror = true;
        other.colours = inverse(entry.reverse_colours);
        other.reverse_colours = inverse(entry.colours);
        table[mirror(p)].push_back(other);
    }
    return table;
}

}  // namespace

void sort_factors(std::vector<Factor>& factors) {
    std::sort(factors.begin(), factors.end(), earlier);
}

std::string joined_name(std::vector<Factor> factors) {
    sort_factors(factors);
    std::string name;
    for (const Factor& f : factors) name += (name.empty() ? "" : "#") + std::string(f.mirror ? "m" : "") + f.name;
    return name.empty() ? "0_1" : name;
}

std::string Entry::name() const {
    return joined_name(factors);
}

const std::vector<Entry>& types_with(const Polynomial& homfly) {
    static const Table table = read_table();
    static const std::vector<Entry> none;
    const auto found = table.find(homfly);
    return found == table.end() ? none : found->second;
}

}  // namespace sim::knot
