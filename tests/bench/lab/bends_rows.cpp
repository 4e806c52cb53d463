#include <algorithm>
#include <array>
#include <cmath>

#include "tests/bench/lab/bends.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/words.hpp"

namespace bench::lab {

namespace {

// "0.1", "0.12"; without its point "1", "12".
std::string friction_in(double friction) {
    const long hundredths = std::lround(100 * friction);
    return hundredths % 10 == 0 ? "0." + std::to_string(hundredths / 10) : "0." + std::to_string(hundredths);
}
std::string friction_digits(double friction) {
    return friction_in(friction).substr(2);
}

struct Table {
    std::vector<Row> rows;

    Row& add(const std::string& id, const std::string& what, double value, const char* unit,
             std::optional<double> bound = {}, Must must = Must::be_at_most) {
        return rows.emplace_back(
            Row{.id = id, .what = what, .value = value, .unit = unit, .bound = bound, .must = must, .error = {}});
    }

    // The median of runs whose tails weigh a thousandth more or less: when a knot lets go hangs on the last digit of
    // its pull.
    Pulled pulled(const std::string& id, const Bend& bend, BendPull pull) {
        const double begin = processor_time(), tails = pull.tails;
        std::vector<Pulled> found;
        for (int k = 0; k < runs; ++k) {
            pull.tails = tails * (1 + 1e-3 * (k - runs / 2));
            found.push_back(pull_bend(bend, pull));
            passes += found.back().pass_throughs;
        }
        std::sort(found.begin(), found.end(), [](const Pulled& a, const Pulled& b) { return a.force < b.force; });
        std::string what = std::string("elastic ") + bend.words + ", friction " + friction_in(pull.friction);
        if (pull.link != 1) what += ", links of " + tenths(pull.link) + " tenths of D";
        Row& row = add(id, what + ": slips under", found[found.size() / 2].force, "B/D^2");
        row.error = 0.5 * (found.back().force - found.front().force);
        row.seconds = processor_time() - begin;
        return found[found.size() / 2];
    }

    int runs = 5, passes = 0;
};

// Bending counts a fiftieth, so that thickness and friction decide and not how hard it is to bend.
void add_ranking(Table& table, double friction, double link) {
    const Bend bends[] = {{"reef knot", true, false},
                          {"thief knot", true, true},
                          {"granny knot", false, false},
                          {"grief knot", false, true}};
    constexpr std::array names{"reef", "thief", "granny", "grief"};
    const std::string on = "-mu" + friction_digits(friction) + (link == 1 ? "" : "-link" + tenths(link));
    std::array<double, 4> force{};
    for (std::size_t i = 0; i < force.size(); ++i)
        force[i] = table
                       .pulled(std::string("elastic-bend-") + names[i] + on, bends[i],
                               {.friction = friction, .bending_share = 0.02, .tails = 1, .link = link})
                       .force;
    int ordered = 0;
    for (std::size_t i = 0; i + 1 < force.size(); ++i) ordered += force[i] >= force[i + 1];
    const std::string what = "elastic bends, friction " + friction_in(friction) +
                             (link == 1 ? "" : ", links of " + tenths(link) + " tenths of D") + ": ";
    for (std::size_t i = 0; i < force.size() && link == 1; ++i)
        table.add(std::string("elastic-bend-") + names[i] + "-let-go" + on,
                  what + bends[i].words + " pulled with 15 B/D^2 slips where its tails are pulled with",
                  let_go(bends[i], {.friction = friction, .bending_share = 0.02, .tails = 15}).needed, "B/D^2");
    table.add("elastic-bends-order" + on, what + "neighbours in the order reef, thief, granny, grief", ordered, "count",
              3, Must::be_at_least);
    table.add("elastic-bends-ends" + on, what + "the reef over the grief knot", force[0] / force[3], "ratio", 1,
              Must::be_at_least);
}

// Two that hold what the thread bears are equal, whatever their last thousandth.
double held_of(const Pulled& pulled) {
    return std::min(pulled.share, 0.99);
}

// In polypropylene; a loop of it with a tenth of a newton on either tail.
void add_throws(Table& table, double friction, bool quick) {
    const std::string on = "-mu" + friction_digits(friction), mu = "friction " + friction_in(friction) + ": ";
    const BendPull pull{.friction = friction, .bending_share = 1, .tails = 0.1};
    const Bend square{"square knot of 2 throws", true, false}, granny{"granny knot of 2 throws", false, false},
        four{"square knot of 4 throws", true, false, 4};
    const Pulled two = table.pulled("elastic-loop-square-2" + on, square, pull),
                 slipping = table.pulled("elastic-loop-granny-2" + on, granny, pull);
    table.add("elastic-loop-order" + on, "elastic loops of 2 throws, " + mu + "the square over the granny knot",
              held_of(two) / held_of(slipping), "ratio", 1, Must::be_at_least);
    if (quick) return;
    const Pulled held = table.pulled("elastic-loop-square-4" + on, four, pull);
    table.add("elastic-loop-holds-4" + on,
              "elastic square knot of 4 throws, " + mu + "share that it carries of what the thread bears", held.share,
              "ratio", 0.99, Must::be_at_least);
}

// Where two throws slip under less than a fifth of what the thread bears and four hold all of it.
void add_more_throws(Table& table) {
    const BendPull pull{.friction = 0.12, .bending_share = 1, .tails = 0.1};
    const Pulled two = table.pulled("elastic-loop-square-2-mu12", {"square knot of 2 throws", true, false}, pull);
    const Pulled four = table.pulled("elastic-loop-square-4-mu12", {"square knot of 4 throws", true, false, 4}, pull);
    table.add("elastic-loop-slips-2-mu12",
              "elastic square knot of 2 throws, friction 0.12: share that it carries of what the thread bears",
              two.share, "ratio", 0.5);
    table.add("elastic-loop-holds-4-mu12",
              "elastic square knot of 4 throws, friction 0.12: share that it carries of what the thread bears",
              four.share, "ratio", 0.99, Must::be_at_least);
}

// The same loops pulled with B/D^2, tails free in the end, at the highest friction.
void add_let_go(Table& table, bool quick) {
    constexpr double set = 3;  // [D] that a knot may give before it holds
    const auto add = [&](const char* id, const Bend& bend, std::optional<double> bound) {
        const double begin = processor_time();
        const LetGo found = let_go(bend, {.friction = 0.3, .bending_share = 1, .tails = 1});
        table
            .add(id,
                 std::string("elastic ") + bend.words +
                     ", friction 0.3, pulled with B/D^2: its tails, let go of, run in by",
                 found.run_in, "D", bound)
            .seconds = processor_time() - begin;
    };
    add("elastic-loop-let-go-square-2", {"square knot of 2 throws", true, false}, {});
    add("elastic-loop-let-go-granny-2", {"granny knot of 2 throws", false, false}, {});
    if (!quick) add("elastic-loop-let-go-square-4", {"square knot of 4 throws", true, false, 4}, set);
}

}  // namespace

std::vector<Row> bend_rows(bool quick) {
    Table table;
    if (quick) table.runs = 1;
    for (const double friction : quick ? std::vector{0.2} : std::vector{0.1, 0.2, 0.3}) add_ranking(table, friction, 1);
    if (!quick)
        for (const double link : {1.4, 0.7}) add_ranking(table, 0.2, link);
    for (const double friction : quick ? std::vector{0.2} : std::vector{0.1, 0.2, 0.3})
        add_throws(table, friction, quick);
    if (!quick) add_more_throws(table);
    add_let_go(table, quick);
    table.add("elastic-bend-passes", "elastic bends and loops: pass-throughs", table.passes, "count", 0);
    return table.rows;
}

}  // namespace bench::lab
