#include "scenarios/drill/keys.hpp"

#include <cmath>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/materials.hpp"
#include "scenarios/drill/needles.hpp"

namespace scenarios::drill {

namespace {

// What files leave out is as these have it.
const world::ThreadDef default_thread;
const world::VesselDef default_vessel;

// A whole number is written as one: 90, not 90.0.
json plain(double value) {
    return value == std::round(value) ? json(static_cast<std::int64_t>(value)) : json(value);
}

json plain(const world::Vec3& v) {
    return {plain(v.x()), plain(v.y()), plain(v.z())};
}

Schema quantity(const std::string& about, double low, double high, const std::string& unit = "") {
    return {.types = number, .about = about, .low = low, .high = high, .unit = unit};
}

Schema count(const std::string& about, double low, double high) {
    return {.types = integer, .about = about, .low = low, .high = high};
}

Schema words(const std::string& about) {
    return {.types = text, .about = about};
}

Schema choice(const std::string& about, std::vector<json> choices, const std::string& why_only = "") {
    return {.types = text, .about = about, .choices = std::move(choices), .why_only = why_only};
}

Schema list(const std::string& about, std::size_t min_items, std::size_t max_items, Schema item) {
    return {.types = array, .about = about, .min_items = min_items, .max_items = max_items, .items = {std::move(item)}};
}

Schema group(const std::string& about, std::vector<Key> keys) {
    return {.types = object, .about = about, .keys = std::move(keys)};
}

// Names join drill, motion and report, where they stand between commas and in file names.
Schema name(const std::string& about) {
    return {.types = text,
            .about = about,
            .pattern = "^[A-Za-z][A-Za-z0-9_-]{0,39}$",
            .pattern_words = "a letter and up to 39 letters, digits, '_' or '-'"};
}

Schema point(const std::string& about) {
    return list(about, 3, 3, quantity("x, y or z in the world.", -1000, 1000, "mm"));
}

// To a micron.
std::string in_mm(double metres) {
    return shown(std::round(1e6 * metres) / 1e3);
}

template <typename Table>
std::vector<json> names_of(const Table& table) {
    std::vector<json> names;
    for (const auto& entry : table) names.push_back(entry.name);
    return names;
}

// [low, high] or {"max": high}.
Schema band_of(const std::string& about, Schema end) {
    end.about = "End of the band; the lower is 0 where it is not given.";
    return {.types = array | object,
            .types_words = "[low, high] or {\"max\": high}",
            .about = about + " Passes inside [low, high], or at most {\"max\": high}.",
            .min_items = 2,
            .max_items = 2,
            .items = {end},
            .keys = {{"max", end, true}}};
}

Schema band(const std::string& about, double high, const std::string& unit) {
    return band_of(about, quantity("", 0, high, unit));
}

Schema band_of_counts(const std::string& about, double high) {
    return band_of(about, count("", 0, high));
}

Schema per_instrument(const std::string& about, const Schema& one) {
    return {.types = object, .about = about + " Keyed by instrument.", .other_keys = {one}};
}

Schema direction(const std::string& about) {
    return list(about + ", any length but zero.", 3, 3, quantity("Component.", -1000, 1000));
}

// "BV-1: 3/8 circle, 9.3 mm, wire 0.2 mm."
std::string dimensions() {
    std::string all;
    for (const NeedleCode& code : needle_codes())
        all += (all.empty() ? "" : "; ") + std::string(code.name) + ": " + shown(8 * code.circle) + "/8 circle, " +
               in_mm(code.length) + " mm, wire " + in_mm(code.wire) + " mm";
    return all + ".";
}

std::vector<Key> place_of_needle() {
    return {{"tail_mm", point("Where its tail is at the start."), true},
            {"towards", direction("From there to its tip"), true},
            {"bulge", direction("To which side of that line its curve lies"), true}};
}

Schema needle() {
    std::vector<Key> keys = place_of_needle();
    keys.insert(keys.begin(), {"code", choice("As makers name it. " + dimensions(), names_of(needle_codes())), true});
    return group(
        "A curved needle swaged to the thread, which starts at its tail; start_mm then goes on from behind it. Jaws "
        "that are closed on it at the "
        "start hold it.",
        keys);
}

Schema start() {
    return list(
        "Path of the thread at the start, at least length_mm long; what is longer is cut off. An elastic one keeps its "
        "bends: a sharp one behind a needle catches in walls.",
        2, 2000, point("A corner of the path."));
}

Schema spares() {
    const Schema spare = group("Such a thread.", {{"needle", group("Where its needle is.", place_of_needle()), true},
                                                  {"start_mm", start(), true}});
    return list("More threads like this one, with such needles, that lie ready for when it is used up.", 0, 15, spare);
}

Schema thread() {
    // The lower bound of the diameter is that of 11-0. Links shorter than a diameter would be their own neighbours'
    // contacts; the loader checks that apart. 5000 links are 0.2 mm each at a metre.
    return group(
        "The suture. Numbers given here win over those of size and material.",
        {{"size", choice("USP size; gives diameter_mm and break_N.", names_of(sizes())), false, default_thread.size},
         {"material", choice("Gives young_MPa and density_kg_m3.", names_of(materials())), false,
          default_thread.material},
         {"length_mm", quantity("Length at rest.", 5, 1000, "mm"), true},
         {"diameter_mm", quantity("Thickness.", 0.01, 1, "mm")},
         {"young_MPa", quantity("Young's modulus along the thread.", 1, 300000, "MPa")},
         {"density_kg_m3", quantity("Density.", 500, 20000, "kg/m^3")},
         {"break_N", quantity("Tension at which a knotted thread breaks.", 0.01, 200, "N")},
         {"friction", quantity("Coulomb coefficient, thread on thread and on vessels.", 0, 2), false,
          default_thread.friction},
         {"friction_tool", quantity("Coulomb coefficient, thread on tools.", 0, 2), false,
          default_thread.friction_tool},
         {"yield_percent",
          quantity("Strain beyond which it stays as it is bent, where effects has plastic_set.", 0.1, 100, "%")},
         {"links", count("Straight pieces the thread is cut into. Default: " + std::to_string(default_thread.links) +
                             ", of a short one as many as are two diameter_mm long.",
                         2, 5000)},
         {"shortest_link_mm", quantity("Where the thread bends or touches itself links are halved, down to this, and "
                                       "joined again where it is straight; 0: never. "
                                       "Default: diameter_mm.",
                                       0, 1000, "mm")},
         {"contacts_per_tick",
          count("Of an elastic thread: a tick that has solved so many leaves the rest of the tools' motion to the "
                "next, so that none takes long; 0: never.",
                0, 100000),
          false, default_thread.contacts_per_tick},
         {"model",
          choice("What moves the thread: ftl, by its geometry alone; elastic, a rod that bends and stretches by its "
                 "material.",
                 {"ftl", "elastic"}),
          false, default_thread.model},
         {"start_mm", start(), false},
         {"needle", needle(), false},
         {"spares", spares(), false}});
}

Schema vessel() {
    const Schema tube = group(
        "A tube by numbers.",
        {{"diameter_mm", quantity("Outer diameter.", 0.3, 60, "mm"), true},
         {"wall_mm", quantity("Thickness of the wall.", 0.02, 5, "mm"), true},
         {"length_mm", quantity("Length.", 1, 500, "mm"), true},
         {"cut_angle_deg", quantity("Between its axis and the cut at an end that no clamp holds.", 45, 90, "degrees"),
          false, plain(default_vessel.cut_angle)}});
    const Schema hash = {.types = text,
                         .about = "SHA-256 of the file.",
                         .pattern = "^[0-9a-f]{64}$",
                         .pattern_words = "64 hex digits, lower case"};
    const Schema mesh = group(
        "A triangle mesh written in mm: the surface of a rigid vessel, or the outside of one that gives way; closed, "
        "or "
        "open at its ends.",
        {{"file", words("Path from the drill file: .obj, .ply or .stl."), true},
         {"sha256", hash, true},
         {"wall_mm", quantity("Thickness of a wall that gives way, inwards from the mesh.", 0.02, 5, "mm")}});
    Schema schema = group(
        "A vessel. Rigid, or where effects has tissue a wall that gives way, held where clamps hold it; a tube is cut "
        "where none does.",
        {{"name", name("How goals call it."), true},
         {"tube", tube},
         {"mesh", mesh},
         {"centre_mm", point("Middle of a tube; of a mesh where the origin of its file comes."), false,
          plain(world::Vec3(1e3 * default_vessel.centre))},
         {"axis",
          list("Direction of a tube, and of a mesh made along x; any length but zero.", 3, 3,
               quantity("Component.", -1000, 1000)),
          false, plain(default_vessel.axis)},
         {"held", list("Ends that a clamp holds.", 0, 2, choice("An end.", {"start", "end"})), false,
          json::array({"start", "end"})},
         {"held_by", name("Approximator whose clamps these are. Without it they stay where they are.")},
         {"young_MPa", quantity("Young's modulus of a wall that gives way.", 0.001, 10, "MPa"), false,
          default_vessel.young_modulus / 1e6},
         {"puncture_N", quantity("Force at which a needle goes through a wall that gives way.", 0.001, 10, "N"), false,
          default_vessel.puncture_force}});
    schema.one_of = {"tube", "mesh"};
    return schema;
}

Schema instrument() {
    return group("A tool.",
                 {{"name", name("As in motion files."), true},
                  {"kind",
                   choice("What it is. Scissors cut what they close on. An approximator brings the vessels together "
                          "that it holds, in its x, by closing; it grasps nothing else.",
                          {"forceps", "needle_holder", "scissors", "approximator"}),
                   true},
                  {"pull_N", quantity("How hard it pulls at an elastic thread: to what pulls harder it gives way, as a "
                                      "hand does that feels it. Default: as hard as the thread bears.",
                                      0.01, 100, "N")}});
}

Schema effects() {
    const std::string only = "this version cannot simulate more, ";
    const auto flag = [](const std::string& about) { return Schema{.types = boolean, .about = about}; };
    std::vector<Key> keys{
        {"gravity", flag("Weight of an elastic thread, towards -z; it falls where no tool and no vessel holds it."),
         false, default_thread.weighs},
        {"bending", flag("Stiffness against bending. Default: as the thread's model has it, ftl off and elastic on.")},
        {"extension",
         flag("Stretch of the thread by its material; off, it stretches by next to nothing. Default: elastic on.")},
        {"plastic_set", flag("An elastic thread that is bent beyond yield_percent stays bent."), false,
         default_thread.yield_strain > 0},
        {"inertia", flag("Mass of the thread; off, it is in balance in every tick. Default: elastic on.")},
        {"air", flag("Drag of the air, which halts what of an elastic thread is loose; off, that flies on."), false,
         default_thread.is_in_air}};
    keys.push_back({"twist", {.types = boolean, .choices = {false}, .why_only = only}, false, false});
    keys.push_back({"tissue", choice("Deformation of vessels: rigid, or elastic walls.", {"rigid", "elastic"}), false,
                    default_vessel.is_soft ? "elastic" : "rigid"});
    keys.push_back(
        {"tear", flag("Bites tear out of walls that are pulled too hard. As tissue has it: elastic on, rigid off.")});
    keys.push_back({"leak", flag("A join leaks. As tissue has it: elastic on, rigid off.")});
    return group("What is simulated beside contact and friction; what is off costs nothing.", std::move(keys));
}

Schema throws_asked(const std::string& about) {
    Schema throws = count(about, 1, 20);
    throws.types = integer | text;
    throws.pattern = "^[1-9]([=x][1-9]){0,19}$";
    throws.pattern_words = "turns of each throw joined by '=' (reversed) or 'x' (same way), such as \"2=1\"";
    return throws;
}

Schema goal() {
    return group(
        "What the thread must be at the end.",
        {{"tie",
          choice("Knot, or hitch round a vessel.", {"square", "granny", "surgeons", "overhand", "slip", "figure-eight",
                                                    "bowline", "clove hitch", "constrictor", "cow hitch", "prusik"}),
          true},
         {"around", name("Vessel that the thread goes around.")},
         {"throws", throws_asked("Number of throws, or their notation after Tera and Aberg: \"2=1\".")},
         {"times", count("In how many pieces of thread.", 1, 100), false, Goal{}.times},
         {"tails_mm", list("Shortest and longest tail allowed.", 2, 2, quantity("Length of a tail.", 0, 1000, "mm"))}});
}

Schema bands() {
    return group(
        "Bands of scored items. An item without a band is shown, not judged.",
        {{"time_s", band("Duration, with the half second that tools rest in after a motion.", 7200, "s"), false},
         {"path_mm", per_instrument("Path of the tip.", band("", 1e6, "mm")), false, json::object()},
         {"grasps", per_instrument("Times the thread was grasped.", band_of_counts("", 10000)), false, json::object()},
         {"tension_N", band("Largest tension of the thread.", 200, "N"), false},
         {"lag_mm",
          per_instrument("Largest distance between hand and tool when a taut thread holds it back; a turn counts at a "
                         "jaw's length.",
                         band("", 1000, "mm")),
          false, json::object()},
         {"needle_deg", band("Least angle between jaws and wire when the needle is taken: 90 is right.", 90, "degrees"),
          false},
         {"bites", band_of_counts("Bites through a whole wall that hold.", 1000), false},
         {"bite_mm", band("Each bite, from its outer end to the cut.", 100, "mm"), false},
         {"bite_deg",
          band("Each bite, between needle and wall where it was first touched: 90 is straight.", 90, "degrees"), false},
         {"gap_mm", band("Widest gap of the suture line.", 100, "mm"), false},
         {"lumen", band("Area of the lumen at the join, over what it was.", 10, ""), false},
         {"leak_mL_min", band("Leak of the join at 100 mmHg.", 1e6, "mL/min"), false},
         {"lapses", band_of_counts("Lapses of ten (Anastomosis Lapse Index).", 10), false},
         {"walls_crossed", band_of_counts("Times an instrument was led through a wall that gave way.", 1000), false},
         {"pass_throughs", band_of_counts("Times the thread passed through something.", 1e9), false,
          json{{"max", 0}}}});
}

// Keyed by instrument, one at least.
Schema some_instruments(const std::string& about, const Schema& one) {
    Schema schema = per_instrument(about, one);
    schema.types_words = "an instrument and what is asked of it";
    schema.min_keys = 1;
    return schema;
}

Schema done() {
    std::vector<json> kinds;
    for (const world::EventWords& words : world::event_words) kinds.push_back(words.name);
    const Schema place = group("A place.", {{"place_mm", point("Where the tip is to come."), true},
                                            {"within_mm", quantity("How near is near enough.", 0.1, 100, "mm"), true}});
    const Schema event = group("Something that happens during the step.",
                               {{"kind", choice("As in result.json.", kinds), true},
                                {"what", name("Instrument or vessel that it happens to. Default: any.")}});
    Schema schema =
        group("When it is done: as soon as all of these hold at once.",
              {{"held", some_instruments("What is in an instrument's jaws.",
                                         choice("Maybe among other things.", {"thread", "needle", "wall", "nothing"}))},
               {"near", some_instruments("Where an instrument's tip is.", place)},
               {"event", event},
               {"knot", choice("What surgeons call the knot that the thread has.",
                               {"overhand", "double throw", "triple throw", "square", "granny", "surgeons", "slip",
                                "figure-eight", "bowline", "clove hitch", "constrictor", "cow hitch", "prusik"})},
               {"throws", throws_asked("Throws in the thread: so many or more, or exactly these.")},
               {"bites", count("At least so many bites, each through one whole wall.", 1, 100)}});
    schema.types_words = "one condition at least";
    schema.min_keys = 1;
    return schema;
}

Schema steps() {
    const Schema seconds = quantity("A time of the drill's motion.", 0, 7200, "s");
    return list(
        "Guidance, in order.", 0, 100,
        group("A step.", {{"text", words("One short sentence: what to do, and where."), true},
                          {"done", done(), true},
                          {"reference_s", list("From when to when the drill's motion does it.", 2, 2, seconds)}}));
}

}  // namespace

const Schema& drill_schema() {
    static const Schema schema =
        group("A drill for carrel. Units stand in the names of keys.",
              {{"$schema", words("For editors; not read.")},
               {"carrel_drill", {.types = integer, .about = "Version of this format.", .choices = {1}}, true},
               {"title", words("For people, one line."), true},
               {"description", words("For people.")},
               {"thread", thread(), true},
               {"vessels", list("What is operated on.", 0, 16, vessel()), false, json::array()},
               {"instruments",
                list("The tools: one a hand, of the one who ties and of an assistant, and what is left in place.", 1, 5,
                     instrument()),
                true},
               {"effects", effects(), false, json::object()},
               {"goals", list("At most one in this version.", 0, 1, goal()), false, json::array()},
               {"bands", bands(), false, json::object()},
               {"steps", steps(), false, json::array()},
               {"pace",
                quantity("Seconds simulated in one of the clock, at most: a drill that computers play slower "
                         "is slowed alike for all.",
                         0.05, 1),
                false, 1},
               {"time_limit_s", quantity("The drill ends then, and its time is missed.", 0.1, 7200, "s"), true},
               {"motion", words("Motion file (.csv) that plays the drill, path from the drill file.")}});
    return schema;
}

}  // namespace scenarios::drill
