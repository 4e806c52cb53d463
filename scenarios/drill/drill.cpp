#include "scenarios/drill/drill.hpp"

#include <algorithm>

#include "scenarios/drill/bands.hpp"
#include "scenarios/drill/direction.hpp"
#include "scenarios/drill/json_text.hpp"
#include "scenarios/drill/keys.hpp"
#include "scenarios/drill/materials.hpp"
#include "scenarios/drill/motion.hpp"
#include "scenarios/drill/names.hpp"
#include "scenarios/drill/needles.hpp"
#include "scenarios/drill/read_steps.hpp"
#include "scenarios/drill/start_path.hpp"
#include "scenarios/drill/start_walls.hpp"
#include "scenarios/drill/tie.hpp"

namespace scenarios::drill {

namespace {

constexpr std::size_t most_bytes = 4 << 20;  ///< A path of 2000 points takes 100 kB.
constexpr std::size_t most_mesh_bytes = 256 << 20;

double metres(const json& mm) {
    return mm.get<double>() / 1000;
}

world::Vec3 point(const json& mm) {
    return {metres(mm[0]), metres(mm[1]), metres(mm[2])};
}

instruments::Kind kind_named(const std::string& name) {
    if (name == "scissors") return instruments::Kind::scissors;
    if (name == "approximator") return instruments::Kind::approximator;
    return name == "needle_holder" ? instruments::Kind::needle_holder : instruments::Kind::forceps;
}

/// Turns a document that fits drill_schema() into a Drill, and checks what one value says about another.
class Reader {
  public:
    Reader(const JsonText& document, std::filesystem::path base) : document_(document), base_(std::move(base)) {}

    Drill read() {
        if (const auto problem = first_problem(document_.value(), drill_schema()))
            document_.fail(problem->pointer, problem->what, problem->at_key);
        filled_ = with_defaults(document_.value(), drill_schema());
        drill_.title = filled_["title"];
        const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
        if (std::any_of(drill_.title.begin(), drill_.title.end(), is_control))
            document_.fail("/title", "has control characters, expected one line of text");
        drill_.description = filled_.value("description", "");
        drill_.time_limit_s = filled_["time_limit_s"];
        if (filled_.contains("motion")) drill_.motion = base_ / filled_["motion"].get<std::string>();
        read_instruments();
        read_vessels();
        check_approximators();
        read_thread();
        read_effects();
        read_goals();
        drill_.bands = read_bands(document_, filled_["bands"], drill_.world);
        if (drill_.bands.time_s && drill_.bands.time_s->low > drill_.time_limit_s)
            document_.fail("/bands/time_s",
                           "the drill ends before, at time_limit_s, which is " + shown(drill_.time_limit_s) + " s");
        check_cuts();
        drill_.pace = filled_["pace"];
        read_steps(document_, filled_["steps"], drill_);
        drill_.filled = laid_out(in_table_order(filled_, drill_schema()));
        return drill_;
    }

    void check_files() const {
        for (std::size_t i = 0; i < drill_.world.vessels.size(); ++i) check_mesh(i);
        std::error_code unreadable;  // as a name of more than 255 characters is
        if (!drill_.motion.empty() && !std::filesystem::is_regular_file(drill_.motion, unreadable))
            document_.fail("/motion", "no such file: " + drill_.motion.string());
        check_references(document_, drill_, motion_s());
    }

  private:
    // How long the drill's motion is [s]; read only where a step refers to it.
    std::optional<double> motion_s() const {
        const auto& steps = drill_.steps;
        const bool is_asked = std::any_of(steps.begin(), steps.end(), [](auto& step) { return !!step.reference_s; });
        if (!is_asked || drill_.motion.empty()) return {};
        return load_motion(drill_.motion, instrument_names(drill_)).duration();
    }

    void check_mesh(std::size_t i) const {
        const json& vessel = filled_["vessels"][i];
        if (!vessel.contains("mesh")) return;
        const std::string pointer = "/vessels/" + std::to_string(i) + "/mesh/";
        const std::filesystem::path file = drill_.world.vessels[i].mesh_file;
        std::error_code unreadable;
        if (!std::filesystem::is_regular_file(file, unreadable))
            document_.fail(pointer + "file", "no such file: " + file.string());
        const std::string found = sha256(read_text(file, most_mesh_bytes));
        if (found != vessel["mesh"]["sha256"])
            document_.fail(pointer + "sha256", "the file is not the one meant, its SHA-256 is " + found);
    }

    // Names are looked up from goals, bands and motions, so each stands for one thing.
    void check_new(const std::string& name, const std::string& pointer, const auto& others) const {
        for (const auto& other : others)
            if (other.name == name)
                document_.fail(pointer, "\"" + name + "\" is named twice, expected different names");
    }

    void read_instruments() {
        auto& instruments = drill_.world.instruments;
        for (const json& entry : filled_["instruments"]) {
            check_new(entry["name"], "/instruments/" + std::to_string(instruments.size()) + "/name", instruments);
            instruments.push_back({entry["name"], kind_named(entry["kind"])});
            if (!entry.contains("pull_N")) continue;
            if (filled_["thread"]["model"] != "elastic")
                document_.fail("/instruments/" + std::to_string(instruments.size() - 1) + "/pull_N",
                               "a thread moved by ftl has no forces to feel, expected none, or \"model\": \"elastic\" "
                               "in the thread");
            instruments.back().pull = entry["pull_N"];
        }
    }

    int holder_of(const world::VesselDef& vessel, const std::string& name, const std::string& pointer) const {
        const auto& all = drill_.world.instruments;
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& of) {
            return of.name == name && of.kind == instruments::Kind::approximator;
        });
        if (found == all.end())
            document_.fail(pointer, "no approximator is named \"" + name + "\", expected an instrument of that kind");
        if (!vessel.is_soft)
            document_.fail(
                pointer,
                "a rigid vessel stays where it is, expected \"tissue\": \"elastic\" in effects, or no \"held_by\"");
        if (vessel.start_held == vessel.end_held)
            document_.fail(pointer, "expected one end in \"held\", so that the other can be brought to another vessel");
        return static_cast<int>(found - all.begin());
    }

    void check_approximators() const {
        const auto& world = drill_.world;
        for (std::size_t i = 0; i < world.instruments.size(); ++i)
            if (world.instruments[i].kind == instruments::Kind::approximator &&
                std::none_of(world.vessels.begin(), world.vessels.end(),
                             [&](const auto& vessel) { return vessel.held_by == static_cast<int>(i); }))
                document_.fail("/instruments/" + std::to_string(i),
                               "holds no vessel, expected \"held_by\": \"" + world.instruments[i].name + "\" in one");
    }

    void check_cuts() {
        const Bands& bands = drill_.bands;
        if (!bands.bite_mm && !bands.gap_mm && !bands.lumen && !bands.leak_mL_min && !bands.lapses) return;
        auto& vessels = drill_.world.vessels;
        for (std::size_t i = 0; i < vessels.size(); ++i) {
            vessels[i].needs_cut = vessels[i].is_soft;
            if (vessels[i].is_soft && vessels[i].start_held && vessels[i].end_held)
                document_.fail("/vessels/" + std::to_string(i),
                               "both ends are held, so that there is no cut to measure bites and join from, expected "
                               "one end in \"held\"");
        }
    }

    void read_vessels() {
        auto& vessels = drill_.world.vessels;
        for (const json& entry : filled_["vessels"]) {
            const std::string place = "/vessels/" + std::to_string(vessels.size());
            check_new(entry["name"], place + "/name", vessels);
            check_new(entry["name"], place + "/name", drill_.world.instruments);
            world::VesselDef vessel;
            vessel.name = entry["name"];
            vessel.centre = point(entry["centre_mm"]);
            vessel.axis = point(entry["axis"]);
            if (!has_direction(vessel.axis))
                document_.fail(place + "/axis", "has no direction, expected one component other than 0");
            vessel.axis.normalize();
            vessel.is_soft = filled_["effects"]["tissue"] == "elastic";
            vessel.puncture_force = entry["puncture_N"];
            vessel.young_modulus = 1e6 * entry["young_MPa"].get<double>();
            vessel.start_held = vessel.end_held = false;
            for (const json& end : entry["held"]) (end == "start" ? vessel.start_held : vessel.end_held) = true;
            if (entry.contains("held_by")) vessel.held_by = holder_of(vessel, entry["held_by"], place + "/held_by");
            if (entry.contains("mesh")) {
                const json& mesh = entry["mesh"];
                if (mesh.contains("wall_mm") != vessel.is_soft)
                    document_.fail(place + "/mesh",
                                   vessel.is_soft
                                       ? "the key \"wall_mm\" is missing: how thick the wall is that gives way"
                                       : "\"wall_mm\" is of a wall that gives way, expected none, or \"tissue\": "
                                         "\"elastic\" in effects");
                vessel.mesh_file = (base_ / mesh["file"].get<std::string>()).string();
                if (vessel.is_soft) vessel.wall = metres(mesh["wall_mm"]);
            } else {
                const json& tube = entry["tube"];
                vessel.diameter = metres(tube["diameter_mm"]);
                vessel.wall = metres(tube["wall_mm"]);
                vessel.length = metres(tube["length_mm"]);
                vessel.cut_angle = tube["cut_angle_deg"];
                if (vessel.wall >= vessel.diameter / 2)
                    document_.fail(place + "/tube/wall_mm", "expected less than half of diameter_mm, which is " +
                                                                shown(tube["diameter_mm"].get<double>()) + " mm");
                const double least = vessel.diameter * (0.5 + 0.5 / std::sqrt(2.0));  // as tissue::make_tube() needs
                if (vessel.is_soft && vessel.cut_angle < 90 && vessel.length <= least)
                    document_.fail(place + "/tube/length_mm", "too short for a slanted cut, expected above " +
                                                                  shown(0.01 * std::ceil(1e5 * least)) + " mm");
            }
            for (const world::VesselDef& before : vessels)
                if (are_in_each_other(before, vessel))
                    document_.fail(place + "/centre_mm", "its wall is in that of \"" + before.name +
                                                             "\", expected the two clear of each other");
            vessels.push_back(vessel);
        }
    }

    void read_thread() {
        json& entry = filled_["thread"];
        const Size& size = size_named(entry["size"]);
        const Material& material = material_named(entry["material"]);
        const auto fallback = [&](const char* key, double value) {
            if (!entry.contains(key)) entry[key] = value;
        };
        fallback("diameter_mm", size.diameter_mm);
        fallback("break_N", size.break_N);
        fallback("young_MPa", material.young_MPa);
        fallback("density_kg_m3", material.density_kg_m3);
        if (material.yield_percent > 0) fallback("yield_percent", material.yield_percent);
        world::ThreadDef& thread = drill_.world.thread;
        thread.size = entry["size"];
        thread.material = entry["material"];
        thread.model = entry["model"];
        thread.diameter = metres(entry["diameter_mm"]);
        thread.length = metres(entry["length_mm"]);
        thread.young_modulus = entry["young_MPa"].get<double>() * 1e6;
        thread.bending_share = material.bending_young_MPa / material.young_MPa;
        thread.density = entry["density_kg_m3"];
        thread.break_force = entry["break_N"];
        thread.friction = entry["friction"];
        thread.friction_tool = entry["friction_tool"];
        constexpr int fewest = 2;
        if (!entry.contains("links"))
            entry["links"] =
                std::clamp(static_cast<int>(thread.length / (2 * thread.diameter)), fewest, world::ThreadDef{}.links);
        thread.links = static_cast<int>(entry["links"].get<double>());
        thread.contacts_per_tick = static_cast<int>(entry["contacts_per_tick"].get<double>());
        if (thread.contacts_per_tick > 0 && thread.model != "elastic")
            document_.fail("/thread/contacts_per_tick",
                           "a thread moved by ftl leaves nothing to the next tick, expected 0, or \"model\": "
                           "\"elastic\" in the thread");
        if (thread.length / thread.links < thread.diameter)
            document_.fail("/thread/links", "links would be shorter than the thread is thick, expected at most " +
                                                std::to_string(static_cast<int>(thread.length / thread.diameter)));
        fallback("shortest_link_mm", 1e3 * thread.diameter);
        thread.shortest_link = metres(entry["shortest_link_mm"]);
        if (thread.shortest_link > 0 && thread.shortest_link < thread.diameter)
            document_.fail("/thread/shortest_link_mm",
                           "links would be shorter than the thread is thick, expected 0 or at least " +
                               shown(1e3 * thread.diameter));
        read_start(entry);
    }

    // What is not written is as the model has it; another model may be asked for by who runs the drill.
    void read_effects() {
        json& entry = filled_["effects"];
        world::ThreadDef& thread = drill_.world.thread;
        const bool elastic = thread.model == "elastic";
        const auto read = [&](const char* key, bool& on) {
            if (entry.contains(key))
                on = entry[key];
            else
                entry[key] = elastic;
        };
        bool bends = elastic, sets = false;
        read("gravity", thread.weighs), read("bending", bends), read("extension", thread.stretches),
            read("plastic_set", sets), read("inertia", thread.swings);
        thread.is_in_air = entry["air"];
        for (const char* key : {"tear", "leak"}) agree_with_tissue(entry, key);
        for (const char* key : {"gravity", "bending", "extension", "plastic_set", "inertia", "air"})
            if (!elastic && entry[key])
                document_.fail(
                    std::string("/effects/") + key,
                    "a thread moved by ftl has none, expected false, or \"model\": \"elastic\" in the thread");
        if (elastic && !bends)
            document_.fail("/effects/bending",
                           "an elastic thread bends, expected true, or \"model\": \"ftl\" in the thread");
        if (!sets) return;
        if (!filled_["thread"].contains("yield_percent"))
            document_.fail("/effects/plastic_set", "nothing is known of when " + thread.material +
                                                       " yields, expected false, or \"yield_percent\" in the thread");
        thread.yield_strain = 0.01 * filled_["thread"]["yield_percent"].get<double>();
    }

    void agree_with_tissue(json& effects, const char* key) const {
        const bool is_soft = effects["tissue"] == "elastic" && !drill_.world.vessels.empty();
        if (!effects.contains(key)) effects[key] = is_soft;
        if (effects[key] != is_soft)
            document_.fail(
                std::string("/effects/") + key,
                is_soft ? "walls that give way tear and leak, expected true or no such key"
                        : "rigid walls neither tear nor leak, expected false, or vessels and \"tissue\": \"elastic\"");
    }

    void read_needle(const json& entry) {
        if (!drill_.world.vessels.empty() && !drill_.world.vessels.front().is_soft)
            document_.fail(
                "/thread/needle",
                "a rigid vessel lets no needle in, expected \"tissue\": \"elastic\" in effects, or no vessels");
        drill_.world.needle_code = entry["code"];
        drill_.world.needle = needle_at_start(entry, "/thread/needle/");
        if (const double wire = needle_named(drill_.world.needle_code).wire; drill_.world.thread.diameter > wire)
            document_.fail("/thread/needle/code", "its wire of " + shown(1e3 * wire) +
                                                      " mm makes no hole for a thread of " +
                                                      shown(1e3 * drill_.world.thread.diameter) +
                                                      " mm, expected a thicker needle or a thinner thread");
    }

    sim::geometry::Arc needle_at_start(const json& entry, const std::string& pointer) const {
        const auto direction = [&](const char* key) {
            const world::Vec3 read = point(entry[key]);
            if (!has_direction(read))
                document_.fail(pointer + key, "has no direction, expected one component other than 0");
            return read;
        };
        const world::Vec3 towards = direction("towards"), bulge = direction("bulge");
        if (towards.cross(bulge).norm() <
            0.01 * towards.norm() * bulge.norm())  // its plane would be unknown to half a degree
            document_.fail(pointer + "bulge", "is along \"towards\", expected a direction across it");
        const sim::geometry::Arc needle =
            needle_at(needle_named(drill_.world.needle_code), point(entry["tail_mm"]), towards, bulge);
        for (const world::VesselDef& vessel : drill_.world.vessels)
            if (is_in_wall(needle, vessel))
                document_.fail(pointer + "tail_mm", "from here the needle is in the wall of \"" + vessel.name +
                                                        "\", expected to start clear of it");
        return needle;
    }

    // Puts the corners behind what of the path is there already, and checks it all.
    template <typename Check>
    void read_path(const json& corners, std::vector<world::Vec3>& path, const std::string& pointer,
                   const Check& check) {
        const int before = static_cast<int>(path.size());
        for (const json& corner : corners) path.push_back(point(corner));
        if (const auto wrong = check(drill_.world))
            document_.fail(pointer + (wrong->at < before ? "" : "/" + std::to_string(wrong->at - before)), wrong->what);
    }

    void read_start(json& entry) {
        world::ThreadDef& thread = drill_.world.thread;
        if (entry.contains("needle")) {
            read_needle(entry["needle"]);
            thread.start = start_behind(drill_.world, drill_.world.needle);
        }
        if (!entry.contains("start_mm")) entry["start_mm"] = straight_start(drill_.world);
        read_path(entry["start_mm"], thread.start, "/thread/start_mm", cut_and_check_start);
        if (entry.contains("spares")) read_spares(entry);
    }

    void read_spares(const json& entry) {
        if (!entry.contains("needle"))
            document_.fail(
                "/thread/spares",
                "they would have needles like the first thread, which has none, expected \"needle\" beside them");
        for (std::size_t i = 0; i < entry["spares"].size(); ++i) {
            const json& spare = entry["spares"][i];
            const std::string pointer = "/thread/spares/" + std::to_string(i);
            world::SpareDef& read = drill_.world.spares.emplace_back();
            read.needle = needle_at_start(spare["needle"], pointer + "/needle/");
            read.start = start_behind(drill_.world, read.needle);
            read_path(spare["start_mm"], read.start, pointer + "/start_mm", cut_and_check_last_spare);
        }
    }

    void read_goals() {
        for (const json& entry : filled_["goals"]) {
            const std::string place = "/goals/" + std::to_string(drill_.goals.size());
            Goal goal;
            goal.tie = entry["tie"];
            goal.around = entry.value("around", "");
            const auto& vessels = drill_.world.vessels;
            if (!goal.around.empty() &&
                std::none_of(vessels.begin(), vessels.end(), [&](auto& v) { return v.name == goal.around; }))
                document_.fail(place + "/around", "no vessel is named \"" + goal.around + "\"" +
                                                      (vessels.empty() ? "" : ", expected " + names_of(vessels)));
            if (entry.contains("throws") && entry["throws"].is_string()) goal.notation = entry["throws"];
            if (entry.contains("throws") && entry["throws"].is_number())
                goal.throws = static_cast<int>(entry["throws"].get<double>());
            if (entry.contains("tails_mm"))
                goal.tails_mm = read_band(document_, entry["tails_mm"], place + "/tails_mm");
            goal.times = static_cast<int>(entry["times"].get<double>());
            if (const GoalFault fault = fault_of(goal, !vessels.empty()); !fault.what.empty())
                document_.fail(place + "/" + fault.key, fault.what);
            drill_.goals.push_back(goal);
        }
    }

    const JsonText& document_;
    std::filesystem::path base_;
    json filled_;
    Drill drill_;
};

}  // namespace

Drill parse_drill(const std::string& text, const std::string& name, const std::filesystem::path& base) {
    const JsonText document(text, name);
    Drill drill = Reader(document, base).read();
    drill.text = text;
    return drill;
}

Drill load_drill(const std::filesystem::path& file) {
    const std::string text = read_text(file, most_bytes);
    const JsonText document(text, file.string());
    Reader reader(document, file.parent_path());
    Drill drill = reader.read();
    reader.check_files();
    drill.text = text;
    return drill;
}

std::string published_schema() {
    nlohmann::ordered_json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                                     {"title", "Carrel drill"}};
    schema.update(json_schema_of(drill_schema()));
    return laid_out(schema) + "\n";
}

std::vector<std::string> instrument_names(const Drill& drill) {
    std::vector<std::string> names;
    for (const auto& instrument : drill.world.instruments) names.push_back(instrument.name);
    return names;
}

}  // namespace scenarios::drill
