#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/fault.hpp"
#include "app/play/scene.hpp"
#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/motion.hpp"

namespace app {

namespace {

void check(const std::string& file) {
    const scenarios::drill::Drill drill = scenarios::drill::load_drill(file);
    vessel_meshes(drill.world);
    if (drill.motion.empty()) return;
    std::vector<std::string> names;
    for (const auto& instrument : drill.world.instruments) names.push_back(instrument.name);
    scenarios::drill::load_motion(drill.motion, names);
}

}  // namespace

// Every file is looked at, so that an author with ten drills mends them in one go.
int validate_command(const ValidateOptions& options) {
    if (options.schema) {
        std::cout << scenarios::drill::drill_schema();
        return 0;
    }
    bool valid = true;
    nlohmann::ordered_json report = {{"drills", nlohmann::ordered_json::array()}};
    for (const std::string& file : options.files) {
        std::string error;
        try {
            check(file);
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
        report["drills"].push_back(entry);
        if (!options.json && error.empty()) std::cout << file << ": valid\n";
    }
    if (options.json) std::cout << report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    return valid ? 0 : 2;
}

}  // namespace app
