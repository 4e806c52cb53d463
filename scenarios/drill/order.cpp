#include "scenarios/drill/order.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::optional<double> number_in(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

// What in_words() made of a band; none where it is no band of numbers.
std::optional<Band> band_in(std::string_view words) {
    constexpr std::string_view most = "at most ", least = "at least ", to = " to ";
    if (words.starts_with(most)) {
        const auto high = number_in(words.substr(most.size()));
        return high ? std::optional(Band{0, *high}) : std::nullopt;
    }
    if (words.starts_with(least)) {
        const auto low = number_in(words.substr(least.size()));
        return low ? std::optional(Band{*low, infinite}) : std::nullopt;
    }
    const auto between = words.find(to);
    const auto low = number_in(words.substr(0, between));
    const auto high = between == words.npos ? low : number_in(words.substr(between + to.size()));
    return low && high ? std::optional(Band{*low, *high}) : std::nullopt;
}

double size_of(const Band& band) {
    if (band.low == band.high) return std::max(band.high, 1.0);  // so many of something
    return std::isinf(band.high) ? band.low : band.high - band.low;
}

/// What orders an item: how far outside its band it is, in sizes of the band, below zero inside.
struct Reach {
    Standing standing;
    double outside;
};

// An angle to a wall or a wire is 90 degrees at most: there is nothing beyond to be missed.
double least_room(const Band& band, double value, const std::string& unit) {
    double room = infinite;
    if (band.low > 0) room = value - band.low;
    if (!(unit == "degrees" && band.high >= 90)) room = std::min(room, band.high - value);
    return room;
}

Reach reach_of(const ScoreItem& item) {
    constexpr double near_edge = 0.1;
    if (item.band.empty() && item.passed) return {Standing::unjudged, 0};
    const auto value = number_in(item.value);
    const auto band = band_in(item.band);
    if (!value || !band) return item.passed ? Reach{Standing::passed, -infinite} : Reach{Standing::missed, infinite};
    const double outside = std::max(band->low - *value, *value - band->high) / size_of(*band);
    if (!item.passed) return {Standing::missed, outside};
    const double room = least_room(*band, *value, item.unit) / size_of(*band);
    const bool is_close = band->low < band->high && room < near_edge;
    return {is_close ? Standing::close : Standing::passed, is_close ? -room : -infinite};
}

}  // namespace

std::vector<Placed> by_importance(std::span<const ScoreItem> items) {
    std::vector<Reach> reach;
    std::vector<Placed> order;
    for (const ScoreItem& item : items) {
        reach.push_back(reach_of(item));
        order.push_back({order.size(), reach.back().standing});
    }
    std::stable_sort(order.begin(), order.end(), [&](const Placed& a, const Placed& b) {
        const Reach &one = reach[a.item], &other = reach[b.item];
        return one.standing != other.standing ? one.standing < other.standing : one.outside > other.outside;
    });
    return order;
}

std::string missed_by(const ScoreItem& item) {
    const auto value = number_in(item.value);
    const auto band = band_in(item.band);
    if (item.passed || !value || !band || band->holds(*value)) return "";
    const bool above = *value > band->high;
    // A difference of decimals is one: 12.3 - 12 is 0.3, not 0.3000000000000007.
    constexpr double digits = 1e6;
    const double by = std::round(digits * (above ? *value - band->high : band->low - *value)) / digits;
    return shown(by) + (item.unit.empty() ? "" : " " + item.unit) + (above ? " too much" : " too little");
}

}  // namespace scenarios::drill
