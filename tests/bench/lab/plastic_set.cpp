#include "tests/bench/lab/plastic_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/rod/rod.hpp"
#include "tests/bench/lab/bends.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/words.hpp"

namespace bench::lab {

namespace {

using sim::rod::Rod;
using sim::thread::Hold;
using sim::thread::RodDef;
using sim::thread::Thread;

// Moment of a round section bent to `times` the curvature at which its outermost fibres yield, over the moment there:
// half of its height out to r sin(elastic) is elastic, the rest carries what it yields at.
double moment(double times) {
    if (times <= 1) return times;
    const double elastic = std::asin(1 / times), cosine = std::cos(elastic);
    return 16 / std::numbers::pi * ((elastic / 8 - std::sin(4 * elastic) / 32) * times + cosine * cosine * cosine / 3);
}

std::vector<Vec3> arc(int links, double link, double out) {
    const double turn = 2 * std::asin(0.5 * link / out);
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.emplace_back(out * std::sin(i * turn), out * (1 - std::cos(i * turn)), 0);
    return nodes;
}

std::vector<Vec3> straight_rod(int links, double link) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.emplace_back(i * link, 0, 0);
    return nodes;
}

// How long a knot is: from the first place at which another strand is as near as strands that touch, to the last.
double knotted(std::span<const Vec3> x) {
    constexpr double touching = 1.2, strand = 5;  // [D]; what is nearer along the thread is no other strand
    double along = 0, first = -1, last = 0;
    std::vector<double> at{0};
    for (std::size_t i = 1; i < x.size(); ++i) at.push_back(along += (x[i] - x[i - 1]).norm());
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = i + 1; j < x.size(); ++j) {
            if (at[j] - at[i] < strand * default_diameter || (x[j] - x[i]).norm() > touching * default_diameter)
                continue;
            if (first < 0) first = at[i];
            last = std::max(last, at[j]);
        }
    return first < 0 ? 0 : (last - first) / default_diameter;
}

struct Overhand {
    explicit Overhand(double yield_strain)
        : rod{.axial_over_bending = 0, .yield_strain = yield_strain},
          thread({.friction = 0.3, .elastic = rod}, overhand(links, links * default_diameter)) {}

    double pulled() const { return thread.tension()[1]; }

    // Held at two nodes each, as a rod must be that is not to slip its loop over its ends.
    void draw(double way) {
        const auto x = thread.nodes();
        const auto held = [&](int node, double by) {
            return Hold{node, x[static_cast<std::size_t>(node)] + by * Vec3::UnitX()};
        };
        const Hold holds[] = {held(0, -way), held(1, -way), held(links - 1, way), held(links, way)};
        constexpr int owners[] = {0, 0, 1, 1};
        pass_throughs += thread.tick({.holds = holds, .hold_owners = owners, .capsules = {}}).pass_throughs;
    }

    void load(double force) {
        std::vector<Vec3> loads(thread.nodes().size(), Vec3::Zero());
        loads.front() = -force * Vec3::UnitX(), loads.back() = force * Vec3::UnitX();
        pass_throughs += thread.tick({.holds = {}, .hold_owners = {}, .capsules = {}, .seconds = 1e-3, .loads = loads})
                             .pass_throughs;
    }

    static constexpr int links = 100;
    RodDef rod;
    Thread thread;
    int pass_throughs = 0;
};

}  // namespace

Compared springback(double diameters, double yield_strain) {
    constexpr int links = 20;
    constexpr double link = 0.25 * default_diameter;
    Rod rod({.density = 0, .yield_strain = yield_strain}, straight_rod(links, link));
    const std::vector<Vec3> round = arc(links, link, diameters * default_diameter);
    std::vector<Hold> laid;
    for (int i = 0; i <= links; ++i) laid.push_back({i, round[static_cast<std::size_t>(i)]});
    rod.step({laid}, 0);
    // A bend that is kept counts as a load when a rod asks whether it is stable: bent about a strand it balances and is
    // never told to be.
    for (int tries = 0; tries < 10 && !rod.step({{laid.data(), 2}}, 0).settled; ++tries) {
    }
    const std::span<const Vec3> x = rod.nodes();
    double bend = 0;
    for (std::size_t i = 1; i < links; ++i)
        bend += ((x[i + 1] - x[i]).normalized() - (x[i] - x[i - 1]).normalized()).norm();
    const double yields = yield_strain / default_radius, bent = 1 / (diameters * default_diameter);
    return {default_diameter * bend / ((links - 1) * link), default_diameter * (bent - yields * moment(bent / yields))};
}

LetGoOverhand let_go_overhand(double pull, double yield_strain) {
    constexpr double step = 0.05;  // [D] in a tick
    constexpr int most_ticks = 4000, ramp = 500, free = 1000;
    Overhand knot(yield_strain);
    const double force = pull * knot.rod.bending_stiffness() / (default_diameter * default_diameter);
    for (int t = 0; t < most_ticks && knot.pulled() < force; ++t) knot.draw(step * default_diameter);
    const double tight = knotted(knot.thread.nodes());
    for (int t = 1; t <= ramp + free; ++t) knot.load(force * std::max(0.0, 1 - static_cast<double>(t) / ramp));
    return {tight, knotted(knot.thread.nodes()), knot.pass_throughs};
}

namespace {

struct SetTable {
    std::vector<Row> rows;

    void add(const std::string& id, const std::string& what, double value, const char* unit,
             std::optional<double> bound = {}, Must must = Must::be_at_most) {
        const double now = processor_time();
        rows.push_back({.id = id,
                        .what = what,
                        .value = value,
                        .unit = unit,
                        .bound = bound,
                        .must = must,
                        .error = {},
                        .seconds = now - begun});
        begun = now;
    }

    double begun = processor_time();
};

// The moment is capped at what the whole section carries: right about as much as strands are bent in knots, too stiff
// where few fibres yield.
void add_springback(SetTable& table) {
    for (const auto& [out, bound] :
         {std::pair(2, std::optional(1.0)), std::pair(7, std::optional(5.0)), std::pair(14, std::optional<double>())}) {
        const Compared found = springback(0.5 * out, polypropylene_yield);
        const double straight = 2.0 / out;  // the bend that it was laid into [1/D]
        table.add("set-springback-" + std::to_string(out),
                  "polypropylene laid round a mandrel, " + std::to_string(out) +
                      " radii from its axis: share that it keeps of its bend",
                  found.found / straight, "ratio");
        table.add("set-springback-" + std::to_string(out) + "-error", "the same: error of that",
                  100 * std::abs(found.error()), "%", bound);
    }
}

void add_overhands(SetTable& table, bool quick) {
    constexpr double gives = 3;  // [D]
    for (const double pull : quick ? std::vector{1.0} : std::vector{0.3, 1.0})
        for (const bool set : {false, true}) {
            const LetGoOverhand found = let_go_overhand(pull, set ? polypropylene_yield : 0);
            const std::string id = "set-overhand-" + whole(10 * pull) + (set ? "-on" : "-off");
            const std::string what = "elastic overhand, friction 0.3, pulled with " + whole(10 * pull) +
                                     " tenths of B/D^2, " + (set ? "plastic set: " : "no set: ");
            table.add(id + "-tight", what + "its length", found.tight, "D");
            table.add(id, what + "let go of, longer by", found.after - found.tight, "D",
                      set ? std::optional(gives) : std::nullopt);
            table.add(id + "-passes", what + "pass-throughs", found.pass_throughs, "count", 0);
        }
}

// As in bend_rows, where there is no set.
void add_loops(SetTable& table) {
    const Bend square{"square knot of 2 throws", true, false}, granny{"granny knot of 2 throws", false, false};
    for (const auto& [name, bend] : {std::pair("square", square), std::pair("granny", granny)})
        for (const bool set : {false, true}) {
            const LetGo found = let_go(
                bend, {.friction = 0.3, .bending_share = 1, .tails = 1, .yield_strain = set ? polypropylene_yield : 0});
            table.add(std::string("set-loop-") + name + (set ? "-on" : "-off"),
                      std::string("elastic ") + bend.words + ", friction 0.3, pulled with B/D^2, " +
                          (set ? "plastic set" : "no set") + ": its tails, let go of, run in by",
                      found.run_in, "D");
        }
}

// What it holds once its tails are all but free, by what it was tied with. In experiments that grows as the pull to 1.6
// [SurgeryAndPhysics B2].
void add_strength(SetTable& table) {
    constexpr double weak = 0.1, friction = 0.1;
    const Bend square{"square knot of 2 throws", true, false};
    std::array<double, 2> held{};
    for (const bool set : {false, true}) {
        const std::string on = set ? "-on" : "-off", what = "elastic square knot of 2 throws, friction 0.1, " +
                                                            std::string(set ? "plastic set" : "no set");
        for (const double tying : {weak, 10 * weak}) {
            const Pulled found = pull_bend(square, {.friction = friction,
                                                    .bending_share = 1,
                                                    .tails = 0.02,
                                                    .yield_strain = set ? polypropylene_yield : 0,
                                                    .tying = tying});
            if (tying > weak)
                table.add("set-strength-exponent" + on, what + ": exponent of what it holds by what it is tied with",
                          std::log10(found.force / held[set]), "exponent");
            else
                held[set] = found.force;
            table.add(
                "set-strength-" + whole(10 * tying) + on,
                what + ", tied with " + whole(10 * tying) + " tenths of B/D^2, tails with a fiftieth: slips under",
                found.force, "B/D^2");
            table.add("set-strength-" + whole(10 * tying) + on + "-passes", what + ": pass-throughs",
                      found.pass_throughs, "count", 0);
        }
    }
    table.add("set-strength-more",
              "elastic square knot of 2 throws, friction 0.1, tied with a tenth of B/D^2: what it holds with plastic "
              "set over without",
              held[1] / held[0], "ratio", 1, Must::be_at_least);
}

}  // namespace

std::vector<Row> plastic_set_rows(bool quick) {
    SetTable table;
    add_springback(table);
    add_overhands(table, quick);
    if (!quick) add_loops(table), add_strength(table);
    return table.rows;
}

}  // namespace bench::lab
