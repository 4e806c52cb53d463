#pragma once
#include <string>
#include <vector>

namespace scenarios::drill {

/// The names of all, for a message: "left" or "right", each in quotes.
template <class Named>
std::string names_of(const std::vector<Named>& all) {
    std::string names;
    for (const Named& one : all) names += (names.empty() ? "\"" : " or \"") + one.name + "\"";
    return names;
}

}  // namespace scenarios::drill
