#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/build_info.hpp"
#include "app/commands/commands.hpp"
#include "app/fault.hpp"
#include "app/one_line.hpp"
#include "scenarios/drill/waypoints.hpp"

// The only file that knows the library for command lines: Debian's is all header and takes longer to compile than any
// command.
namespace app {

namespace {

using Chosen = std::function<int()>;

// CLI11 says of a command that it does not know only that one is required, and asked for its help prints that of all.
void expect_command(const CLI::App& program, const std::string& asked) {
    if (asked.starts_with("-")) return;
    std::string known;
    for (const CLI::App* command : program.get_subcommands({})) {
        if (command->get_name() == asked) return;
        known += (known.empty() ? "" : ", ") + command->get_name();
    }
    throw InputFault("carrel: error: '" + asked + "' is no command, known are " + known + "; see carrel --help");
}

std::string usage_fault(const CLI::App* program, const CLI::Error& error) {
    std::string command = "carrel";
    for (const CLI::App* chosen : program->get_subcommands()) command += " " + chosen->get_name();
    return one_line(command + ": error: " + error.what() + "; see " + command + " --help");
}

// A script's variable that is not set: nothing would be written, without a word.
std::string not_empty(const std::string& name) {
    return name.empty() ? "is empty, expected a name" : "";
}

void add_run(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand("run", "Play a drill without a window, as fast as it can");
    auto options = std::make_shared<RunOptions>();
    command->add_option("DRILL", options->drill, "Drill file (.json)")->required();
    command->add_option("--input", options->input, "Motion to play instead of the drill's own (.csv)")
        ->check(not_empty);
    command->add_option("--record", options->record, "Record the session to this file")->check(not_empty);
    auto* out =
        command->add_option("--out", options->out, "Folder for result.json, report.html and frames")->check(not_empty);
    command->add_option("--thread", options->thread, "How the thread moves: ftl (by geometry) or elastic (by forces)");
    command->add_option("--frames", options->frames, "Evenly spaced pictures to write to --out")
        ->check(CLI::Range(0, 10000))
        ->needs(out);
    command->add_flag("--json", options->json, "Print result.json on stdout");
    command->callback([=, &chosen] { chosen = [options] { return run_command(*options); }; });
}

void add_play(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand("play", "Open the window: play a drill, or choose one in the menu");
    auto options = std::make_shared<PlayOptions>();
    auto* drill = command->add_option("DRILL", options->drill, "Drill file (.json); none: the menu");
    command->add_option("--record", options->record, "Record the attempt to this file")->check(not_empty)->needs(drill);
    command->add_flag("--exam", options->exam, "One attempt without help, pause or slow motion");
    command->add_option("--assist", options->assist, "Assists to begin with, names with \",\" between")
        ->check(not_empty);
    command->add_option("--pace", options->pace, "Simulated seconds a second, at most those of the drill")
        ->check(CLI::Range(0.125, 1.0));
    command->add_option("--recordings", options->recordings, "Folder of all recordings, one folder a person")
        ->check(not_empty);
    command->add_option("--drills", options->drills, "Folder of the drills that the menu shows")->check(not_empty);
    command
        ->add_option("--ui-dump", options->ui_dump, "Write labels and places of all controls to this file, for tests")
        ->check(not_empty);
    command->add_option("--scene-dump", options->scene_dump, "Write what is seen in each frame to this file, for tests")
        ->check(not_empty);
    command->callback([=, &chosen] { chosen = [options] { return play_command(*options); }; });
}

void add_replay(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand("replay", "Re-simulate a recording");
    auto options = std::make_shared<ReplayOptions>();
    command->add_option("RECORDING", options->recording, "Recording of a session")->required();
    command->add_flag("--verify", options->verify, "Compare every stored state hash; exit 3 if one differs");
    command->add_option("--out", options->out, "Folder for result.json and report.html")->check(not_empty);
    command->add_flag("--json", options->json, "Print result.json on stdout");
    command->callback([=, &chosen] { chosen = [options] { return replay_command(*options); }; });
}

void add_render(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand("render", "One picture of a drill or a recording, no display needed");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("SOURCE", options->source, "Recording, or drill file (.json)")->required();
    command->add_option("--at", options->at_s, "Seconds of simulated time; default: a drill's start, a recording's end")
        ->check(CLI::Number);
    command->add_option("--out", options->out, "Picture to write (.png)")->required();
    command->add_flag("--close", options->close, "Closer, on the knot; where there is none, on the bites");
    command->callback([=, &chosen] { chosen = [options] { return render_command(*options); }; });
}

void add_motion(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand("motion", "Turn waypoints, as a person writes them, into a motion file");
    command->footer(std::string("\nSteps. ") + scenarios::drill::waypoint_steps);
    auto options = std::make_shared<MotionOptions>();
    command->add_option("WAYPOINTS", options->waypoints, "Steps of the tools (.waypoints)")->required();
    command->add_option("--out", options->out, "Motion file to write (.csv)")->required();
    command->callback([=, &chosen] { chosen = [options] { return motion_command(*options); }; });
}

void add_knot(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand(
        "knot",
        "Name the knots in curve files: one vertex 'x y z' a line, an empty line between "
        "components, which are closed when their last vertex repeats the first; the first one is "
        "the thread, others are what it is tied round");
    auto options = std::make_shared<KnotOptions>();
    command->add_option("curves", options->curves, "Curve files; - for standard input")
        ->option_text("CURVE...")
        ->required();
    command->add_flag("--closed", options->closed, "Join the last vertex of every component to its first");
    command->add_option("--around", options->around, "A curve the others are tied round; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_flag("--json", options->json, "One JSON object on stdout");
    command->callback([=, &chosen] { chosen = [options] { return knot_command(*options); }; });
}

void add_validate(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand(
        "validate", "Check drill files, and the motions and meshes they name, without running them");
    auto options = std::make_shared<ValidateOptions>();
    auto* files = command->add_option("DRILL", options->files, "Drill files (.json)");
    auto* schema = command->add_flag("--schema", options->schema, "Print the JSON Schema of drill files instead");
    command->add_flag("--json", options->json, "One JSON object on stdout");
    command->callback([=, &chosen] {
        if (files->empty() && schema->empty()) throw CLI::RequiredError("DRILL");
        chosen = [options] { return validate_command(*options); };
    });
}

void add_explain(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand(
        "explain", "Effects on and off, the error of leaving each out and its cost; defaults filled in");
    auto options = std::make_shared<ExplainOptions>();
    command->add_option("DRILL", options->file, "Drill file (.json)")->required();
    command->add_flag("--json", options->json, "One JSON object on stdout");
    command->callback([=, &chosen] { chosen = [options] { return explain_command(*options); }; });
}

void add_rope(CLI::App& program, Chosen& chosen) {
    auto* command = program.add_subcommand("rope", "Thread laboratory: one bare thread, moved by its nodes");
    auto o = std::make_shared<RopeOptions>();
    command->add_option("CURVE", o->curve, "The thread as it starts: one open curve, x y z in mm a line")->required();
    command->add_option("--motion", o->motion, "Held nodes: t_s,node,x_mm,y_mm,z_mm; node is first, last or an index")
        ->required();
    command->add_option("--radius", o->radius_mm, "Of the thread [mm]")->capture_default_str();
    command->add_option("--links", o->links, "Resample the curve to this many equal links (default: as given)");
    command->add_option("--thread", o->thread, "How the thread is simulated")->capture_default_str();
    command->add_option("--friction", o->friction, "Coulomb coefficient")->capture_default_str();
    command->add_option("--tick", o->tick_s, "[s]")->capture_default_str();
    command->add_option("--young", o->young_MPa, "Young's modulus [MPa]; here it scales the tension")
        ->capture_default_str();
    command->add_option("--density", o->density_kg_m3, "[kg/m^3]; of no effect on a thread without inertia")
        ->capture_default_str();
    command->add_flag("--gravity", o->gravity, "Let the thread weigh; elastic only");
    command->add_option("--obstacle", o->obstacle, "Mesh that stands still (.obj, .ply, .stl in mm)");
    command->add_option("--every", o->every, "Write positions to --out every N ticks")->capture_default_str();
    command->add_option("--out", o->out, "Positions, one JSON line each: t [s], x [mm], tension_N");
    command->add_flag("--json", o->json, "One JSON object on stdout");
    command->callback([=, &chosen] { chosen = [o] { return rope_command(*o); }; });
}

// Listed only: what follows it is handed on.
void add_bench(CLI::App& program, Chosen&) {
    program.add_subcommand("bench",
                           "Measure the tables of docs/ again, on this machine; exit 3 when a bound is missed");
}

}  // namespace

std::function<int()> asked_for(int argc, char** argv) {
    CLI::App program{"Carrel: a surgical suturing trainer. A thread that can be tied, pulled tight and named."};
    program.set_version_flag("--version", build_name(), "Print version, commit and compiler");
    program.failure_message(usage_fault);
    Chosen chosen;
    for (const auto add : {add_play, add_run, add_replay, add_render, add_motion, add_knot, add_validate, add_explain,
                           add_rope, add_bench})
        add(program, chosen);
    if (argc < 2) return [] { return play_command({}); };
    program.require_subcommand(1);
    expect_command(program, argv[1]);
    if (std::string(argv[1]) == "bench")
        return [arguments = std::vector<std::string>(argv + 2, argv + argc)] { return bench_command(arguments); };
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return [exit = program.exit(error) == 0 ? 0 : 2] { return exit; };
    }
    return chosen;
}

}  // namespace app
