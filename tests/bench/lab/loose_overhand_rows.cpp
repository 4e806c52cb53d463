#include <cmath>
#include <string>

#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/loose_overhand.hpp"
#include "tests/bench/lab/words.hpp"

namespace bench::lab {

namespace {

std::string id_of(const LooseOverhand& knot) {
    return (knot.half_turns > 3 ? "double" : "loose") + ("-overhand-" + whole(knot.loop)) + "-mu" +
           whole(10 * knot.friction) + "-n" + whole(knot.links);
}

std::string words_of(const LooseOverhand& knot) {
    return std::string(knot.half_turns > 3 ? "loose double" : "loose") + " overhand, loop of " + whole(knot.loop) +
           " radii, " + whole(knot.links) + " links round it, friction 0." + whole(10 * knot.friction) + ": ";
}

// What friction adds, as it enters the law.
double sigma(const LooseOverhand& knot, double pull, double without) {
    return (pull - without) / (knot.friction * std::pow(knot.eps(), 3));
}

// Through points (eps, value).
struct Line {
    double sum = 0, e = 0, ee = 0, v = 0, ev = 0;

    void add(double eps, double value) { sum += 1, e += eps, ee += eps * eps, v += value, ev += eps * value; }
    double slope() const { return (sum * ev - e * v) / (sum * ee - e * e); }
    double at_zero() const { return (v - slope() * e) / sum; }
};

// Its error may be more than is asked: the law is the first order in eps alone.
double add_pull(std::vector<Row>& rows, const LooseOverhand& knot) {
    const double begin = processor_time(), found = drawn_with(knot);
    rows.push_back({.id = id_of(knot),
                    .what = words_of(knot) + "error of the pull",
                    .value = 100 * std::abs(found / knot.law() - 1),
                    .unit = "%",
                    .bound = 15,
                    .error = {},
                    .seconds = processor_time() - begin});
    return found;
}

// The thinner the thread, the better the law: what lines through all say of one without thickness.
void add_thin(std::vector<Row>& rows, int links) {
    const double frictions[] = {0.1, 0.3};
    Line bending, dragging[2];
    for (const double loop : {120.0, 240.0, 480.0}) {
        LooseOverhand knot{.loop = loop, .links = links};
        const double without = add_pull(rows, knot);
        bending.add(knot.eps(), without / knot.law());
        for (int i = 0; i < 2; ++i) {
            knot.friction = frictions[i];
            dragging[i].add(knot.eps(), sigma(knot, add_pull(rows, knot), without));
        }
    }
    const auto add = [&](const std::string& id, const std::string& what, double value, double reference, double slope) {
        const std::string end = "-n" + whole(links),
                          of = "loose overhand, " + whole(links) + " links round it: " + what;
        rows.push_back({.id = "loose-overhand-" + id + end,
                        .what = of + " as eps goes to 0",
                        .value = value,
                        .unit = "ratio",
                        .bound = {},
                        .error = {}});
        rows.push_back({.id = "loose-overhand-" + id + "-off" + end,
                        .what = of + ", its error",
                        .value = 100 * std::abs(value / reference - 1),
                        .unit = "%",
                        .bound = 15,
                        .error = {}});
        rows.push_back({.id = "loose-overhand-" + id + "-slope" + end,
                        .what = of + ", how it grows with eps",
                        .value = slope,
                        .unit = "ratio",
                        .bound = {},
                        .error = {}});
    };
    add("thin", "pull over the law's without friction", bending.at_zero(), 1, bending.slope());
    add("sigma-mu1", "sigma at friction 0.1", dragging[0].at_zero(), 0.492, dragging[0].slope());
    add("sigma-mu3", "sigma at friction 0.3", dragging[1].at_zero(), 0.492, dragging[1].slope());
}

// What friction adds to a double one, from what it is drawn with without; 0.345 in surgery-and-physics.md D9, from
// memory.
void add_double_sigma(std::vector<Row>& rows, double without) {
    for (const double friction : {0.1, 0.3}) {
        const LooseOverhand knot{.loop = 1920, .links = 960, .half_turns = 5, .friction = friction};
        const double begin = processor_time(), found = sigma(knot, drawn_with(knot), without);
        rows.push_back({.id = "double-overhand-sigma-mu" + whole(10 * friction),
                        .what = words_of(knot) + "sigma",
                        .value = found,
                        .unit = "ratio",
                        .bound = {},
                        .error = {},
                        .seconds = processor_time() - begin});
    }
}

// More turns of the strands about each other and more friction: harder to draw. Of the least of these.
void add_order(std::vector<Row>& rows, double loop, int links) {
    const double begin = processor_time();
    double turns = 1e300, drags = 1e300, before[2] = {0, 0};
    for (const double friction : {0.0, 0.1, 0.3}) {
        const double pulls[] = {drawn_with({loop, links, 3, friction}), drawn_with({loop, links, 5, friction})};
        turns = std::fmin(turns, pulls[1] / pulls[0]);
        for (int i = 0; i < 2; ++i) {
            if (friction > 0) drags = std::fmin(drags, pulls[i] / before[i]);
            before[i] = pulls[i];
        }
    }
    const auto add = [&](const char* id, const char* what, double value, double seconds) {
        rows.push_back({.id = id,
                        .what = what,
                        .value = value,
                        .unit = "ratio",
                        .bound = 1,
                        .must = Must::be_at_least,
                        .error = {},
                        .seconds = seconds});
    };
    add("loose-overhand-turns",
        "loose double overhand over a single one, friction 0, 0.1 and 0.3: least ratio of pulls", turns,
        processor_time() - begin);
    add("loose-overhand-frictions",
        "loose overhands, single and double, friction 0.1 over 0 and 0.3 over 0.1: least ratio of pulls", drags, 0);
}

}  // namespace

std::vector<Row> loose_overhand_rows(bool quick) {
    std::vector<Row> rows;
    if (quick) {
        for (const double friction : {0.0, 0.1}) add_pull(rows, {.loop = 120, .links = 60, .friction = friction});
        return rows;
    }
    for (const int links : {60, 120, 240}) add_pull(rows, {.loop = 60, .links = links});
    for (const int links : {60, 120, 240}) add_thin(rows, links);
    for (const double loop : {120.0, 240.0}) add_pull(rows, {.loop = loop, .links = 120, .half_turns = 5});
    for (const double friction : {0.0, 0.1, 0.3}) add_pull(rows, {.loop = 1920, .links = 960, .friction = friction});
    add_pull(rows, {.loop = 3840, .links = 1920, .friction = 0.3});
    add_double_sigma(rows, add_pull(rows, {.loop = 1920, .links = 960, .half_turns = 5}));
    add_order(rows, 120, 120);
    return rows;
}

}  // namespace bench::lab
