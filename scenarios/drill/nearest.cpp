#include "scenarios/drill/nearest.hpp"

#include <algorithm>
#include <utility>

namespace scenarios::drill {

namespace {

// Letters to insert, delete or replace to make `b` of `a` [Wagner and Fischer 1974].
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
        }
    }
    return row.back();
}

struct Quantity {
    std::string name, unit;
};

// "length_mm" is "length" in "mm"; "density_kg_m3" is "density" in "kg_m3"; "friction_tool" has no unit.
Quantity split(const std::string& key) {
    for (const char* unit : {"kg_m3", "g_cm3", "kg", "um", "mm", "cm", "m",   "inch", "in",  "ms",  "s",
                             "sec",   "min",   "mN", "N",  "gf", "Pa", "kPa", "MPa",  "GPa", "deg", "rad"}) {
        const std::string ending = std::string("_") + unit;
        if (key.size() > ending.size() && key.ends_with(ending))
            return {key.substr(0, key.size() - ending.size()), unit};
    }
    return {key, ""};
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    if (word.size() > 60) return best;  // no key is that long
    std::size_t least = word.size() / 3 + 1;
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) least = distance, best = candidate;
    }
    return best;
}

std::string unknown_key(const std::string& key, const std::vector<std::string>& known) {
    for (const std::string& candidate : known) {
        const Quantity meant = split(candidate);
        if (!meant.unit.empty() && split(key).name == meant.name)
            return "unknown key, this is written in " + meant.unit + " as \"" + candidate + "\"";
    }
    if (const std::string close = nearest(key, known); !close.empty())
        return "unknown key, did you mean \"" + close + "\"?";
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "\"" : ", \"") + name + "\"";
    return "unknown key, known are " + all;
}

}  // namespace scenarios::drill
