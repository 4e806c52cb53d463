#include <algorithm>
#include <map>

#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/thread_rope.hpp"
#include "tests/bench/peers/peer.hpp"
#include "tests/bench/suites/speed.hpp"

namespace bench::suites {

using namespace lab;

namespace {

struct Bound {
    double value;
    Must must = Must::be_at_most;
};

/// One overhand pull, and what our figures must be.
struct Scene {
    std::string id, words;
    int links;
    double speed;  ///< [m/s]
    int times;     ///< That we and each peer pull; 1 or none when it must be quick.
    bool quick;
    std::map<std::string, Bound> bounds;
};

// Stretch in per cent, gaps in diameters. An ideal tight overhand knot takes up 10.1 diameters: less would be strands
// pressed into each other.
std::map<std::string, Bound> bounds(double stretch, double gap) {
    return {{"stretch-pull", {stretch}},
            {"stretch-rest", {stretch}},
            {"stretch-over", {stretch}},
            {"gap-pull", {gap, Must::be_at_least}},
            {"gap-over", {gap, Must::be_at_least}},
            {"kappa-least", {10, Must::be_at_least}},
            {"knot-kept", {1, Must::be_at_least}},
            {"pass-throughs", {0}}};
}

std::vector<Scene> scenes() {
    std::vector<Scene> all{{"pull-n200", "200 links, 0.1 m/s", 200, 0.1, 5, true, bounds(0.1, 0.99)},
                           {"pull-n1000", "1000 links, 0.1 m/s", 1000, 0.1, 3, false, bounds(0.2, 0.99)},
                           {"pull-n200-fast", "200 links, 2 m/s", 200, 2, 5, true, bounds(0.5, 0.97)}};
    all[0].bounds["tick-p99-over-p50"] = {2};
    all[0].bounds["ode-ratio"] = all[1].bounds["ode-ratio"] = {1 / 2.5};
    all[1].bounds["tick-p50"] = {400};
    all[2].bounds["tick-p99"] = {1000};
    return all;
}

struct Words {
    std::string what, unit;
    double scale = 1;  ///< From the figure to the unit.
};

const std::map<std::string, Words> words_of_figures{
    {"tick-p50", {"median tick", "us"}},
    {"tick-p99", {"tick, 99 of 100", "us"}},
    {"tick-max", {"longest tick", "us"}},
    {"tick-mean", {"mean tick", "us"}},
    {"tight-p50", {"median tick, tight", "us"}},
    {"tight-p99", {"tick, 99 of 100, tight", "us"}},
    {"tight-max", {"longest tick, tight", "us"}},
    {"stretch-pull", {"longest link, pulled", "%", 100}},
    {"stretch-rest", {"longest link, at rest", "%", 100}},
    {"stretch-over", {"longest link, pulled too far", "%", 100}},
    {"gap-pull", {"smallest gap, pulled", "D"}},
    {"gap-over", {"smallest gap, pulled too far", "D"}},
    {"kappa-rest", {"taken up by the knot, at rest", "D"}},
    {"kappa-least", {"taken up by the knot, least", "D"}},
    {"lag", {"largest lag of an end", "D"}},
    {"knot-kept", {"knot kept", "count"}},
    {"pass-throughs", {"pass-throughs", "count"}},
};

using Runs = std::vector<PullFigures>;

/// Middle and half spread of a figure over the runs.
struct Over {
    double middle, half_spread;
};

Over over(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return {percentile(values, 0.5), 0.5 * (*most - *least)};
}

class PullTable {
  public:
    PullTable(Suite& suite, const Scene& scene, double seconds) : suite_(suite), scene_(scene), seconds_(seconds) {}

    /// `whose`: "" or "ode-", whose rows have no bounds.
    void add(const std::string& whose, const std::string& id, const Words& how, const std::vector<double>& values) {
        const Over all = over(values);
        const std::string what = scene_.words + ": " + how.what;
        Row row = told(whose + scene_.id + "-" + id, what, how.scale * all.middle, how.unit, seconds_);
        if (values.size() > 1) row.error = how.scale * all.half_spread;
        const auto bound = scene_.bounds.find(id);
        const bool judged = whose.empty() && bound != scene_.bounds.end();
        if (judged) row.bound = bound->second.value, row.must = bound->second.must;
        suite_.rows.push_back(row);
    }

    void add(const std::string& whose, const Runs& runs) {
        for (const auto& [id, value] : pull_figures) {
            if (!whose.empty() && value == &PullFigures::pass_throughs) continue;  // peers do not look out for them
            std::vector<double> values;
            for (const PullFigures& run : runs) values.push_back(run.*value);
            Words how = words_of_figures.at(id);
            if (!whose.empty()) how.what = whose.substr(0, whose.size() - 1) + ", " + how.what;
            add(whose, id, how, values);
        }
    }

  private:
    Suite& suite_;
    const Scene& scene_;
    double seconds_;
};

PullFigures pull_ours(const Scene& scene) {
    const PullDef def{.links = scene.links, .speed = scene.speed};
    const auto start = overhand(def.links, def.length);
    ThreadRope rope(def, start);
    return pull(rope, def, start);
}

std::vector<std::string> peers_there(const Progress& progress) {
    std::vector<std::string> names;
    for (const std::string name : {"ode", "bullet"}) {
        if (peers::Peer(name).there())
            names.push_back(name);
        else
            progress("no tests/rope_" + name + " beside this program: figures against it are left out");
    }
    return names;
}

// We and the peers take turns, so that what slows the machine for a while slows all.
void add_scene(Suite& suite, const Scene& scene, const std::vector<std::string>& names, int times,
               const Progress& progress) {
    const Stopwatch watch;
    Runs ours;
    std::map<std::string, Runs> theirs;
    for (int i = 0; i < times; ++i) {
        progress("overhand pull, " + scene.words + ", " + std::to_string(i + 1) + " of " + std::to_string(times));
        ours.push_back(pull_ours(scene));
        for (const std::string& peer : names) theirs[peer].push_back(peers::Peer(peer).pull(scene.links, scene.speed));
    }
    PullTable table(suite, scene, watch.seconds());
    table.add("", ours);
    std::vector<double> spread;
    for (const PullFigures& run : ours) spread.push_back(run.tick_p99 / run.tick_p50);
    table.add("", "tick-p99-over-p50", {"tick, 99 of 100 over median", "ratio"}, spread);
    for (const std::string& peer : names) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < ours.size(); ++i) ratios.push_back(ours[i].tick_p50 / theirs[peer][i].tick_p50);
        table.add("", peer + "-ratio", {"median tick over that of " + peer, "ratio"}, ratios);
    }
    for (const std::string& peer : names) table.add(peer + "-", theirs[peer]);
}

}  // namespace

void add_pulls(Suite& suite, bool quick, const Progress& progress) {
    const std::vector<std::string> names = peers_there(progress);
    for (const Scene& scene : scenes())
        if (!quick || scene.quick) add_scene(suite, scene, names, quick ? 1 : scene.times, progress);
}

}  // namespace bench::suites
