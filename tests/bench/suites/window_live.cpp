#include <stdio.h>
#include <string.h>

#include <sstream>

#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/suites/speed.hpp"
#include "tests/bench/suites/window.hpp"

namespace bench::suites {

using namespace lab;

namespace {

// As measure.py prints it: id, value, unit, bound, what, with tabs between.
std::optional<Row> row_of(const std::string& line) {
    std::istringstream words(line);
    std::string id, value, unit, bound, what;
    for (std::string* word : {&id, &value, &unit, &bound}) std::getline(words, *word, '\t');
    if (!std::getline(words, what)) return {};
    Row row;
    row.id = id, row.what = what, row.value = std::stod(value), row.unit = unit;
    if (!bound.empty()) row.bound = std::stod(bound);
    if (unit == "ratio" || unit == "1/s") row.must = Must::be_at_least;
    return row;
}

}  // namespace

void add_live(Suite& suite, const std::filesystem::path& drills, bool quick, const Progress& progress) {
    const auto script = drills.parent_path().parent_path() / "tests/app/window/measure.py";
    const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "carrel";
    if (!std::filesystem::exists(script) || !std::filesystem::exists(program)) {
        progress("the window itself is left out: it takes " + script.string() + " and " + program.string());
        return;
    }
    const std::string command = "xvfb-run -a -s '-screen 0 1280x720x24' python3 '" + script.string() + "' '" +
                                program.string() + "' '" + drills.string() + (quick ? "' --quick" : "'");
    FILE* const said = popen(command.c_str(), "r");
    if (!said) throw std::runtime_error("cannot run " + command);
    Stopwatch watch;
    char line[512];
    while (fgets(line, sizeof line, said)) {
        if (auto row = row_of(line)) {
            row->seconds = watch.seconds();
            progress(std::string(line, strcspn(line, "\n")));
            suite.rows.push_back(*row);
        }
    }
    if (pclose(said) != 0) throw std::runtime_error("it failed: " + command);
}

}  // namespace bench::suites
