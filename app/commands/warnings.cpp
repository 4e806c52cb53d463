#include "app/commands/warnings.hpp"

#include <sstream>

#include "app/commands/effects.hpp"
#include "assets/mesh.hpp"

namespace app {

std::vector<std::string> warnings_of(const scenarios::drill::Drill& drill, const scenarios::drill::Motion* motion) {
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < drill.world.vessels.size(); ++i) {
        const std::filesystem::path mesh = drill.world.vessels[i].mesh_file;
        if (mesh.empty()) continue;
        for (const std::string& mended : assets::load_mesh(mesh).mended)
            sentences.push_back("/vessels/" + std::to_string(i) + "/mesh: " + mesh.filename().string() + " " + mended);
    }
    if (!motion) return sentences;
    if (const std::string lost = motion->cut_short_at(drill.time_limit_s); !lost.empty()) sentences.push_back(lost);
    for (const std::string& gap : motion->gaps(scenarios::drill::instrument_names(drill)))
        sentences.push_back("/motion: " + gap);
    return sentences;
}

std::vector<std::string> missed_effects(const scenarios::drill::Drill& drill) {
    std::vector<std::string> sentences;
    for (const Effect& effect : effects_of(drill)) {
        if (!effect.is_missed()) continue;
        std::ostringstream text;
        text.precision(3);
        text << "/effects/" << effect.name << ": off, but " << effect.group << " is " << effect.value << ", above "
             << *effect.needed_above << ": " << effect.error << "; expected " << effect.remedy;
        if (!drill.motion.empty()) text << "; its motion was tuned without, play it again with it on";
        sentences.push_back(text.str());
    }
    return sentences;
}

}  // namespace app
