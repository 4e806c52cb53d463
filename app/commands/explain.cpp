#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/effects.hpp"
#include "app/fault.hpp"
#include "scenarios/drill/keys.hpp"

namespace app {

namespace {

std::string shown(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

void print_json(const scenarios::drill::Drill& drill) {
    nlohmann::ordered_json effects;
    for (const auto& effect : effects_of(drill)) {
        effects.push_back({{"name", effect.name},
                           {"on", effect.on},
                           {"group", effect.group},
                           {"value", effect.value},
                           {"error", effect.error},
                           {"cost", effect.cost}});
        if (!effect.predicted_of.empty())
            effects.back().update({{"predicted_of", effect.predicted_of}, {"predicted", effect.predicted}});
    }
    const nlohmann::ordered_json report = {{"effects", effects},
                                           {"drill", nlohmann::ordered_json::parse(drill.filled)}};
    std::cout << report.dump(2) << '\n';
}

// A band has no default: without it nothing is judged.
std::string bands_left_out(const scenarios::drill::Drill& drill) {
    const auto given = nlohmann::json::parse(drill.filled)["bands"];
    std::string free;
    for (const auto& key : scenarios::drill::drill_schema().keys)
        if (key.name == "bands")
            for (const auto& band : key.schema.keys)
                if (!given.contains(band.name) || given[band.name].empty())
                    free += (free.empty() ? "" : ", ") + band.name;
    return free;
}

void print_steps(const scenarios::drill::Drill& drill) {
    if (drill.steps.empty()) return;
    std::cout << "\nGuidance, and when each step is done:\n";
    const auto filled = nlohmann::json::parse(drill.filled);
    int number = 0;
    for (const auto& step : filled["steps"])
        std::cout << "  " << ++number << ". " << step["text"].get<std::string>() << "\n     " << step["done"].dump()
                  << '\n';
}

void print(const scenarios::drill::Drill& drill) {
    std::cout << drill.title << "\n\n";
    for (const auto& effect : effects_of(drill)) {
        std::cout << effect.name << ": " << (effect.on ? "on" : "off") << "\n    " << effect.group << " = "
                  << shown(effect.value) << "\n    " << effect.error << "\n    ";
        if (!effect.predicted_of.empty())
            std::cout << effect.predicted_of << ": " << shown(effect.predicted) << "\n    ";
        std::cout << effect.cost << '\n';
    }
    print_steps(drill);
    std::cout << "\nThe drill with every default filled in:\n" << drill.filled << '\n';
    if (const std::string free = bands_left_out(drill); !free.empty())
        std::cout << "\nBands that it does not have, so that these are shown and not judged: " << free << ".\n";
}

}  // namespace

int explain_command(const ExplainOptions& options) try {
    const scenarios::drill::Drill drill = scenarios::drill::load_drill(options.file);
    options.json ? print_json(drill) : print(drill);
    return 0;
} catch (const scenarios::drill::FileError& fault) {
    throw InputFault(fault.what());
}

}  // namespace app
