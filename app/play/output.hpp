#pragma once
#include <filesystem>
#include <initializer_list>
#include <vector>

#include "scenarios/session/session.hpp"

namespace app {

using scenarios::session::Session;
using scenarios::session::Snapshot;

/// PNG bytes of the scene at a snapshot: the operative field with all jaws, or the snapshot's knot from near.
std::vector<unsigned char> picture_of(const Session& session, const Snapshot& snapshot);

/// Called before long work. Makes the folder; throws InputFault, which names --out, when what is to be written there
/// cannot be, or is one of the `others` that the command reads or writes.
void expect_output(const std::filesystem::path& dir, std::initializer_list<std::filesystem::path> others);

/// result.json, report.html and, if any, frames as frame-0001.png ... in `dir`, which exists.
/// Throws std::runtime_error when they cannot be written.
void write_output(const std::filesystem::path& dir, const Session& session, const scenarios::drill::Result& result,
                  const std::vector<Snapshot>& frames);

/// The score table for a terminal, in the order of by_importance().
std::string score_table(const scenarios::drill::Result& result);

}  // namespace app
