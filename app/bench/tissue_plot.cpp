#include <algorithm>
#include <cmath>
#include <string>

#include "app/bench/plot.hpp"
#include "app/bench/tissue.hpp"

namespace app::bench {

namespace {

// What a row says; not a number where there is none, which is not drawn.
class Values {
  public:
    explicit Values(const Suite& suite) : suite_(suite) {}
    double operator()(const std::string& id) const {
        const auto row = std::find_if(suite_.rows.begin(), suite_.rows.end(), [&](const Row& of) { return of.id == id; });
        return row == suite_.rows.end() ? NAN : row->value;
    }

  private:
    const Suite& suite_;
};

constexpr const char* cost = "a simulated second takes [ms]";

// us a step to ms a second.
double in_a_second(double step_us, double step_ms) { return step_us / step_ms; }

Chart by_resolution(const Values& value) {
    Chart chart{cost, "error [%]", {}, true};
    const struct {
        const char *name, *before, *after;
    } errors[] = {{"growth under pressure (D17)", "pressure-axial100-n", "-growth"}, {"opening of a bite at 0.1 N", "bite-100mN-n", ""}, {"edge at 0.1 N", "edge-100mN-n", ""}};
    for (const auto& [name, before, after] : errors) {
        Series series{name, {}};
        for (const std::string around : {"8", "12", "16", "24", "32"})
            series.points.push_back({in_a_second(value("pull-n" + around + "-30mN-step2-moves1-factor8-mean"), 2), value(before + around + after), around});
        chart.series.push_back(series);
    }
    return chart;
}

Chart by_solver(const Values& value) {
    Chart chart{cost, "edge off at 30 mN, at most [%]", {}, true};
    for (const int ms : {1, 2, 4}) {
        Series series{"steps of " + std::to_string(ms) + " ms, factored in ...", {}};
        for (const std::string steps : {"0", "4", "8", "16"}) {
            const std::string id = "pull-n16-30mN-step" + std::to_string(ms) + "-moves1-factor" + steps;
            series.points.push_back({in_a_second(value(id + "-mean"), ms), value(id + "-off"), steps == "0" ? "each" : steps});
        }
        chart.series.push_back(series);
    }
    return chart;
}

}  // namespace

std::string tissue_picture(const Suite& suite) {
    const Values value(suite);
    return svg({by_resolution(value), by_solver(value)});
}

}  // namespace app::bench
