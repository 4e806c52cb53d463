#include "tests/bench/suites/speed_vs_error.hpp"

#include <algorithm>
#include <cmath>

#include "tests/bench/lab/problems.hpp"
#include "tests/bench/lab/words.hpp"
#include "tests/bench/suites/plot.hpp"
#include "tests/bench/suites/speed.hpp"

namespace bench::suites {

using namespace lab;

namespace {

std::string name_of(bool elastic) {
    return elastic ? "elastic" : "ftl";
}

// "capstan-half-ftl-link05-tick025": a link half a diameter long, a tick of 0.25 ms.
std::string id_of(const Problem& problem, const Setting& s) {
    std::string id = problem.id + "-" + name_of(s.elastic) + "-link" + digits(s.link) + "-tick" + digits(1000 * s.tick);
    std::erase(id, '.');
    return id;
}

std::string id_of(const RodCase& c, int links) {
    return c.id + "-rod-link" + std::to_string(links);
}

struct Trial {
    Setting setting;
    Compared found;
    Cost cost;
    double seconds;
};

std::vector<Trial> tried(const Problem& problem, bool quick) {
    std::vector<Trial> trials;
    for (const bool elastic : {false, true})
        for (const double tick : problem.ticks)
            for (const double link : problem.link) {
                if (quick && (tick < problem.ticks.front() || link != problem.link.front())) continue;
                Trial trial{{elastic, link, tick}, {}, {}, processor_time()};
                trial.found = problem.with(trial.setting, trial.cost);
                trial.seconds = processor_time() - trial.seconds;
                trials.push_back(trial);
            }
    return trials;
}

void add(Suite& suite, const Problem& problem, bool quick) {
    for (const Trial& trial : tried(problem, quick)) {
        const Setting& s = trial.setting;
        const std::string id = id_of(problem, s) + "-", links = ", links (" + problem.links + ") " + digits(s.link);
        const std::string words =
            problem.what + "; " + name_of(s.elastic) + links + ", ticks of " + digits(1000 * s.tick) + " ms: ";
        suite.rows.push_back(told(id + "found", words + "found", trial.found.found, "ratio", trial.seconds));
        if (!problem.ranks)
            suite.rows.push_back(told(id + "error", words + "error", 100 * std::abs(trial.found.error()), "%", 0));
        suite.rows.push_back(
            told(id + "cost", words + "processor time of a simulated second", trial.cost.per_second(s.tick), "ms", 0));
        suite.rows.push_back(told(id + "links", words + "links of the whole thread", trial.cost.links, "count", 0));
        if (s.elastic)
            suite.rows.push_back(
                told(id + "sweeps", words + "sweeps over contacts, mean of a tick", trial.cost.sweeps(), "count", 0));
    }
}

constexpr int rod_links[] = {20, 40, 80, 160};

void add(Suite& suite, const RodCase& c, bool quick) {
    for (const int links : rod_links) {
        if (quick && links > 40) continue;
        const double begin = processor_time(), error = 100 * std::abs(c.at(links).error()),
                     seconds = processor_time() - begin;
        const std::string id = id_of(c, links) + "-",
                          words = c.what + "; rod alone, links (number) " + std::to_string(links) + ": ";
        suite.rows.push_back(told(id + "error", words + "error", error, "%", seconds));
        suite.rows.push_back(told(id + "cost", words + "processor time of the answer", 1000 * seconds, "ms", 0));
    }
}

// A figure over cost, of a suite's rows.
class Points {
  public:
    explicit Points(const Suite& suite) : suite_(suite) {}

    void add_to(Series& series, const std::string& id, const std::string& figure, const std::string& label) const {
        const double cost = value_in(suite_, id + "-cost"), value = value_in(suite_, id + "-" + figure);
        if (!std::isnan(cost) && !std::isnan(value)) series.points.push_back({cost, value, label});
    }

  private:
    const Suite& suite_;
};

std::string picture(const Problem& problem, const Points& points) {
    Chart chart{"processor time of a simulated second [ms]",
                (problem.ranks ? "ratio; links: " : "error [%]; links: ") + problem.links,
                {},
                true};
    for (const bool elastic : {false, true})
        for (const double tick : problem.ticks) {
            Series series{name_of(elastic) + ", ticks of " + digits(1000 * tick) + " ms", {}, !elastic};
            for (const double link : problem.link)
                points.add_to(series, id_of(problem, {elastic, link, tick}), problem.ranks ? "found" : "error",
                              digits(link));
            if (!series.points.empty()) chart.series.push_back(series);
        }
    return svg({chart});
}

std::string picture(const RodCase& c, const Points& points) {
    Series series{"rod alone", {}};
    for (const int links : rod_links) points.add_to(series, id_of(c, links), "error", std::to_string(links));
    return svg({{"processor time of the answer [ms]", "error [%]; links: number", {series}, true}});
}

}  // namespace

Suite speed_vs_error_suite(bool quick, const Progress& progress) {
    Suite suite{"speed-vs-error", {}};
    const OneCore one_core;
    for (const Problem& problem : problems()) {
        progress(problem.what);
        add(suite, problem, quick);
    }
    for (const RodCase& c : still_problems()) {
        progress(c.what);
        add(suite, c, quick);
    }
    return suite;
}

std::vector<std::pair<std::string, std::string>> speed_vs_error_pictures(const Suite& suite) {
    const Points points(suite);
    std::vector<std::pair<std::string, std::string>> pictures;
    for (const Problem& problem : problems()) pictures.emplace_back(problem.id, picture(problem, points));
    for (const RodCase& c : still_problems()) pictures.emplace_back(c.id, picture(c, points));
    return pictures;
}

}  // namespace bench::suites
