#include "sim/knot/surgical.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "sim/knot/table.hpp"

namespace sim::knot {

namespace {

using Throws = std::vector<Throw>;
using NamePart = std::function<Name(const std::vector<Vec3>&)>;

constexpr size_t most_throws = 5;  // 120 orders to weigh; nobody ties more.
constexpr int growth_steps = 24;   // Pieces looked at between the loop and the whole knot.
constexpr size_t cuts = 20;        // Places where an end is cut back to find a slip knot.
constexpr int smallest_knot = 3;   // Crossings.

Factor as_factor(int turns, bool right_handed) {
    return {std::to_string(2 * turns + 1) + "_1", !right_handed, 2 * turns + 1};
}

// What a piece may be that holds some throws whole and the next one in part.
std::set<std::string> stages(const Throws& throws) {
    std::set<std::string> result = {"0_1"};
    std::vector<Factor> whole;
    for (const Throw& t : throws) {
        for (int turns = 1; turns <= t.turns; ++turns) {
            std::vector<Factor> stage = whole;
            stage.push_back(as_factor(turns, t.right_handed));
            result.insert(joined_name(stage));
        }
        whole.push_back(as_factor(t.turns, t.right_handed));
    }
    return result;
}

std::vector<Vec3> piece(const std::vector<Vec3>& curve, size_t from, size_t to) {
    return {curve.begin() + static_cast<std::ptrdiff_t>(from), curve.begin() + static_cast<std::ptrdiff_t>(to) + 1};
}

// The knot's own stretch: cut each end back as far as the whole type remains.
std::pair<size_t, size_t> extent_of(const std::vector<Vec3>& curve, const NamePart& name_part,
                                    const std::string& knot) {
    const size_t n = curve.size();
    size_t from = 0, beyond = n - 2;
    while (beyond - from > 1) {
        const size_t middle = (from + beyond) / 2;
        (name_part(piece(curve, middle, n - 1)).knot == knot ? from : beyond) = middle;
    }
    size_t to = n - 1, below = from + 1;
    while (to - below > 1) {
        const size_t middle = (to + below) / 2;
        (name_part(piece(curve, from, middle)).knot == knot ? to : below) = middle;
    }
    return {from, to};
}

// How often each type is met while a piece grows evenly from the middle of the knot's stretch, where the loop is.
std::map<std::string, int> grow(const std::vector<Vec3>& curve, const NamePart& name_part, const std::string& knot) {
    const auto [from, to] = extent_of(curve, name_part, knot);
    std::map<std::string, int> met;
    for (int step = 1; step <= growth_steps; ++step) {
        const size_t cut = (to - from) * static_cast<size_t>(growth_steps - step) / (2 * growth_steps);
        if (to - from < 2 * cut + 3) continue;
        ++met[name_part(piece(curve, from + cut, to - cut)).knot];
    }
    return met;
}

// Every order of the throws with a notation of its own.
std::map<std::string, std::vector<Throws>> orders(Throws throws) {
    const auto less = [](const Throw& a, const Throw& b) {
        return a.turns != b.turns ? a.turns < b.turns : a.right_handed < b.right_handed;
    };
    std::sort(throws.begin(), throws.end(), less);
    std::map<std::string, std::vector<Throws>> result;
    do result[notation(throws)].push_back(throws);
    while (std::next_permutation(throws.begin(), throws.end(), less));
    return result;
}

std::string order_seen(const std::map<std::string, std::vector<Throws>>& possible,
                       const std::map<std::string, int>& met) {
    std::string best;
    int best_score = -1, second_score = -1;
    for (const auto& [text, readings] : possible) {
        int score = 0;
        for (const Throws& throws : readings) {
            int fits = 0;
            for (const std::string& stage : stages(throws))
                if (const auto seen = met.find(stage); seen != met.end()) fits += seen->second;
            score = std::max(score, fits);
        }
        if (score > best_score) {
            second_score = best_score;
            best_score = score, best = text;
        } else {
            second_score = std::max(second_score, score);
        }
    }
    return best_score > second_score ? best : "";
}

// A noose is no knot as a whole but one as soon as its end is cut back into the bight. Two cuts in a row must agree.
bool is_slip(const std::vector<Vec3>& curve, const NamePart& name_part) {
    const size_t n = curve.size();
    for (const bool from_start : {true, false}) {
        std::string previous = "0_1";
        for (size_t i = 1; i < cuts; ++i) {
            const size_t cut = i * (n - 1) / cuts;
            if (n - cut < 4) break;
            const Name part = name_part(from_start ? piece(curve, cut, n - 1) : piece(curve, 0, n - 1 - cut));
            const std::string knot = part.certain ? part.knot : "0_1";
            if (knot != "0_1" && knot == previous) return true;
            previous = knot;
        }
    }
    return false;
}

}  // namespace

std::optional<Throw> as_throw(const Factor& factor) {
    if (factor.crossings % 2 == 0 || factor.name != std::to_string(factor.crossings) + "_1") return std::nullopt;
    return Throw{(factor.crossings - 1) / 2, !factor.mirror};
}

std::string notation(const std::vector<Throw>& throws) {
    std::string text;
    for (size_t i = 0; i < throws.size(); ++i) {
        if (i > 0) text += throws[i].right_handed == throws[i - 1].right_handed ? 'x' : '=';
        text += std::to_string(throws[i].turns);
    }
    return text;
}

void read_throws(const std::vector<Vec3>& curve, const std::function<Name(const std::vector<Vec3>&)>& name_part,
                 Name& name) {
    if (name.knot == "unknown") return;
    if (name.factors.empty()) {
        if (name.crossings_projected >= smallest_knot && is_slip(curve, name_part)) name.surgical = "slip";
        return;
    }
    Throws throws;
    for (const Factor& factor : name.factors)
        if (const std::optional<Throw> t = as_throw(factor)) throws.push_back(*t);
    if (throws.size() != name.factors.size() || throws.size() > most_throws) return;
    const auto possible = orders(throws);
    name.throws =
        possible.size() == 1 ? possible.begin()->first : order_seen(possible, grow(curve, name_part, name.knot));
    static const std::map<std::string, std::string> names = {{"1", "overhand"},    {"2", "double"},
                                                             {"1=1", "square"},    {"1x1", "granny"},
                                                             {"2=1", "surgeon's"}, {"1=2", "reversed surgeon's"}};
    if (const auto known = names.find(name.throws); known != names.end()) name.surgical = known->second;
}

}  // namespace sim::knot
