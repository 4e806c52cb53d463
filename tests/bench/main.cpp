#include <CLI/CLI.hpp>
#include <iostream>

#include "app/build_info.hpp"
#include "app/exit_code.hpp"
#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/machine.hpp"
#include "app/one_line.hpp"
#include "tests/bench/suites/accuracy.hpp"
#include "tests/bench/suites/drills.hpp"
#include "tests/bench/suites/naming.hpp"
#include "tests/bench/suites/print.hpp"
#include "tests/bench/suites/speed.hpp"
#include "tests/bench/suites/speed_vs_error.hpp"
#include "tests/bench/suites/stability.hpp"
#include "tests/bench/suites/ties.hpp"
#include "tests/bench/suites/tissue.hpp"
#include "tests/bench/suites/tissue_thread.hpp"
#include "tests/bench/suites/window.hpp"

// The program carrel-bench, to which `carrel bench` hands on.
namespace {

using namespace bench::suites;
using bench::lab::Progress;
using bench::lab::Suite;
namespace fs = std::filesystem;

struct Options {
    std::string suite, plot, data;
    bool json = false, quick = false;
};

/// What the suites read: hard cases, labelled curves and drills, where they are in the source tree.
struct Data {
    fs::path root;

    fs::path hard_cases() const { return root / "tests/hard_cases"; }
    fs::path curves() const { return root / "tests/data/curves"; }
    fs::path drills() const { return root / "scenarios/drills"; }
    bool there() const { return fs::is_directory(hard_cases()) && fs::is_directory(drills()); }
};

// The folder that was named; else the first above the program that has the data, as a build folder's source tree does.
Data find_data(const std::string& named) {
    if (!named.empty()) {
        if (!Data{named}.there())
            throw app::InputFault(named +
                                  ": error: --data: expected a folder with tests/hard_cases and scenarios/drills");
        return {named};
    }
    const fs::path program = fs::read_symlink("/proc/self/exe");
    for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
        if (Data{folder}.there()) return {folder};
    throw app::InputFault("carrel bench: error: no hard cases and drills above " + program.string() +
                          ", expected --data with the folder of Carrel's sources");
}

struct Known {
    const char* name;
    Suite (*measure)(const Options& options, const Progress& progress);
};

Suite speed_vs_error(const Options& options, const Progress& progress) {
    const Data data = find_data(options.data);
    Suite suite = speed_vs_error_suite(options.quick, progress);
    add_drills(suite, data.drills(), options.quick, progress);
    return suite;
}

Suite tissue(const Options& options, const Progress& progress) {
    Suite suite = tissue_suite(options.quick, progress);
    add_thread_in_tissue(suite, options.quick, progress);
    return suite;
}

Suite stability(const Options& options, const Progress& progress) {
    return stability_suite(find_data(options.data).hard_cases(), options.quick, progress);
}

Suite naming(const Options& options, const Progress& progress) {
    return naming_suite(find_data(options.data).curves(), options.quick, progress);
}

Suite window(const Options& options, const Progress& progress) {
    return window_suite(find_data(options.data).drills(), options.quick, progress);
}

template <Suite (*suite)(bool quick, const Progress& progress)>
Suite alone(const Options& options, const Progress& progress) {
    return suite(options.quick, progress);
}

constexpr Known suites[] = {
    {"speed", alone<speed_suite>},
    {"speed-vs-error", speed_vs_error},
    {"accuracy", alone<accuracy_suite>},
    {"tissue", tissue},
    {"stability", stability},
    {"ties", alone<ties_suite>},
    {"elastic-ties", alone<elastic_ties_suite>},
    {"knots", naming},
    {"window", window},
};

const Known& suite_of(const Options& options) {
    std::string names;
    for (const Known& known : suites) {
        if (options.suite == known.name) return known;
        names += (names.empty() ? "" : " or ") + std::string(known.name);
    }
    throw app::InputFault("carrel bench: error: SUITE: expected " + names + ", found " + options.suite);
}

void check_plot(const Options& options) {
    if (options.plot.empty()) return;
    if (options.suite == "speed-vs-error") return app::make_folder("--plot", options.plot);
    if (options.suite != "speed" && options.suite != "tissue")
        throw app::InputFault(options.plot +
                              ": error: --plot: only the suites speed, speed-vs-error and tissue draw any");
    app::expect_ending("--plot", options.plot, ".svg");
    app::expect_writable("--plot", options.plot);
}

void draw(const Suite& suite, const std::string& to) {
    if (suite.name == "speed") return app::write_file(to, trade_off_picture(suite));
    if (suite.name == "tissue") return app::write_file(to, tissue_picture(suite));
    for (const auto& [name, picture] : speed_vs_error_pictures(suite))
        app::write_file(fs::path(to) / (name + ".svg"), picture);
}

int measure(const Options& options) {
    const Known& known = suite_of(options);
    check_plot(options);
    const Suite suite = known.measure(options, [](const std::string& what) { std::cerr << what << '\n'; });
    (options.json ? print_json : print_table)(std::cout, suite, {app::machine_name(), app::build_name()});
    if (!options.plot.empty()) draw(suite, options.plot);
    const std::string all_missed = missed(suite);
    if (!all_missed.empty())
        throw app::CheckFailed("bench " + suite.name + ": these figures miss their bounds: " + all_missed);
    return 0;
}

int run(int argc, char** argv) {
    CLI::App program{"Measure the tables of docs/ again, on this machine; exit 3 when a bound is missed",
                     "carrel bench"};
    Options options;
    program
        .add_option("SUITE", options.suite,
                    "What to measure: speed, speed-vs-error, accuracy, tissue, stability, ties, elastic-ties, knots or "
                    "window")
        ->required();
    program.add_flag("--quick", options.quick, "Once and without the longest: seconds, of tissue a minute or two");
    program.add_option("--plot", options.plot,
                       "Pictures of speed against error to write: a file (.svg), or of speed-vs-error a folder");
    program.add_option("--data", options.data, "Folder of Carrel's sources, for hard cases, curves and drills");
    program.add_flag("--json", options.json, "One JSON object on stdout");
    program.failure_message([](const CLI::App*, const CLI::Error& error) {
        return app::one_line(std::string("carrel bench: error: ") + error.what() + "; see carrel bench --help");
    });
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    }
    return measure(options);
}

}  // namespace

int main(int argc, char** argv) {
    return app::exit_code_of("carrel bench", [=] { return run(argc, argv); });
}
