#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/commands.hpp"
#include "app/commands/effects.hpp"
#include "app/fault.hpp"
#include "app/play/scene.hpp"
#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/motion.hpp"

namespace app {

namespace {

// What the drill leaves out that its thread needs, each a sentence.
std::vector<std::string> missed(const scenarios::drill::Drill& drill) {
    std::vector<std::string> sentences;
    for (const Effect& effect : effects_of(drill)) {
        if (!effect.is_missed()) continue;
        std::ostringstream text;
        text.precision(3);
        text << "/effects/" << effect.name << ": off, but " << effect.group << " is " << effect.value << ", above "
             << *effect.needed_above << ": " << effect.error;
        if (!drill.motion.empty()) text << "; its motion was tuned without, play it again with it on";
        sentences.push_back(text.str());
    }
    return sentences;
}

// Returns what to warn of.
std::vector<std::string> check(const std::string& file) {
    const scenarios::drill::Drill drill = scenarios::drill::load_drill(file);
    vessel_meshes(drill.world);
    with_walls(drill.world);
    if (drill.motion.empty()) return missed(drill);
    std::vector<std::string> names;
    for (const auto& instrument : drill.world.instruments) names.push_back(instrument.name);
    auto warnings = missed(drill);
    if (const std::string lost = scenarios::drill::load_motion(drill.motion, names).cut_short_at(drill.time_limit_s);
        !lost.empty())
        warnings.push_back(lost);
    return warnings;
}

}  // namespace

// Every file is looked at, so that an author with ten drills mends them in one go.
int validate_command(const ValidateOptions& options) {
    if (options.schema) {
        std::cout << scenarios::drill::published_schema();
        return 0;
    }
    bool valid = true;
    nlohmann::ordered_json report = {{"drills", nlohmann::ordered_json::array()}};
    for (const std::string& file : options.files) {
        std::string error;
        std::vector<std::string> warnings;
        try {
            warnings = check(file);
        } catch (const scenarios::drill::FileError& fault) {
            error = fault.what();
        } catch (const assets::AssetError& fault) {
            error = fault.what();
        } catch (const InputFault& fault) {
            error = fault.what();
        }
        if (!error.empty()) std::cerr << error << '\n';
        valid &= error.empty();
        nlohmann::ordered_json entry = {{"file", file}, {"valid", error.empty()}};
        if (!error.empty()) entry["error"] = error;
        if (!warnings.empty()) entry["warnings"] = warnings;
        for (const std::string& warning : warnings) std::cerr << file << ": warning: " << warning << '\n';
        report["drills"].push_back(entry);
        if (!options.json && error.empty()) std::cout << file << ": valid\n";
    }
    if (options.json) std::cout << report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    return valid ? 0 : 2;
}

}  // namespace app
