#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/commands/checks.hpp"
#include "app/fault.hpp"
#include "assets/curve.hpp"
#include "sim/knot/namer.hpp"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::vector<std::string> files;
    bool closed = false, json = false;
};

struct Named {
    assets::Curve curve;
    sim::knot::Name name;
    long microseconds = 0;
};

Named name_one(assets::Curve curve, const Options& options) {
    curve.closed = curve.closed || options.closed;
    const auto start = std::chrono::steady_clock::now();
    sim::knot::Name name = sim::knot::name_knot(curve.vertices, curve.closed);
    const auto spent = std::chrono::steady_clock::now() - start;
    return {std::move(curve), std::move(name), std::chrono::duration_cast<std::chrono::microseconds>(spent).count()};
}

Json json_of(const std::string& file, size_t component, size_t components, const Named& named) {
    const sim::knot::Name& name = named.name;
    Json factors = Json::array();
    for (const auto& f : name.factors)
        factors.push_back({{"name", f.name}, {"mirror", f.mirror}, {"crossings", f.crossings}});
    Json entry = {{"file", file}, {"components", components}, {"open", !named.curve.closed}};
    if (components > 1) entry["component"] = component + 1;
    entry.update({{"knot", name.knot},
                  {"factors", factors},
                  {"surgical", {{"name", name.surgical}, {"throws", name.throws}}},
                  {"crossings", {{"projected", name.crossings_projected}, {"reduced", name.crossings_reduced}}},
                  {"certain", name.certain},
                  {"microseconds", named.microseconds}});
    if (!name.certain) entry["candidates"] = name.candidates;
    return entry;
}

void print(const std::string& file, size_t component, size_t components, const sim::knot::Name& name) {
    std::cout << file;
    if (components > 1) std::cout << " component " << component + 1;
    std::cout << ": " << name.knot;
    if (!name.surgical.empty()) std::cout << ", " << name.surgical;
    if (!name.throws.empty()) std::cout << ", throws " << name.throws;
    if (!name.certain) {
        std::cout << ", not certain (" << name.crossings_reduced << " crossings left)";
        for (size_t i = 0; i < name.candidates.size(); ++i)
            std::cout << (i == 0 ? ", candidates " : " or ") << name.candidates[i];
    }
    std::cout << '\n';
}

int name_files(const Options& options) try {
    Json report = {{"curves", Json::array()}};
    for (const std::string& file : options.files) {
        const std::vector<assets::Curve> curves = assets::load_curves(file);
        for (size_t i = 0; i < curves.size(); ++i) {
            const Named named = name_one(curves[i], options);
            if (options.json)
                report["curves"].push_back(json_of(file, i, curves.size(), named));
            else
                print(file, i, curves.size(), named.name);
        }
    }
    if (options.json) std::cout << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return 0;
} catch (const assets::AssetError& fault) {
    throw InputFault(fault.what());
}

}  // namespace

void add_knot(CLI::App& program) {
    auto* command = program.add_subcommand("knot", "Name the knots in curves");
    auto options = std::make_shared<Options>();
    command->add_option("CURVE", options->files, "Curve files (.csv, .xyz, .txt)")->required();
    command->add_flag("--closed", options->closed, "Join the ends of every curve by a straight line");
    command->add_flag("--json", options->json, "One JSON object on stdout");
    command->callback([options] { chosen_command() = [options] { return name_files(*options); }; });
}

}  // namespace app
