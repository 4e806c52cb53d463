#include "tests/bench/suites/tissue_thread.hpp"

#include <algorithm>
#include <cmath>

#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/thread_in_tube.hpp"

namespace bench::suites {

using namespace lab;

namespace {

constexpr double tick = 1e-3, fast = 0.05, usual = 0.01,
                 slow = 0.002;  // [s], [m/s]: as needles draw thread after them, as fast as half of all tool tips, as a
                                // stitch is tightened
constexpr double load =
    5e-3;  // at the end that follows [N]: through ten bites less than 0.3 N by the law, so that walls stay round

// The worst of a thread on its way.
struct Seen {
    bool in_order = true;
    double off = 0, length = 0;  // of holes' middles [hole radii]; over what it should be [%]

    void look(const ThreadInTube& scene, bool by_lead) {
        const auto at = scene.at_holes();
        for (std::size_t i = 0; i < at.size(); ++i) {
            in_order = in_order && (i == 0 || at[i - 1].along < at[i].along);
            off = std::max(off, at[i].off / scene.vessel().skin.radius(0));
        }
        length = std::max(length, 100 * scene.length_off(by_lead, load));
    }
};

int ticks_of(double way, double speed) {
    return static_cast<int>(std::lround(way / (speed * tick)));
}

// Until it went so far; a hand that waits for three times as long gives up. Returns how much longer than without
// waiting it took.
double draw(ThreadInTube& scene, bool by_lead, double way, Seen& seen) {
    constexpr int look_every = 10;  // half a millimetre, in which what was held before springs back
    const int ticks = ticks_of(way, fast);
    double gone = 0;
    int i = 0;
    for (; i < 3 * ticks && gone < way - 0.5 * fast * tick; ++i) {
        gone += scene.draw(by_lead, fast * tick, load);
        if ((i + 1) % look_every == 0) seen.look(scene, by_lead);
    }
    return static_cast<double>(i) / ticks;
}

}  // namespace

double slides_by(int bites, bool is_elastic, double friction, double speed, double way) {
    constexpr double limp = 0.01;  // of the bending stiffness: the law's rope has none
    ThreadInTube scene(
        {.bites = bites, .is_elastic = is_elastic, .tail = 40e-3, .friction = friction, .bending_share = limp});
    double before = 0, after = 0, turned = 0;
    int looks = 0;
    for (int i = 0; i < ticks_of(way, speed); ++i) {
        scene.draw(true, speed * tick, load);
        if (2 * i < ticks_of(way, speed)) continue;
        before += scene.tension_of_tail(), after += scene.tension_of_lead(), turned += scene.turned();
        ++looks;
    }
    return std::log(after / before) / (turned / looks);
}

namespace {

class Rows {
  public:
    Rows(Suite& suite, std::string id, std::string what)
        : suite_(suite), id_(std::move(id)), what_(std::move(what)), begin_(processor_time()) {}

    void add(const char* id, const char* what, double value, const char* unit, std::optional<double> bound = {},
             Must must = Must::be_at_most) {
        suite_.rows.push_back({.id = id_ + id,
                               .what = what_ + what,
                               .value = value,
                               .unit = unit,
                               .bound = bound,
                               .must = must,
                               .error = {},
                               .seconds = processor_time() - begin_});
        begin_ = processor_time();
    }
    void add(const Seen& seen, int passes) {
        add("order", "holes in their order all the time, 1", seen.in_order, "count", 1, Must::be_at_least);
        add("passes", "pass-throughs", passes, "count", 0);
        add("length", "length off at most, but for what the load stretches it by", seen.length, "%", 0.1);
        add("off", "thread off a hole's middle at most, in the hole's radii", seen.off, "radii", 1);
    }

  private:
    Suite& suite_;
    std::string id_, what_;
    double begin_;
};

void add_way(Suite& suite, int bites, bool is_elastic, const std::string& id, const std::string& thread) {
    const std::string walls = std::to_string(bites) + (bites == 1 ? " bite" : " bites");
    Rows rows(suite, id + std::to_string(bites) + "-", "100 mm of " + thread + " through " + walls + " and back: ");
    ThreadInTube scene({.bites = bites, .is_elastic = is_elastic});
    const double at_first = scene.at_holes().front().along;
    Seen seen;
    double waited = draw(scene, true, 100e-3, seen);
    const double drawn = at_first - scene.at_holes().front().along;
    waited = std::max(waited, draw(scene, false, 100e-3, seen));
    constexpr double straightened = 10;  // [mm], that the way to and fro may get shorter by
    rows.add("drawn", "of that went through the first hole", 1000 * drawn, "mm", 100 - straightened, Must::be_at_least);
    rows.add("waited", "time taken over 100 mm at 50 mm/s", waited, "ratio");
    rows.add(seen, scene.passes());
    constexpr double friction = 0.15;
    const auto slides = [&](double by, double speed) { return slides_by(bites, is_elastic, by, speed, 10e-3); };
    const double with = slides(friction, usual), without = slides(0, usual);
    Rows law(suite, id + std::to_string(bites) + "-friction",
             "limp " + thread + " drawn through " + walls + " at 10 mm/s: ");
    law.add("", "what it slides by for a friction of 0.15, off the law by", 100 * std::abs(with / friction - 1), "%",
            15);
    law.add("-none", "the same without friction", without, "coefficient");
    law.add("-alone", "friction's part of it, off the law by", 100 * std::abs((with - without) / friction - 1), "%");
    if (is_elastic)
        law.add("-slow", "as the first, but at 2 mm/s", 100 * std::abs(slides(friction, slow) / friction - 1), "%", 15);
}

// E19.
void add_saw(Suite& suite, bool is_elastic, const std::string& id, const std::string& thread) {
    Rows rows(suite, id + "saw-", thread + " drawn to and fro through 2 bites 100 times: ");
    ThreadInTube scene({.bites = 2, .is_elastic = is_elastic, .lead = 30e-3, .tail = 30e-3});
    Seen seen;
    const double at_first = scene.at_holes().front().along;
    for (int cycle = 0; cycle < 100; ++cycle)
        for (const bool by_lead : {true, false}) draw(scene, by_lead, 1e-3, seen);
    rows.add(seen, scene.passes());
    rows.add("crept", "along the thread", 1000 * std::abs(scene.at_holes().front().along - at_first), "mm");
}

}  // namespace

void add_thread_in_tissue(Suite& suite, bool quick, const Progress& progress) {
    const OneCore core;
    for (const bool is_elastic : {false, true}) {
        const std::string thread = is_elastic ? "elastic thread" : "ftl thread",
                          id = is_elastic ? "thread-elastic-" : "thread-ftl-";
        for (const int bites : quick ? std::vector{1, 2} : std::vector{1, 2, 10}) {
            if (progress) progress(thread + " through " + std::to_string(bites) + (bites == 1 ? " bite" : " bites"));
            add_way(suite, bites, is_elastic, id, thread);
        }
        if (progress) progress(thread + " to and fro");
        add_saw(suite, is_elastic, id, thread);
    }
}

}  // namespace bench::suites
