#pragma once
namespace CLI {
class App;
}

namespace app {

/// `carrel run DRILL`: plays a drill's motion without a window, as fast as it can; result, report, recording, frames.
void add_run(CLI::App& program);

/// `carrel replay RECORDING [--verify]`: re-simulates a recording.
void add_replay(CLI::App& program);

/// `carrel render RECORDING|DRILL --at S --out PNG`: one picture.
void add_render(CLI::App& program);

/// `carrel motion WAYPOINTS --out CSV`: readable steps into a motion file.
void add_motion(CLI::App& program);

}  // namespace app
