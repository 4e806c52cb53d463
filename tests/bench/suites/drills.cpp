#include "tests/bench/suites/drills.hpp"

#include <algorithm>
#include <cmath>

#include "scenarios/session/script.hpp"
#include "scenarios/session/session.hpp"
#include "scenarios/world/judge.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/suites/speed.hpp"

namespace bench::suites {

using namespace lab;

namespace {

using scenarios::drill::Drill;

/// What is changed in a drill before it is played.
struct Way {
    std::string id, words;
    std::string model;
    double link = 1;                ///< Links so many times as long, the shortest too.
    std::optional<int> contacts{};  ///< contacts_per_tick; none: the drill's own.
    double tick = 1e-3;             ///< [s]
};

struct Case {
    std::string id, file;
    std::vector<Way> ways;  ///< The fine one first, then as it is.
};

const Way shipped{"shipped", "as it is", ""};

std::vector<Case> cases() {
    const Way finest{"fine", "links half as long, ticks of 0.5 ms", "ftl", 0.5, {}, 0.5e-3};
    const Way fine{"fine", "links half as long, all contacts", "elastic", 0.5, 0};
    const Way halved{"halved", "links half as long", "", 0.5}, doubled{"doubled", "links twice as long", "", 2};
    const Way slower{"tick2", "ticks of 2 ms", "", 1, {}, 2e-3}, ftl{"ftl", "ftl", "ftl"},
        elastic{"elastic", "elastic", "elastic"};
    const Way all{"contacts0", "all contacts", "", 1, 0}, fifty{"contacts50", "contacts_per_tick 50", "", 1, 50};
    const std::vector<Way> loose{finest, shipped, halved, doubled, slower, elastic};
    return {{"square", "square-knot", loose},
            {"granny", "granny-knot", loose},
            {"surgeons", "surgeons-knot", loose},
            {"assisted-square", "assisted-square-knot", {fine, shipped, all, fifty, halved, doubled, slower, ftl}},
            {"assisted-granny", "assisted-granny-knot", {fine, shipped, doubled, slower, ftl}}};
}

Drill changed(Drill drill, const Way& way) {
    auto& thread = drill.world.thread;
    if (!way.model.empty()) thread.model = way.model;
    thread.links = static_cast<int>(std::lround(thread.links / way.link));
    thread.shortest_link *= way.link;
    thread.contacts_per_tick = way.contacts.value_or(thread.contacts_per_tick);
    drill.world.tick_s = way.tick;
    return drill;
}

struct Figure {
    std::string id, what, unit;
    double value;
};

struct PlayedDrill {
    std::string knot;
    std::vector<Figure> measured, cost;
};

PlayedDrill played(const std::filesystem::path& file, const Way& way) {
    const scenarios::session::Script script(changed(scenarios::drill::load_drill(file), way));
    scenarios::session::Session session(script.drill, script.inputs(0));
    std::vector<double> ticks;  // [us]
    double spent = 0;           // [s]
    const double duration_s = script.motion.duration();
    for (std::uint64_t tick = 0; static_cast<double>(tick) * way.tick < duration_s; ++tick) {
        const auto inputs = script.inputs(tick);
        const double begin = processor_time();
        session.tick(inputs);
        const double took = processor_time() - begin;
        ticks.push_back(1e6 * took);
        spent += took;
    }
    session.finish();  // names the knot as it is now
    const auto found = scenarios::world::judge(session.world());
    const auto [shorter, longer] = std::minmax_element(found.tail_mm.begin(), found.tail_mm.end());
    const bool tied = !found.tail_mm.empty();
    return {found.knot.called(),
            {{"knot", "thread in the knot", "mm", found.knot_mm},
             {"loop", "thread in its loop", "mm", found.loop_mm},
             {"shorter", "shorter tail", "mm", tied ? *shorter : 0},
             {"longer", "longer tail", "mm", tied ? *longer : 0},
             {"tension", "largest tension", "N", found.tension_max_N.value}},
            {{"cost", "processor time of a simulated second", "ms", 1000 * spent / duration_s},
             {"p50", "median tick", "us", percentile(ticks, 0.5)},
             {"p99", "tick, 99th percentile", "us", percentile(ticks, 0.99)}}};
}

}  // namespace

void add_drills(Suite& suite, const std::filesystem::path& drills, bool quick, const Progress& progress) {
    const OneCore one_core;
    for (const Case& drill : cases()) {
        std::optional<PlayedDrill> fine;
        for (const Way& way : drill.ways) {
            if (quick && way.id != shipped.id) continue;
            progress("the drill " + drill.file + ", " + way.words);
            const double begin = processor_time();
            const PlayedDrill now = played(drills / (drill.file + ".json"), way);
            const double seconds = processor_time() - begin;
            if (!quick && !fine) fine = now;
            const std::string id = "drill-" + drill.id + "-" + way.id + "-",
                              words = drill.file + "; " + way.words + ": ";
            const std::string called = words + (now.knot == "0_1" ? "no knot" : now.knot) + ", as in the fine run";
            if (fine) suite.rows.push_back(told(id + "same", called, now.knot == fine->knot, "count", seconds));
            for (std::size_t i = 0; i < now.measured.size(); ++i) {
                const Figure& figure = now.measured[i];
                suite.rows.push_back(told(id + figure.id, words + figure.what, figure.value, figure.unit, 0));
                if (fine) suite.rows.back().error = std::abs(figure.value - fine->measured[i].value);
            }
            for (const Figure& figure : now.cost)
                suite.rows.push_back(told(id + figure.id, words + figure.what, figure.value, figure.unit, 0));
        }
        if (quick) return;
    }
}

}  // namespace bench::suites
