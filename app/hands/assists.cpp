#include "app/hands/assists.hpp"

#include <algorithm>
#include <sstream>

#include "app/fault.hpp"

namespace app::hands {

static std::string list(const auto& is_in) {
    std::string names;
    for (const AssistRow& row : assist_rows)
        if (is_in(row.assist)) names += (names.empty() ? "" : ",") + std::string(row.name);
    return names;
}

std::string Assists::names() const {
    return list([&](Assist assist) { return has(assist); });
}

const char* name_of(Assist assist) {
    return assist_rows[static_cast<std::size_t>(assist)].name;
}

Assists parse_assists(const std::string& names) {
    Assists assists;
    std::istringstream words(names);
    for (std::string word; std::getline(words, word, ',');) {
        const auto row = std::find_if(assist_rows.begin(), assist_rows.end(),
                                      [&](const AssistRow& known) { return word == known.name; });
        if (row == assist_rows.end())
            throw InputFault("assist '" + word + "': no such assist, expected some of " +
                             list([](Assist) { return true; }));
        assists.set(row->assist, true);
    }
    return assists;
}

}  // namespace app::hands
