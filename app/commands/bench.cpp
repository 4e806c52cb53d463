#include <iostream>

#include "app/bench/accuracy.hpp"
#include "app/bench/drills.hpp"
#include "app/bench/naming.hpp"
#include "app/bench/print.hpp"
#include "app/bench/speed.hpp"
#include "app/bench/speed_vs_error.hpp"
#include "app/bench/stability.hpp"
#include "app/bench/ties.hpp"
#include "app/bench/tissue.hpp"
#include "app/bench/tissue_thread.hpp"
#include "app/commands/commands.hpp"
#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/machine.hpp"

namespace app {

namespace {

struct Known {
    const char* name;
    bench::Suite (*measure)(bool quick, const bench::Progress& progress);
};

bench::Suite stability(bool quick, const bench::Progress& progress) {
    return bench::stability_suite(CARREL_HARD_CASES, quick, progress);
}

bench::Suite naming(bool quick, const bench::Progress& progress) {
    return bench::naming_suite(CARREL_CURVES, quick, progress);
}

bench::Suite speed_vs_error(bool quick, const bench::Progress& progress) {
    bench::Suite suite = bench::speed_vs_error_suite(quick, progress);
    bench::add_drills(suite, quick, progress);
    return suite;
}

bench::Suite tissue(bool quick, const bench::Progress& progress) {
    bench::Suite suite = bench::tissue_suite(quick, progress);
    bench::add_thread_in_tissue(suite, quick, progress);
    return suite;
}

constexpr Known suites[] = {
    {"speed", bench::speed_suite},
    {"speed-vs-error", speed_vs_error},
    {"accuracy", bench::accuracy_suite},
    {"tissue", tissue},
    {"stability", stability},
    {"ties", bench::ties_suite},
    {"elastic-ties", bench::elastic_ties_suite},
    {"knots", naming},
};

const Known& suite_of(const BenchOptions& options) {
    std::string names;
    for (const Known& known : suites) {
        if (options.suite == known.name) return known;
        names += (names.empty() ? "" : " or ") + std::string(known.name);
    }
    throw InputFault("carrel bench: error: SUITE: expected " + names + ", found " + options.suite);
}

void check_plot(const BenchOptions& options) {
    if (options.plot.empty()) return;
    if (options.suite == "speed-vs-error") return make_folder("--plot", options.plot);
    if (options.suite != "speed" && options.suite != "tissue")
        throw InputFault(options.plot + ": error: --plot: only the suites speed, speed-vs-error and tissue draw any");
    expect_ending("--plot", options.plot, ".svg");
    expect_writable("--plot", options.plot);
}

void draw(const bench::Suite& suite, const std::string& to) {
    if (suite.name == "speed") return write_file(to, bench::trade_off_picture(suite));
    if (suite.name == "tissue") return write_file(to, bench::tissue_picture(suite));
    for (const auto& [name, picture] : bench::speed_vs_error_pictures(suite))
        write_file(std::filesystem::path(to) / (name + ".svg"), picture);
}

}  // namespace

int bench_command(const BenchOptions& options) {
    const Known& known = suite_of(options);
    check_plot(options);
    const bench::Suite suite = known.measure(options.quick, [](const std::string& what) { std::cerr << what << '\n'; });
    (options.json ? bench::print_json : bench::print_table)(std::cout, suite, {machine_name(), bench::build_name()});
    if (!options.plot.empty()) draw(suite, options.plot);
    const std::string missed = bench::missed(suite);
    if (!missed.empty()) throw CheckFailed("bench " + suite.name + ": these figures miss their bounds: " + missed);
    return 0;
}

}  // namespace app
