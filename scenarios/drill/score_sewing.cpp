#include "scenarios/drill/score_sewing.hpp"

#include <algorithm>

#include "scenarios/drill/judged.hpp"

namespace scenarios::drill {

void score_needle(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items) {
    const auto& least = measures.needle_deg;
    if (!least && !drill.bands.needle_deg) return;
    const std::string name = "needle_angle", title = "Needle held, jaws to wire at the least";
    if (!least)
        return items.push_back({name, title, "never", "degrees", in_words(*drill.bands.needle_deg), false,
                                measures.duration_s, "The needle was never held."});
    items.push_back(
        judged({name, title, "degrees", least->value, 0, least->at_s, "The needle was held squarer than asked.",
                "The needle was held askew: a real one turns in the jaws as it meets the wall. Close them square to "
                "its wire."},
               drill.bands.needle_deg));
}

static std::string fault_of(const world::BiteMeasure& bite) {
    if (bite.withdrawn)
        return "The needle was drawn back out of the wall by the way it came. Follow its curve through it.";
    if (bite.to.empty())
        return "The needle went into the wall and not through it. Follow its curve until the tip is out.";
    if (bite.partial)
        return "The stitch does not go through the whole wall: it holds less, and leaves an edge in the lumen.";
    if (bite.both_walls)
        return "The needle took the wall across as well, which shuts the lumen. Keep its tip in sight.";
    if (bite.on_needle) return "The needle is still in the wall: draw it through, and the thread after it.";
    if (bite.is_empty)
        return "No thread is in it: it was drawn out of the wall again, or is too short. Keep its tail in sight.";
    if (bite.torn) return "The stitch was torn out to the cut. Pull in the direction of the stitch, and less.";
    return "";
}

// A wall that nobody holds folds under a needle before it is pierced, which a look at the stitch does not show.
static const char* advice_on(const world::BiteMeasure& bite) {
    return bite.caved_in ? "The wall caved in and the needle was through before it pressed as piercing takes: hold the "
                           "wall beside it."
                         : "";
}

static std::string why_too_few(const Drill& drill, const world::Measures& measures) {
    const bool is_missing = static_cast<double>(measures.bites.size()) < drill.bands.bites->low;
    const bool was_bitten = std::any_of(measures.bites.begin(), measures.bites.end(),
                                        [&](const auto& bite) { return bite.vessel == measures.slipped; });
    if (is_missing && !was_bitten && !measures.slipped.empty())
        return "The needle slipped off the edge of " + measures.slipped + " at " + fixed(measures.slipped_s, 2) +
               " s: bite farther from it, or hold the edge.";
    if (measures.bites.empty())
        return "No wall was pierced: hold the needle, follow its curve through each, and hold a wall that gives way to "
               "it.";
    return "Bites are missing, or do not hold: see them one by one.";
}

void score_bites(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items) {
    double held = 0;
    for (std::size_t i = 0; i < measures.bites.size(); ++i) {
        const world::BiteMeasure& bite = measures.bites[i];
        const std::string number = std::to_string(i + 1), title = "Bite " + number + ", " + bite.vessel,
                          why = fault_of(bite);
        const double at_s = bite.at_s;
        held += why.empty();
        items.push_back({"bite_" + number, title, bite.from + " to " + (bite.to.empty() ? "nowhere" : bite.to), "",
                         "between outer and inner", why.empty(), at_s, why.empty() ? advice_on(bite) : why});
        if (bite.size_mm == 0)
            items.push_back({"bite_size_" + number, title + ", from the cut", "none", "", "", true, at_s,
                             ""});  // it has no end outside
        else
            items.push_back(judged({"bite_size_" + number, title + ", from the cut", "mm", bite.size_mm, 2, at_s,
                                    "The bite is wider than asked: it folds the edge in and narrows the lumen.",
                                    "The bite is nearer to the cut than asked, where the wall bears less."},
                                   drill.bands.bite_mm));
        items.push_back(judged({"bite_angle_" + number, title + ", needle to wall", "degrees", bite.to_wall_deg, 0,
                                at_s, "The needle met the wall straighter than asked.",
                                "The needle met the wall aslant. Turn its tip straight at the wall before it bites."},
                               drill.bands.bite_deg));
    }
    if (!drill.bands.bites) return;
    items.push_back(judged({"bites", "Bites, each through one whole wall", "", held, 0, measures.duration_s,
                            "More bites than needed: each weakens the wall.", why_too_few(drill, measures)},
                           drill.bands.bites));
}

// Ends that clamps press together meet whether the suture holds them or not.
static void tell_clamps(const Drill& drill, ScoreItem& gap) {
    const auto& vessels = drill.world.vessels;
    const auto held =
        std::find_if(vessels.begin(), vessels.end(), [](const auto& vessel) { return vessel.held_by >= 0; });
    if (held == vessels.end()) return;
    const std::string clamps = "The clamps of " + drill.world.instruments[static_cast<std::size_t>(held->held_by)].name;
    gap.why +=
        (gap.why.empty() ? "" : " ") + clamps + " still hold the ends, sutured or not: the join is measured in them.";
}

void score_join(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items) {
    const world::JoinMeasure& join = measures.join;
    const Bands& bands = drill.bands;
    const double at_s = measures.duration_s;
    if (join.lapses.empty()) {
        if (bands.gap_mm || bands.lumen || bands.leak_mL_min || bands.lapses)
            items.push_back({"join", "Join", "none", "", "both ends sewn", false, at_s,
                             "There is no join to judge: no thread goes through a bite in each of the two ends."});
        return;
    }
    items.push_back(
        judged({"gap", "Widest gap of the suture line", "mm", join.gap_mm, 2, at_s,
                "The ends do not meet all round: bring them together before you tie, and space stitches evenly.",
                "The gap is narrower than asked."},
               bands.gap_mm));
    tell_clamps(drill, items.back());
    items.push_back(
        judged({"lumen", "Lumen, over what it was", "", join.lumen_ratio, 2, at_s, "The lumen is wider than asked.",
                "The join narrows the lumen: smaller bites, and pull until the edges meet, no more."},
               bands.lumen));
    items.push_back(judged({"leak", "Leak at 100 mmHg", "mL/min", join.leak_ml_min, 2, at_s,
                            "The join leaks more than allowed, through its gaps and about its threads.",
                            "The join leaks less than asked."},
                           bands.leak_mL_min));
    int committed = 0;
    std::string named;
    for (const world::LapseMeasure& lapse : join.lapses)
        if (lapse.committed) named += (committed++ ? ", " : "") + lapse.name;
    items.push_back(judged({"lapses", "Lapses, of ten", "", static_cast<double>(committed), 0, at_s,
                            "There are more lapses than allowed: " + named + ".", "There are fewer lapses than asked."},
                           bands.lapses));
    for (const world::LapseMeasure& lapse : join.lapses) {
        const std::string number = lapse.measure + ": " + fixed(lapse.value, 2) +
                                   (lapse.at_least ? "; at least " : "; at most ") + fixed(lapse.limit, 2) + ".";
        items.push_back({"lapse: " + lapse.name, "Lapse: " + lapse.name, lapse.committed ? "yes" : "no", "", "", true,
                         at_s, number, number_or_none(lapse.value)});
    }
}

}  // namespace scenarios::drill
