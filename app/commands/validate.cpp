#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/tool_starts.hpp"
#include "app/commands/warnings.hpp"
#include "app/fault.hpp"
#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/motion.hpp"
#include "scenarios/session/scene.hpp"

namespace app {

namespace {

// Returns what to warn of.
std::vector<std::string> check(const std::string& file) {
    const scenarios::drill::Drill drill = scenarios::drill::load_drill(file);
    const auto rigid = scenarios::session::vessel_meshes(drill.world);
    scenarios::session::with_walls(drill.world);
    std::vector<std::string> sentences = missed_effects(drill);
    const auto add = [&](const std::vector<std::string>& more) {
        sentences.insert(sentences.end(), more.begin(), more.end());
    };
    if (drill.motion.empty()) {
        add(warnings_of(drill, nullptr));
        return sentences;
    }
    const auto motion = scenarios::drill::load_motion(drill.motion, scenarios::drill::instrument_names(drill));
    std::vector<instruments::ToolInput> start(drill.world.instruments.size());
    motion.at(0, start);
    check_tool_starts(drill, rigid, start, drill.motion.string());
    add(warnings_of(drill, &motion));
    return sentences;
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
