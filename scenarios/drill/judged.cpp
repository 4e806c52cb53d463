#include "scenarios/drill/judged.hpp"

#include <charconv>
#include <cmath>

#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

std::string fixed(double value, int digits) {
    char text[400];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr};
}

std::string in_words(const Band& band) {
    if (band.low == band.high) return shown(band.low);
    if (band.low > 0 && std::isinf(band.high)) return "at least " + shown(band.low);
    if (band.low > 0) return shown(band.low) + " to " + shown(band.high);
    return "at most " + shown(band.high);
}

// With as many digits as show that it is outside.
static std::string told_apart(double value, int digits, const Band& band) {
    constexpr int most = 15;
    std::string text = fixed(value, digits);
    while (digits < most && band.holds(std::stod(text))) text = fixed(value, ++digits);
    return text;
}

std::optional<double> number_or_none(double value) {
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

ScoreItem judged(const Reading& reading, const std::optional<Band>& band) {
    ScoreItem item{
        reading.name, reading.title, fixed(reading.value, reading.digits), reading.unit, "", true, reading.at_s, ""};
    item.number = number_or_none(reading.value);
    if (!band) return item;
    item.band = in_words(*band);
    item.passed = band->holds(reading.value);
    if (!item.passed) item.value = told_apart(reading.value, reading.digits, *band);
    if (!item.passed) item.why = reading.value > band->high ? reading.too_much : reading.too_little;
    return item;
}

}  // namespace scenarios::drill
