#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// What each command may be told, and the command itself: returns the program's exit code, throws what main.cpp turns
// into one. How it is written on a command line is in app/command_line.cpp.
namespace app {

/// Plays a drill's motion without a window, as fast as it can; result, report, recording, frames.
struct RunOptions {
    std::string drill, input, record, out, thread;
    int frames = 0;
    bool json = false;
};
int run_command(const RunOptions& options);

/// Opens the window: on a drill, or on the menu where none is named.
struct PlayOptions {
    std::string drill;               // to play at once
    std::string record, recordings;  // the file of this one recording; the folder of all, in one folder a person
    std::string drills, assist;      // the folder of shipped drills; names of assists with "," between
    std::string ui_dump;             // labels and rectangles of all controls go here
    std::string scene_dump;          // what is seen in each frame goes here
    std::optional<double> pace;      // simulated seconds a second, at most
    bool exam = false;
};
int play_command(const PlayOptions& options);

/// Re-simulates a recording.
struct ReplayOptions {
    std::string recording, out;
    bool verify = false, json = false;
};
int replay_command(const ReplayOptions& options);

/// One picture of a recording or a drill.
struct RenderOptions {
    std::string source, out;
    std::optional<double> at_s;
    bool close = false;
};
int render_command(const RenderOptions& options);

/// Readable steps into a motion file.
struct MotionOptions {
    std::string waypoints, out;
};
int motion_command(const MotionOptions& options);

/// Names the knots in curve files.
struct KnotOptions {
    std::vector<std::string> curves, around;
    bool closed = false, json = false;
};
int knot_command(const KnotOptions& options);

/// Checks drill files, and the motions they name, without running them.
struct ValidateOptions {
    std::vector<std::string> files;
    bool json = false, schema = false;
};
int validate_command(const ValidateOptions& options);

/// Effects on and off, their error and cost; defaults filled in.
struct ExplainOptions {
    std::string file;
    bool json = false;
};
int explain_command(const ExplainOptions& options);

/// Moves one bare thread by its nodes and measures what it does.
struct RopeOptions {
    std::string curve, motion, out, obstacle, thread = "ftl";
    double radius_mm = 0.05, friction = 0.15, tick_s = 0.001, young_MPa = 2800, density_kg_m3 = 905;
    std::optional<std::int64_t> links;
    std::int64_t every = 1;
    bool gravity = false, json = false;
};
int rope_command(const RopeOptions& options);

/// Becomes the program carrel-bench, beside this one or on the path; the arguments are its own. Throws
/// std::runtime_error where it is neither.
int bench_command(const std::vector<std::string>& arguments);

}  // namespace app
