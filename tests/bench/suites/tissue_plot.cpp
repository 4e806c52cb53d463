#include <string>

#include "tests/bench/suites/plot.hpp"
#include "tests/bench/suites/tissue.hpp"

namespace bench::suites {

using namespace lab;

namespace {

constexpr const char* cost = "a simulated second takes [ms]";

// us a step to ms a second.
double in_a_second(double step_us, double step_ms) {
    return step_us / step_ms;
}

Chart by_resolution(const Suite& suite) {
    Chart chart{cost, "error [%]", {}, true};
    const struct {
        const char *name, *before, *after;
    } errors[] = {{"growth under pressure (D17)", "pressure-axial100-n", "-growth"},
                  {"opening of a bite at 0.1 N", "bite-100mN-n", ""},
                  {"edge at 0.1 N", "edge-100mN-n", ""}};
    for (const auto& [name, before, after] : errors) {
        Series series{name, {}};
        for (const std::string around : {"8", "12", "16", "24", "32"})
            series.points.push_back(
                {in_a_second(value_in(suite, "pull-n" + around + "-30mN-step2-moves1-factor8-mean"), 2),
                 value_in(suite, before + around + after), around});
        chart.series.push_back(series);
    }
    return chart;
}

Chart by_solver(const Suite& suite) {
    Chart chart{cost, "edge off at 30 mN, at most [%]", {}, true};
    for (const int ms : {1, 2, 4}) {
        Series series{"steps of " + std::to_string(ms) + " ms, factored in ...", {}};
        for (const std::string steps : {"0", "4", "8", "16"}) {
            const std::string id = "pull-n16-30mN-step" + std::to_string(ms) + "-moves1-factor" + steps;
            series.points.push_back({in_a_second(value_in(suite, id + "-mean"), ms), value_in(suite, id + "-off"),
                                     steps == "0" ? "each" : steps});
        }
        chart.series.push_back(series);
    }
    return chart;
}

}  // namespace

std::string tissue_picture(const Suite& suite) {
    return svg({by_resolution(suite), by_solver(suite)});
}

}  // namespace bench::suites
