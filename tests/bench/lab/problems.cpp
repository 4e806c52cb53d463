#include "tests/bench/lab/problems.hpp"

#include <cmath>
#include <numbers>

#include "sim/thread/thread.hpp"
#include "tests/bench/lab/bends.hpp"
#include "tests/bench/lab/cantilever.hpp"
#include "tests/bench/lab/capstan.hpp"
#include "tests/bench/lab/laws.hpp"
#include "tests/bench/lab/loose_overhand.hpp"
#include "tests/bench/lab/rod_capstan.hpp"
#include "tests/bench/lab/tight_elastic.hpp"

namespace bench::lab {

namespace {

// Either thread goes round the cylinder at its own distance from the axis, in diameters. A thread of ftl that hangs
// instead of sliding shows no ratio: 1.
Compared round_cylinder(double wrap, const Setting& s, Cost& cost) {
    constexpr double friction = 0.2, elastic_out = 5.5, ftl_out = 5;
    if (s.elastic) return elastic_capstan(friction, wrap, s.link / elastic_out, s.tick, cost);
    const Capstan found = capstan({wrap, friction, s.tick, s.link});
    cost = found.cost;
    return {std::pow(capstan_of_nodes(friction, wrap, s.link / ftl_out), found.ratio), std::exp(friction * wrap)};
}

// An ideal rope takes up 10.1 D (surgery-and-physics.md, D11). Either end goes out by 25 D a second, for ftl in ticks
// as long as a tick's way.
Compared tight_overhand(const Setting& s, Cost& cost) {
    constexpr double ideal = 10.1, friction = 0.15, length = 100, speed = 25 * 2 * sim::thread::ThreadDef{}.radius,
                     ftl_tick = 1e-3;
    if (s.elastic) {
        const TightElastic found = tight_elastic(s.link, friction, s.tick);
        cost = found.cost;
        return {found.in_the_end, ideal};
    }
    const Tight found = tight(s.link, friction, speed * s.tick / ftl_tick, length);
    cost = found.cost;
    return {found.in_the_end, ideal};
}

// A loop so large that the law, of the first order in eps, is right to some percent.
Compared loose_overhand(double friction, const Setting& s, Cost& cost) {
    const LooseOverhand knot{
        .loop = 480, .links = static_cast<int>(s.link), .friction = friction, .tick = s.tick, .elastic = s.elastic};
    return {drawn_with(knot, cost), knot.law()};
}

// Loops of two throws in polypropylene. No theory knows the forces, but that the square knot holds better.
Compared square_over_granny(double friction, const Setting& s, Cost& cost) {
    const BendPull pull{
        .friction = friction, .bending_share = 1, .tails = 0.1, .link = s.link, .tick = s.tick, .elastic = s.elastic};
    const Pulled square = pull_bend({"square knot", true, false}, pull),
                 granny = pull_bend({"granny knot", false, false}, pull);
    cost = square.cost;
    return {square.force / granny.force, 1};
}

const std::string lengths = "length in D", count = "number", round_loop = "number round the loop";
const std::vector ticks{4e-3, 1e-3, 0.25e-3}, two_ticks{4e-3, 1e-3};

std::vector<Problem> capstans() {
    using std::numbers::pi;
    const auto capstan_of = [](double wrap) {
        return [=](const Setting& s, Cost& cost) { return round_cylinder(wrap, s, cost); };
    };
    return {{"capstan-half",
             "capstan, half a turn, friction 0.2: ratio of pulls",
             lengths,
             {2, 1, 0.5},
             ticks,
             capstan_of(pi)},
            {"capstan-one",
             "capstan, one turn, friction 0.2: ratio of pulls",
             lengths,
             {2, 1, 0.5},
             ticks,
             capstan_of(2 * pi)}};
}

std::vector<Problem> single_rods() {
    return {{"cantilever", "cantilever, 10 B/L2 at its tip: drop of the tip", count, {20, 40, 80}, ticks, cantilever},
            {"helix",
             "twisted thread let in by 3 %, no twist at its grasps: steepest angle",
             count,
             {40, 80, 160},
             ticks,
             let_in}};
}

std::vector<Problem> overhands() {
    const auto loose = [](double friction) {
        return [=](const Setting& s, Cost& cost) { return loose_overhand(friction, s, cost); };
    };
    return {{"loose-overhand",
             "loose overhand of 480 radii, no friction: pull that draws it tight",
             round_loop,
             {60, 120, 240},
             ticks,
             loose(0)},
            {"rough-overhand",
             "loose overhand of 480 radii, friction 0.1: pull that draws it tight",
             round_loop,
             {60, 120, 240},
             ticks,
             loose(0.1)},
            {"tight-overhand",
             "tight overhand, friction 0.15: what it takes up",
             lengths,
             {1, 0.5, 0.25},
             ticks,
             tight_overhand}};
}

std::vector<Problem> bends() {
    const std::string slips = ": ratio of forces at which they slip";
    const auto knots = [](double friction) {
        return [=](const Setting& s, Cost& cost) { return square_over_granny(friction, s, cost); };
    };
    return {{"square-granny-mu1",
             "square over granny knot, friction 0.1" + slips,
             lengths,
             {1.4, 1, 0.7},
             two_ticks,
             knots(0.1),
             true},
            {"square-granny-mu2",
             "square over granny knot, friction 0.2" + slips,
             lengths,
             {1.4, 1, 0.7},
             two_ticks,
             knots(0.2),
             true}};
}

}  // namespace

std::vector<Problem> problems() {
    std::vector<Problem> all;
    for (const auto& some : {capstans(), single_rods(), overhands(), bends()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

std::vector<RodCase> still_problems() {
    std::vector<RodCase> found;
    for (RodCase& c : rod_cases())
        if (c.id == "ring-turn" || c.id == "helix-angle") found.push_back(std::move(c));
    return found;
}

}  // namespace bench::lab
