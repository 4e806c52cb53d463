#include "scenarios/drill/nearest.hpp"

#include <algorithm>
#include <utility>

namespace scenarios::drill {

namespace {

char small(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Letters to insert, delete, replace or swap with the next to make `b` of `a`, in any case: optimal string alignment
// [Damerau 1964].
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    const auto same = [&](std::size_t i, std::size_t j) { return small(a[i - 1]) == small(b[j - 1]); };
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                least[i][j] = i + j;
                continue;
            }
            least[i][j] =
                std::min({least[i - 1][j] + 1, least[i][j - 1] + 1, least[i - 1][j - 1] + (same(i, j) ? 0 : 1)});
            if (i > 1 && j > 1 && same(i, j - 1) && same(i - 1, j))
                least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
        }
    return least[a.size()][b.size()];
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
    if (word.size() > 60) return best;        // no key is that long
    std::size_t least = word.size() / 8 + 2;  // one slip, and another for every eight letters
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) least = distance, best = candidate;
    }
    return best;
}

std::string unknown_key(const std::string& key, const std::vector<std::string>& known,
                        const std::vector<std::string>& missing) {
    for (const std::string& candidate : known) {
        const Quantity meant = split(candidate);
        if (!meant.unit.empty() && split(key).name == meant.name)
            return "unknown key, this is written in " + meant.unit + " as \"" + candidate + "\"";
    }
    if (const std::string close = nearest(key, missing); !close.empty())
        return "unknown key, did you mean \"" + close + "\"?";
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "\"" : ", \"") + name + "\"";
    return "unknown key, known are " + all;
}

}  // namespace scenarios::drill
