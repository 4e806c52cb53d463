#include "app/commands/effects.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "scenarios/drill/materials.hpp"

namespace app {

using scenarios::drill::Drill;
using scenarios::drill::Material;
using scenarios::drill::material_named;

namespace {

constexpr double g = 9.81;             ///< [m/s^2]
constexpr double handling_N = 0.02;    ///< Tension while a thread is moved about.
constexpr double slack_N = 1e-4;       ///< Tension of a loop that hangs free.
constexpr double tissue_pull_N = 0.1;  ///< Pull of a thread on a vessel while a throw is laid.
constexpr double retention_per_m =
    1.35 / 0.4e-3;                       ///< [N/m] Pull that tears a wall at a 2 mm bite, by its thickness [Konig2009].
constexpr double pressure_Pa = 13.33e3;  ///< 100 mmHg.

/// What the formulas need of a thread, in SI.
struct ThreadFigures {
    double length, diameter, weight_per_m, axial, bending, twisting, break_force, yield_strain;

    explicit ThreadFigures(const scenarios::world::ThreadDef& def) {
        const double area = std::numbers::pi / 4 * def.diameter * def.diameter;
        const Material& material = material_named(def.material);
        length = def.length;
        diameter = def.diameter;
        weight_per_m = def.density * area * g;
        axial = def.young_modulus * area;
        // A braid bends more easily than it stretches; a modulus set by hand keeps the ratio of its material.
        const double bending_modulus = def.young_modulus * material.bending_young_MPa / material.young_MPa;
        bending = bending_modulus * std::numbers::pi / 64 * std::pow(def.diameter, 4);
        twisting = bending / 1.35;  // round and isotropic, Poisson's ratio 0.35
        break_force = def.break_force;
        yield_strain = def.yield_strain > 0 ? def.yield_strain : 0.01 * material.yield_percent;
    }
};

template <typename... Values>
std::string text(const char* format, Values... values) {
    char line[400];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

// A cantilever's tail sags by w L^4 / (8 B), which over L is (L / L_g)^3 / 8 with L_g = (B / w)^(1/3), and no farther
// than it is long. A thread tied in the open with twice L_g of slack is one that needs it [SurgeryAndPhysics F1].
Effect gravity(const ThreadFigures& figures) {
    const double gravito_bending = std::cbrt(figures.bending / figures.weight_per_m),
                 ratio = figures.length / gravito_bending;
    const double one_percent = std::cbrt(0.08) * gravito_bending;
    const double sag = figures.weight_per_m * figures.length * figures.length / (8 * handling_N);
    return {"gravity",
            false,
            "L / (B / mg)^(1/3)",
            ratio,
            text("free tails over %.0f mm should sag by more than 1 %% of their length and stay straight; held at both "
                 "ends at "
                 "20 mN the whole length should sag %.2f mm",
                 one_percent * 1000, sag * 1000),
            "would cost \"gravity\" in the effects of an elastic thread, one addition per node",
            "sag of a free tail as long as the thread, share of its length, by the law of small sags",
            std::min(1.0, ratio * ratio * ratio / 8),
            2};
}

// A pulled thread rounds a corner over sqrt(B / T); where it bends, links may be halved.
Effect bending(const ThreadFigures& figures, const scenarios::world::ThreadDef& thread) {
    const double rounding = std::sqrt(figures.bending / handling_N), whole = figures.length / thread.links;
    const double link = thread.shortest_link > 0 ? std::min(whole, thread.shortest_link) : whole;
    return {"bending",
            false,
            "sqrt(B / T) / link",
            rounding / link,
            text("corners at 20 mN should be rounded over %.2f mm (a link is %.2f mm) and slack loops should spring "
                 "open; at "
                 "1 N it is %.3f mm",
                 rounding * 1000, link * 1000, std::sqrt(figures.bending) * 1000),
            "would cost \"model\": \"elastic\" in the drill's thread",
            "rounding of a corner at 20 mN, in mm",
            rounding * 1000,
            1};
}

// A pulled rod writhes into a loop at n = L sqrt(4 B T) / (2 pi C) turns [Greenhill].
Effect twist(const ThreadFigures& figures) {
    const auto turns = [&](double tension) {
        return figures.length * std::sqrt(4 * figures.bending * tension) / (2 * std::numbers::pi * figures.twisting);
    };
    return {"twist",
            false,
            "turns to writhe at 0.1 mN",
            turns(slack_N),
            text("none below %.1f turns of twist when slack (0.1 mN), %.0f when pulled (20 mN); an instrument tie adds "
                 "about one a "
                 "throw",
                 turns(slack_N), turns(handling_N)),
            "would cost one more unknown per link"};
}

// Of what every elastic thread does unless it is told not to.
std::string cost_of_switching_on(const char* effect, const scenarios::world::ThreadDef& thread) {
    if (thread.model == "elastic")
        return text("would cost \"%s\" in the effects, next to nothing beside the elastic thread itself", effect);
    return "would cost \"model\": \"elastic\" in the drill's thread";
}

Effect extension(const ThreadFigures& figures, const scenarios::world::ThreadDef& thread) {
    return {
        "extension",
        false,
        "T / EA at 20 mN",
        handling_N / figures.axial,
        text("the thread should be longer by %.2f %% in handling (20 mN) and by %.1f %% at its breaking load (%.2f N)",
             100 * handling_N / figures.axial, 100 * figures.break_force / figures.axial, figures.break_force),
        cost_of_switching_on("extension", thread),
        "strain at 20 mN",
        handling_N / figures.axial,
        0.01};
}

// About a strand of its own a thread's axis is bent to 1 / D and its outermost fibres are stretched by a half. Let go
// of it springs back by 16 / (3 pi) of what begins to yield (RodDef), and a thread that only bends springs straight.
Effect plastic_set(const ThreadFigures& figures) {
    if (figures.yield_strain == 0)
        return {"plastic_set",
                false,
                "1 / (2 yield strain)",
                0,
                "nothing is known of when this material yields; a braid's fibres slide instead",
                "costs nothing"};
    const double tight = 0.5, springs = 16 / (3 * std::numbers::pi) * figures.yield_strain;
    return {"plastic_set",
            false,
            "1 / (2 yield strain)",
            tight / figures.yield_strain,
            text("a throw bent about a strand of its own should keep %.0f %% of its bend, anything bent more sharply "
                 "than %.2f mm some of it; without it "
                 "a knot holds by friction alone",
                 100 * std::max(0.0, 1 - springs / tight), 500 * figures.diameter / springs),
            "would cost \"plastic_set\" in the effects of an elastic thread, one comparison per node",
            "share of its bend that a throw about a strand of its own keeps",
            std::max(0.0, 1 - springs / tight),
            1};
}

// The one that matters most: the thinnest of those that give way, or else of all.
const scenarios::world::VesselDef* weakest_vessel(const Drill& drill) {
    const scenarios::world::VesselDef* weakest = nullptr;
    for (const auto& vessel : drill.world.vessels) {
        if (!vessel.mesh_file.empty() && !vessel.is_soft) continue;
        const bool weaker = !weakest || vessel.is_soft > weakest->is_soft ||
                            (vessel.is_soft == weakest->is_soft && vessel.wall < weakest->wall);
        if (weaker) weakest = &vessel;
    }
    return weakest;
}

bool gives_way(const Drill& drill) {
    const auto* vessel = weakest_vessel(drill);
    return vessel && vessel->is_soft;
}

double wall_of(const Drill& drill) {
    constexpr double usual = 0.4e-3;  // of the pull above
    const auto* vessel = weakest_vessel(drill);
    return vessel ? vessel->wall : usual;
}

double retention_N(const Drill& drill) {
    return retention_per_m * wall_of(drill);
}

// Local strain of a wall pulled over 1 mm of width: F / (E t w).
Effect tissue(const Drill& drill) {
    const auto* vessel = weakest_vessel(drill);
    if (!vessel)
        return {"tissue",       false, "F / (E t w)", 0, "no vessel given by numbers, so nothing to estimate",
                "costs nothing"};
    const bool on = vessel->is_soft;
    const double strain = tissue_pull_N / (vessel->young_modulus * vessel->wall * 1e-3);
    return {"tissue",
            on,
            "F / (E t w) at 0.1 N, 1 mm",
            strain,
            text("a pull of 0.1 N should stretch %.1f mm of a wall of %.2f MPa by about %.0f %%; ", 1e3 * vessel->wall,
                 1e-6 * vessel->young_modulus, 100 * strain) +
                (on ? "the wall gives way" : "the rigid vessel does not give way, so judge knots here, not tissue"),
            on ? "0.3 ms, a step of one vessel a tick"
               : "would cost \"tissue\": \"elastic\" in the effects, a step of one vessel a tick"};
}

Effect tear(const Drill& drill, const ThreadFigures& figures) {
    const bool on = gives_way(drill);
    const double retention = retention_N(drill);
    return {"tear",
            on,
            "breaking load / retention",
            figures.break_force / retention,
            text("a %.1f mm wall should tear at about %.2f N at a 2 mm bite, %s; here %s", 1e3 * wall_of(drill),
                 retention, figures.break_force > retention ? "before this thread breaks" : "after this thread breaks",
                 on ? "each bite does by its own size" : "it never does"),
            on ? "a threshold per puncture" : "would cost a threshold per puncture"};
}

Effect leak(const Drill& drill) {
    double load = 0;
    for (const auto& vessel : drill.world.vessels)
        if (vessel.mesh_file.empty()) load = std::max(load, pressure_Pa * vessel.diameter / 4 * 1e-3);
    const bool on = gives_way(drill);
    return {"leak",
            on,
            "p R / 2 * 1 mm / retention",
            load / retention_N(drill),
            text("blood pressure (100 mmHg) should load a stitch each millimetre with %.4f N, %.1f %% of what tears it",
                 load, 100 * load / retention_N(drill)),
            on ? "one evaluation at the end" : "would cost one evaluation at the end"};
}

// A rope that slides around an angle keeps 1 / e^(mu angle) of its tension (capstan); a throw is about 2 pi.
Effect friction(const scenarios::world::ThreadDef& def) {
    const double factor = std::exp(def.friction * 2 * std::numbers::pi);
    return {"friction",
            true,
            "exp(mu 2 pi)",
            factor,
            text("always on: one throw holds %.1f times the pull on its tail; without it no knot holds", factor),
            "part of every contact"};
}

// Clamped, free end: f1 = 3.516 / (2 pi L^2) sqrt(B / m). Hands move at up to 2 Hz.
Effect inertia(const ThreadFigures& figures, const scenarios::world::ThreadDef& thread) {
    const double free_length = std::min(figures.length, 0.05);
    const double f1 = 3.516 / (2 * std::numbers::pi * free_length * free_length) *
                      std::sqrt(figures.bending * g / figures.weight_per_m);
    return {"inertia",
            false,
            "(f / f1)^2 at 2 Hz",
            4 / (f1 * f1),
            text("a free tail of %.0f mm should swing behind a hand at 2 Hz by %.1f %%", free_length * 1000,
                 400 / (f1 * f1)),
            cost_of_switching_on("inertia", thread),
            "lag of a free tail behind a hand at 2 Hz, share of its motion",
            4 / (f1 * f1),
            0.1};
}

// What is let go of goes v t (1 - exp(-s / t)) in s seconds, and without air v s.
Effect air(const scenarios::world::ThreadDef& def) {
    constexpr double speed_mm_s = 20;
    const double halts = scenarios::world::halting_time(def), goes = speed_mm_s * halts * (1 - std::exp(-1 / halts));
    return {"air",
            false,
            "1 s / halting time",
            1 / halts,
            text("what is loose of the thread and has inertia should be halted in %.3f s: let go of at %.0f mm/s it "
                 "should go %.1f mm in a second and not fly on",
                 halts, speed_mm_s, goes),
            "would cost \"air\" in the effects of an elastic thread, one product per node",
            "way too far in a second of what is let go of at 20 mm/s, in mm",
            speed_mm_s - goes};
}

bool is_on(const scenarios::world::ThreadDef& elastic, const std::string& effect) {
    return effect == "bending" || (effect == "gravity" && elastic.weighs) ||
           (effect == "extension" && elastic.stretches) || (effect == "plastic_set" && elastic.yield_strain > 0) ||
           (effect == "inertia" && elastic.swings) || (effect == "air" && elastic.is_in_air);
}

// An ftl thread takes none of these: it must become an elastic one, of which bending is always a part.
std::string remedy_of(const std::string& effect, bool elastic) {
    const std::string model = "\"model\": \"elastic\" in the thread", on = "\"" + effect + "\": true in the effects";
    if (effect == "bending") return model;
    return elastic ? on : on + " and " + model;
}

}  // namespace

std::vector<Effect> effects_of(const Drill& drill) {
    const ThreadFigures figures(drill.world.thread);
    std::vector<Effect> all{friction(drill.world.thread),
                            gravity(figures),
                            bending(figures, drill.world.thread),
                            twist(figures),
                            extension(figures, drill.world.thread),
                            plastic_set(figures),
                            tissue(drill),
                            tear(drill, figures),
                            leak(drill),
                            inertia(figures, drill.world.thread),
                            air(drill.world.thread)};
    const auto& thread = drill.world.thread;
    const bool elastic = thread.model == "elastic";
    for (Effect& effect : all) {
        // Where nothing springs back, nothing needs to stay; and what ties no knot has none to keep.
        if (effect.name == "plastic_set" && (!elastic || drill.goals.empty())) effect.needed_above.reset();
        if (!effect.on && effect.needed_above) effect.remedy = remedy_of(effect.name, elastic);
        if (!elastic || !is_on(thread, effect.name)) continue;
        effect.on = true;
        effect.error = "simulated by the elastic thread: " + effect.error;
        effect.cost = effect.name == "bending"
                          ? "the elastic thread: of 200 links 0.1 ms a tick when loose, 0.3 ms in an overhand knot"
                          : "nothing that could be told from timing beside the elastic thread itself: carrel bench "
                            "speed, effects";
    }
    return all;
}

}  // namespace app
