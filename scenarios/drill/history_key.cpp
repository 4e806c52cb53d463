#include "scenarios/drill/history_key.hpp"

#include <nlohmann/json.hpp>

namespace scenarios::drill {

std::string history_key(const Drill& drill) {
    auto judged = nlohmann::json::parse(drill.filled);
    for (const char* words : {"$schema", "title", "description", "steps", "motion"}) judged.erase(words);
    for (auto& vessel : judged["vessels"])
        if (vessel.contains("mesh")) vessel["mesh"].erase("file");  // its own hash stays
    return sha256(judged.dump());
}

}  // namespace scenarios::drill
