#include "app/play/recorded.hpp"

#include "app/build_info.hpp"
#include "app/fault.hpp"
#include "app/machine.hpp"
#include "instruments/tool_world.hpp"

namespace app {

using scenarios::drill::Drill;
using scenarios::recording::Asset;
using scenarios::recording::Recording;

std::vector<Asset> assets_of(const scenarios::world::WorldDef& world) {
    constexpr std::size_t most_bytes = 256 << 20;  // as in a drill
    std::vector<Asset> assets;
    for (const auto& vessel : world.vessels)
        if (!vessel.mesh_file.empty())
            assets.push_back({vessel.mesh_file,
                              scenarios::drill::sha256(scenarios::drill::read_text(vessel.mesh_file, most_bytes))});
    return assets;
}

scenarios::recording::Head head_of(const Drill& drill, const std::string& name,
                                   scenarios::recording::Circumstances session) {
    session.machine = machine_name();
    const std::string libraries = library_versions() + ", " + scenarios::recording::library_versions();
    return {.drill_text = drill.text,
            .drill_name = name,
            .program_version = build_name(),
            .tick_s = drill.world.tick_s,
            .instruments = scenarios::drill::instrument_names(drill),
            .assets = assets_of(drill.world),
            .engine = {commit, compiler_name(), compiler_flags(), libraries},
            .session = std::move(session)};
}

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
    throw InputFault(file + ": error: " + what);
}

Drill drill_of(const Recording& recording, const std::string& file) try {
    const auto& name = recording.head.drill_name;
    return scenarios::drill::parse_drill(recording.head.drill_text, name, std::filesystem::path(name).parent_path());
} catch (const scenarios::drill::FileError& fault) {
    refuse(file, "the drill in it is damaged: " + std::string(fault.what()));
}

void check_inputs_fit(const Recording& recording, const Drill& drill, const std::string& file) {
    if (scenarios::drill::instrument_names(drill) != recording.head.instruments)
        refuse(file, "its inputs are of other instruments than those of the drill in it");
    if (recording.head.tick_s != drill.world.tick_s)
        refuse(file, "its ticks are not as long as those of the drill in it");
}

// A later one that is damaged is dropped, and the tool stays; there is no place for it to stay at before the first.
void check_first_inputs(const Recording& recording, const Drill& drill, const std::string& file) {
    const auto inputs = recording.tick(0);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto& instrument = drill.world.instruments[i];
        if (!instruments::usable(inputs[i], instruments::shape_of(instrument.kind)))
            refuse(file,
                   "the first input of \"" + instrument.name + "\" is damaged, expected a pose and a jaw in numbers");
    }
}

// A drill's path is as it was typed then; a recording that was taken elsewhere may have its meshes beside it.
void find_meshes(Drill& drill, const std::string& file) {
    for (auto& vessel : drill.world.vessels) {
        if (vessel.mesh_file.empty() || std::filesystem::exists(vessel.mesh_file)) continue;
        const auto beside =
            std::filesystem::path(file).parent_path() / std::filesystem::path(vessel.mesh_file).filename();
        if (!std::filesystem::exists(beside))
            refuse(file, "its mesh " + vessel.mesh_file + " is not there, expected it there or at " + beside.string());
        vessel.mesh_file = beside.string();
    }
}

void check_meshes(const Recording& recording, const Drill& drill, const std::string& file) {
    const std::vector<Asset> now = assets_of(drill.world);
    const std::vector<Asset>& then = recording.head.assets;
    if (then.size() > now.size()) refuse(file, "notes more meshes than the drill in it names");
    for (std::size_t i = 0; i < now.size(); ++i)
        if (i >= then.size() || then[i].sha256 != now[i].sha256)
            refuse(file,
                   "was recorded with another mesh than " + now[i].name + " now is, its SHA-256 is " + now[i].sha256);
}

}  // namespace

Recorded load_recorded(const std::string& file) {
    Recording recording = scenarios::recording::load_recording(file);
    if (recording.ticks() == 0)
        throw InputFault(recording.fault(file).value_or(file + ": error: no tick was recorded"));
    Drill drill = drill_of(recording, file);
    check_inputs_fit(recording, drill, file);
    check_first_inputs(recording, drill, file);
    find_meshes(drill, file);
    check_meshes(recording, drill, file);
    return {std::move(recording), std::move(drill)};
}

}  // namespace app
