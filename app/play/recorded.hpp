#pragma once
#include <string>

#include "scenarios/drill/drill.hpp"
#include "scenarios/recording/recording.hpp"

namespace app {

/// The mesh files of a scene and what is in them: what a recording notes beside the drill.
/// Throws scenarios::drill::FileError when one cannot be read.
std::vector<scenarios::recording::Asset> assets_of(const scenarios::world::WorldDef& world);

/// What a session of this drill is recorded with: the drill, which messages call `name`, the meshes that it names, this
/// program and, but for the machine, which is filled in here, who plays it and how. Throws as assets_of().
scenarios::recording::Head head_of(const scenarios::drill::Drill& drill, const std::string& name,
                                   scenarios::recording::Circumstances session);

/// A recording of at least one tick and the drill in it, fit to be simulated again.
struct Recorded {
    scenarios::recording::Recording recording;
    scenarios::drill::Drill drill;
};

/// Throws InputFault or RecordingError, one line that names `file`: no tick in it, a drill that cannot be read or is
/// not the one its inputs were made for, or a mesh that has changed since.
Recorded load_recorded(const std::string& file);

}  // namespace app
