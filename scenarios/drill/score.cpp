#include "scenarios/drill/score.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scenarios/drill/judged.hpp"
#include "scenarios/drill/schema.hpp"
#include "scenarios/drill/score_sewing.hpp"
#include "scenarios/drill/tie.hpp"

namespace scenarios::drill {

namespace {

using sim::knot::Name;

// "surgeon's" is written without its apostrophe in drill files.
std::string tie_of(const Name& name) {
    std::string tie = name.surgical;
    std::erase(tie, '\'');
    return tie;
}

bool has_throws_asked(const Goal& goal, const Name& name) {
    return throws_asked(goal).empty() || name.throws == throws_asked(goal);
}

// Of how many throws is judged beside it. Three throws of a square knot are asked for as that, and are found by their
// throws alone.
bool is_asked(const Goal& goal, const Name& name) {
    return name.certain && (tie_of(name) == goal.tie || (!throws_asked(goal).empty() && has_throws_asked(goal, name)));
}

std::string in_words(const std::string& tie) {
    return tie == "surgeons" ? "surgeon's" : tie;
}

std::string as_found(const Name& name) {
    if (!name.surgical.empty()) return name.surgical;
    return name.knot == "0_1" ? "none" : name.knot;
}

struct Lesson {
    const char *asked, *tied, *why;
};

// What a teacher would say of the commonest exchanges.
constexpr Lesson lessons[] = {
    {"square", "granny",
     "The second throw went the same way round as the first: a granny, which slips. Reverse the second wrap."},
    {"square", "surgeons", "The first throw was wrapped twice: a surgeon's knot. Wrap once for a square knot."},
    {"square", "overhand",
     "There is only one throw, which will not hold. Add a second one, wrapped the other way round."},
    {"square", "slip",
     "One strand stayed straight, so the throws slide along it: a slip knot. Cross hands and pull both tails evenly."},
    {"granny", "square", "The second throw was reversed: a square knot. A granny repeats the same wrap."},
    {"granny", "overhand", "There is only one throw. Repeat the same wrap for a granny."},
    {"surgeons", "square",
     "The first throw was wrapped once: a square knot. Wrap twice in the first throw of a surgeon's knot."},
    {"surgeons", "granny",
     "The first throw was wrapped once and the second went the same way round: a granny, which slips. Wrap twice "
     "first, then once the other way round."},
    {"surgeons", "overhand",
     "There is only one throw. After the double wrap add a single one, wrapped the other way round."},
    {"overhand", "square", "There are two throws. An overhand knot is one."},
    {"overhand", "granny", "There are two throws. An overhand knot is one."},
};

// Where broke_s is known.
std::string how_it_broke(const world::Measures& measures) {
    return "The thread broke at " + fixed(*measures.broke_s, 2) + " s: it was pulled too hard, or caught.";
}

bool is_untied(const Name& name) {
    return name.knot == "0_1" && name.surgical.empty();
}

std::string why_not_tied(const Goal& goal, const Name& found) {
    const std::string& asked = goal.tie;
    if (is_untied(found) && is_hitch(asked)) return "The thread is not hitched to any vessel.";
    if (is_hitch(asked) || is_hitch(found.surgical))
        return "The thread is tied another way: " + found.surgical + ", not " + asked + ".";
    if (is_untied(found)) return "There is no knot in the thread: the throw was not pulled through, or came undone.";
    for (const Lesson& lesson : lessons)
        if (asked == lesson.asked && tie_of(found) == lesson.tied) return lesson.why;
    if (!found.certain)
        return "The knot could not be named with certainty. Tie the throws one at a time and pull each flat.";
    return "The thread is tied in another knot than the " + in_words(asked) +
           " knot asked for. Tie the throws one at a time.";
}

void score_knot(const Goal& goal, const world::Measures& measures, std::vector<ScoreItem>& items) {
    const Name& name = measures.knot;
    ScoreItem item{"knot", "Knot", as_found(name), "", in_words(goal.tie), is_asked(goal, name), measures.knot_since_s,
                   ""};
    if (!item.passed)
        item.why = is_untied(name) && measures.broke_s
                       ? how_it_broke(measures) + " There is no knot in what is left of it."
                       : why_not_tied(goal, name);
    items.push_back(item);
}

void score_throws(const Goal& goal, const world::Measures& measures, std::vector<ScoreItem>& items) {
    if (goal.throws == 0 && goal.notation.empty()) return;
    const std::string& found = measures.knot.throws;
    const int count = throw_count(found);
    ScoreItem item{"throws", "Throws", "", "", "", false, measures.knot_since_s, "", count};
    if (!goal.notation.empty()) {
        item.value = found.empty() ? "none" : found;
        item.band = goal.notation;
        item.passed = found == goal.notation;
        item.why = "The throws are " + item.value + ", asked were " + goal.notation +
                   ": digits count wraps, '=' is a reversed throw, 'x' one the same way round.";
    } else {
        item.value = std::to_string(count);
        item.band = std::to_string(goal.throws);
        item.passed = count == goal.throws;
        item.why = count < goal.throws ? "Throws are missing: a monofilament unties with too few."
                                       : "There are more throws than asked: they add bulk, not strength.";
    }
    if (item.passed) item.why.clear();
    items.push_back(item);
}

constexpr const char* no_knot_to_judge = "There is no knot to judge.";

void score_tails(const Goal& goal, const world::Measures& measures, std::vector<ScoreItem>& items) {
    if (!goal.tails_mm) return;
    const std::vector<double> none = {0, 0};
    const auto& tails = measures.tail_mm.empty() ? none : measures.tail_mm;
    const auto [shorter, longer] = std::minmax_element(tails.begin(), tails.end());
    const std::string too_long = "The tail is longer than asked. Cut it, or start with less thread on this side.";
    const std::string too_short =
        is_untied(measures.knot)
            ? no_knot_to_judge
            : "The tail is too short: a knot that slips a little runs off it. Leave more thread on this side.";
    items.push_back(judged(
        {"tail_short", "Shorter tail", "mm", *shorter, 2, measures.knot_since_s, too_long, too_short}, goal.tails_mm));
    items.push_back(judged({"tail_long", "Longer tail", "mm", *longer, 2, measures.knot_since_s, too_long, too_short},
                           goal.tails_mm));
}

// Of one of several knots that are asked for.
bool is_tied(const Goal& goal, const Name& name) {
    return is_asked(goal, name) && has_throws_asked(goal, name);
}

std::string with_throws(const Name& name) {
    return as_found(name) + (name.throws.empty() ? "" : " (" + name.throws + ")");
}

std::string found_in(const std::vector<world::TieMeasure>& ties) {
    std::string found;
    for (const world::TieMeasure& tie : ties) found += (found.empty() ? "" : ", ") + with_throws(tie.knot);
    return found.empty() ? "No thread is tied." : "The threads that are tied: " + found + ".";
}

struct Stitches {
    double tied = 0, cut = 0;
    std::string wrong_tails;
};

Stitches stitches_of(const Goal& goal, const std::vector<world::TieMeasure>& ties) {
    Stitches found;
    for (const world::TieMeasure& tie : ties) {
        if (!is_tied(goal, tie.knot)) continue;
        ++found.tied;
        if (!goal.tails_mm) continue;
        const double one = tie.tail_mm[0], other = tie.tail_mm[1];
        if (goal.tails_mm->holds(one) && goal.tails_mm->holds(other))
            ++found.cut;
        else
            found.wrong_tails += (found.wrong_tails.empty() ? "" : ", ") + fixed(one, 2) + " and " + fixed(other, 2);
    }
    return found;
}

std::string why_not_cut(const Stitches& found) {
    if (found.tied == 0) return no_knot_to_judge;
    if (found.wrong_tails.empty()) return "Knots are missing; the tails of those that are tied are right.";
    return "Cut each stitch alike: tails of " + found.wrong_tails + " mm.";
}

// Stitches that are each tied.
void score_ties(const Goal& goal, const world::Measures& measures, std::vector<ScoreItem>& items) {
    const Stitches stitches = stitches_of(goal, measures.ties);
    const Band asked{static_cast<double>(goal.times), static_cast<double>(goal.times)};
    const auto count = [&](const char* name, const std::string& title, double found, const std::string& too_few) {
        items.push_back(
            judged({name, title, "", found, 0, measures.duration_s, "There are more than asked.", too_few}, asked));
    };
    const std::string knots =
        goal.notation.empty() ? in_words(goal.tie) + " knots" : in_words(goal.tie) + " knots (" + goal.notation + ")";
    count("knots", "Pieces of thread tied in " + knots, stitches.tied, found_in(measures.ties));
    if (goal.tails_mm)
        count("tails", "Of these, both tails in " + in_words(*goal.tails_mm) + " mm", stitches.cut,
              why_not_cut(stitches));
    int number = 0;  // shown, not judged
    for (const world::TieMeasure& tie : measures.ties)
        items.push_back({"tails_" + std::to_string(++number), "Tails of " + with_throws(tie.knot),
                         fixed(tie.tail_mm[0], 2) + " and " + fixed(tie.tail_mm[1], 2), "mm", "", true,
                         measures.duration_s, ""});
}

void score_around(const Goal& goal, const world::Measures& measures, std::vector<ScoreItem>& items) {
    if (goal.around.empty()) return;
    const auto& found = measures.around;
    ScoreItem item{"around",
                   "Tied around",
                   found.empty() ? "nothing" : found.front(),
                   "",
                   goal.around,
                   std::find(found.begin(), found.end(), goal.around) != found.end(),
                   measures.knot_since_s,
                   ""};
    if (!item.passed)
        item.why = is_untied(measures.knot) ? no_knot_to_judge
                                            : "The loop below the knot does not go round the " + goal.around + ".";
    items.push_back(item);
}

// Shown, not judged.
void score_lie(const world::Measures& measures, std::vector<ScoreItem>& items) {
    if (measures.knot.factors.empty()) return;
    const auto show = [&](const char* name, const char* title, double mm) {
        items.push_back(judged({name, title, "mm", mm, 2, measures.knot_since_s, "", ""}, {}));
    };
    if (!measures.knot.throw_list.empty())
        items.push_back(
            {"form", "How it lies", measures.knot.flat ? "flat" : "capsized", "", "", true, measures.knot_since_s, ""});
    show("loop", "Thread in the loop", measures.loop_mm);
    show("knot_thread", "Thread in the knot", measures.knot_mm);
    if (measures.off_tissue_mm >= 0) show("off_tissue", "Knot off the vessel", measures.off_tissue_mm);
}

void score_tools(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items) {
    const auto& tools = drill.world.instruments;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const std::string& tool = tools[i].name;
        items.push_back(
            judged({"path_" + tool, "Path length, " + tool + " tool", "mm", measures.path_mm[i], 1, measures.duration_s,
                    "The tool travelled further than needed. Plan each move and keep the tip near its work.",
                    "The tool travelled less than asked."},
                   drill.bands.path_mm[i]));
    }
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const std::string& tool = tools[i].name;
        items.push_back(judged(
            {"grasps_" + tool, "Grasps, " + tool + " tool", "", static_cast<double>(measures.grasps[i]), 0,
             measures.duration_s,
             "The thread was grasped more often than needed, and each grasp bruises it. Place the jaws once and close.",
             "The thread was grasped less often than asked."},
            drill.bands.grasps[i]));
    }
}

void score_lag(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items) {
    for (std::size_t i = 0; i < drill.world.instruments.size(); ++i) {
        const std::string& tool = drill.world.instruments[i].name;
        items.push_back(judged({"lag_" + tool, "Pull beyond a taut thread, " + tool + " tool", "mm",
                                measures.lag_max_mm[i].value, 2, measures.lag_max_mm[i].at_s,
                                "The hand went on pulling after the thread was taut. Stop when the slack is gone.",
                                "The thread was never pulled taut, so that what is tied is loose."},
                               drill.bands.lag_mm[i]));
    }
}

void score_walls(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items) {
    const auto gives_way = [](const world::VesselDef& vessel) { return vessel.is_soft; };
    if (std::ranges::none_of(drill.world.vessels, gives_way)) return;
    items.push_back(judged({"walls_crossed", "Walls crossed by tools", "", static_cast<double>(measures.walls_crossed),
                            0, measures.first_crossed_s,
                            "A tool was led through a vessel's wall. Go round the vessel, and look where the shaft is.",
                            "Fewer walls were crossed than asked."},
                           drill.bands.walls_crossed));
}

// What ends by itself ends before its limit.
void score_time(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items) {
    ScoreItem item = judged({"time", "Time", "s", measures.duration_s, 1, measures.duration_s,
                             "The drill took longer than allowed.", "The drill was over sooner than asked."},
                            drill.bands.time_s ? *drill.bands.time_s : Band{0, drill.time_limit_s});
    if (measures.duration_s > drill.time_limit_s - 0.5 * drill.world.tick_s)
        item.passed = false, item.why = "The time limit ended the drill.";
    items.push_back(item);
}

}  // namespace

std::vector<ScoreItem> score(const Drill& drill, const world::Measures& measures) {
    const std::size_t tools = drill.world.instruments.size();
    assert(measures.path_mm.size() == tools && measures.grasps.size() == tools && measures.lag_max_mm.size() == tools &&
           "one measure per instrument");
    std::vector<ScoreItem> items;
    for (const Goal& goal : drill.goals) {
        if (goal.times > 1) {
            score_ties(goal, measures, items);
            continue;
        }
        score_knot(goal, measures, items);
        score_throws(goal, measures, items);
        score_tails(goal, measures, items);
        score_around(goal, measures, items);
    }
    score_lie(measures, items);
    score_needle(drill, measures, items);
    score_bites(drill, measures, items);
    score_join(drill, measures, items);
    score_time(drill, measures, items);
    score_tools(drill, measures, items);
    if (measures.broke_s)
        items.push_back(
            {"broke", "Thread broke", "yes", "", "never", false, *measures.broke_s, how_it_broke(measures)});
    const std::string too_hard = measures.broke_s
                                     ? how_it_broke(measures)
                                     : "The thread was pulled harder than allowed, which breaks it or cuts the vessel. "
                                       "Pull evenly and stop when the throw is flat, or the edges meet.";
    items.push_back(
        judged({"tension", "Largest tension", "N", measures.tension_max_N.value, 2, measures.tension_max_N.at_s,
                too_hard, "The thread was never pulled tight, so that what is tied is loose."},
               drill.bands.tension_N));
    score_lag(drill, measures, items);
    score_walls(drill, measures, items);
    items.push_back(judged({"pass_throughs", "Pass-throughs", "", static_cast<double>(measures.pass_throughs), 0,
                            measures.first_pass_through_s,
                            "The simulated thread passed through something solid: the fault is the simulator's and "
                            "this session does not count.",
                            ""},
                           drill.bands.pass_throughs));
    return items;
}

}  // namespace scenarios::drill
