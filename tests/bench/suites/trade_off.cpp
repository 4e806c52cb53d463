#include <algorithm>

#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/thread_rope.hpp"
#include "tests/bench/lab/words.hpp"
#include "tests/bench/suites/plot.hpp"
#include "tests/bench/suites/speed.hpp"

namespace bench::suites {

using namespace lab;

namespace {

constexpr double sample_length = 1, sample_diameter = 5e-3, sample_speed = 0.1;  // [m], [m], [m/s]
constexpr double links_long[] = {0.5, 1, 2};                                     // [diameters]
constexpr double ticks_ms[] = {0.25, 1, 4};

// "ftl-link05-tick025": a link half a diameter long, a tick of 0.25 ms.
std::string id_of(double link, double tick_ms) {
    std::string id = "ftl-link" + digits(link) + "-tick" + digits(tick_ms);
    std::erase(id, '.');
    return id;
}

std::string words_of(double link, double tick_ms) {
    return "links of " + digits(link) + " D, tick of " + digits(tick_ms) + " ms: ";
}

PullFigures pull_with(double link, double tick_ms) {
    const int links = static_cast<int>(sample_length / (link * sample_diameter) + 0.5);
    const PullDef def{.links = links,
                      .speed = sample_speed,
                      .tick = tick_ms / 1000,
                      .diameter = sample_diameter,
                      .length = sample_length};
    const auto start = overhand(def.links, def.length);
    ThreadRope rope(def, start);
    return pull(rope, def, start);
}

}  // namespace

void add_trade_off(Suite& suite, bool quick, const Progress& progress) {
    for (const double link : links_long)
        for (const double tick_ms : ticks_ms) {
            if (quick && (tick_ms < 1 || link < 1)) continue;  // these take longest
            progress("speed against error, " + id_of(link, tick_ms));
            const Stopwatch watch;
            const PullFigures found = pull_with(link, tick_ms);
            const double seconds = watch.seconds();
            const auto add = [&](const std::string& id, const std::string& what, double value,
                                 const std::string& unit) {
                const std::string whole_id = id_of(link, tick_ms) + "-" + id, words = words_of(link, tick_ms) + what;
                suite.rows.push_back(told(whole_id, words, value, unit, seconds));
            };
            add("cost", "cost of a simulated second", found.tick_mean / tick_ms, "ms");  // us in a ms is ms in a second
            add("stretch", "longest link", 100 * std::max(found.stretch_pull, found.stretch_over), "%");
            add("gap", "smallest gap", std::min(found.gap_pull, found.gap_over), "D");
            add("kappa", "taken up by the tight knot", found.kappa_least, "D");
        }
}

std::string trade_off_picture(const Suite& suite) {
    const auto chart = [&](const std::string& figure, const std::string& label) {
        Chart made{"cost of a simulated second [ms]", label, {}};
        for (const double link : links_long) {
            Series series{"links of " + digits(link) + " D", {}};
            for (const double tick_ms : ticks_ms)
                series.points.push_back({value_in(suite, id_of(link, tick_ms) + "-cost"),
                                         value_in(suite, id_of(link, tick_ms) + "-" + figure),
                                         digits(tick_ms) + " ms"});
            made.series.push_back(series);
        }
        return made;
    };
    return svg({chart("stretch", "longest link [%]"), chart("gap", "smallest gap [D]"),
                chart("kappa", "tight overhand takes up [D]")});
}

}  // namespace bench::suites
