#include <algorithm>

#include "scenarios/drill/file.hpp"
#include "scenarios/drill/json_text.hpp"
#include "tests/bench/lab/hard_case.hpp"
#include "tests/bench/lab/hard_case_keys.hpp"
#include "tests/bench/lab/scene_parts.hpp"

namespace bench::lab {

using scenarios::drill::json;
using scenarios::drill::JsonText;

namespace {

constexpr std::size_t most_bytes = 1 << 20;

Condition condition_of(const json& value, const Scene& scene) {
    Condition c;
    c.is = value["is"];
    c.must = value.contains("at_most") ? Must::be_at_most : Must::be_at_least;
    c.bound = value.contains("at_most") ? value["at_most"] : value["at_least"];
    c.from = value["from_s"];
    if (value.contains("to_s")) c.to = value["to_s"];
    if (value.contains("node")) c.node = node_of(value["node"], static_cast<int>(scene.nodes.size()));
    c.tool = value["part"];
    c.vessel = value["vessel"];
    c.factor = value["factor"];
    c.knot = value.value("knot", "");
    c.event = value.value("event", "");
    c.model = value.value("model", "");
    c.known = value.value("known", "");
    if (value.contains("today")) c.today = value["today"];
    return c;
}

// What no table can say, because it is about two values at once.
void check(const Condition& c, const Scene& scene, const std::string& at) {
    if ((c.is == "knot_differs") == c.knot.empty())
        throw Misfit{at, c.knot.empty() ? "the key \"knot\" is missing: the name it must have"
                                        : "\"knot\" goes with \"knot_differs\" alone"};
    if ((c.is == "events") == c.event.empty())
        throw Misfit{at, c.event.empty() ? "the key \"event\" is missing: the kind that is counted"
                                         : "\"event\" goes with \"events\" alone"};
    if (c.known.empty() == c.today.has_value())
        throw Misfit{at, c.known.empty() ? "\"today\" goes with \"known\" alone"
                                         : "the key \"today\" is missing: the bound that holds until then"};
    const bool needs_tool = c.is == "tool_moved";
    if (needs_tool && (!scene.drill.empty() || c.tool >= static_cast<int>(scene.tools.size())))
        throw Misfit{at + "/part",
                     "expected less than the " + std::to_string(scene.tools.size()) + " tool parts of the scene"};
    if (c.from >= scene.duration) throw Misfit{at + "/from_s", "expected less than duration_s"};
    if (c.node >= static_cast<int>(scene.nodes.size()) && scene.drill.empty())
        throw Misfit{at + "/node", "expected less than the thread's " + std::to_string(scene.nodes.size()) + " nodes"};
}

std::vector<Condition> conditions_of(const json& value, const Scene& scene) {
    std::vector<Condition> conditions;
    for (std::size_t i = 0; i < value["expect"].size(); ++i) {
        conditions.push_back(condition_of(value["expect"][i], scene));
        check(conditions.back(), scene, "/expect/" + std::to_string(i));
    }
    return conditions;
}

// They hold parts of scenes, which have no form of their own.
json variants_taken_out(json& given) {
    if (!given.is_object() || !given.contains("variants")) return json::array();
    json variants = given["variants"];
    if (!variants.is_array() || variants.size() > 20 ||
        !std::all_of(variants.begin(), variants.end(), [](const json& v) { return v.is_object(); }))
        throw Misfit{"/variants", "expected a list of up to 20 objects, each with what it replaces in the scene"};
    given.erase("variants");
    return variants;
}

// The scene with some of its values replaced, as JSON Merge Patch (RFC 7386) says, checked like any other.
Scene variant_of(json value, const json& patch, const std::filesystem::path& folder, const std::string& at) {
    value.merge_patch(patch);
    if (const auto problem = scenarios::drill::first_problem(value, hard_case_schema()))
        throw Misfit{at, "makes " + problem->pointer + ": " + problem->what};
    try {
        return scene_of(scenarios::drill::with_defaults(value, hard_case_schema()), folder);
    } catch (const Misfit& misfit) {
        throw Misfit{at, "makes " + misfit.pointer + ": " + misfit.what};
    }
}

}  // namespace

HardCase parse_hard_case(const std::string& text, const std::filesystem::path& file) {
    const JsonText parsed(text, file.string());
    json given = parsed.value();
    try {
        const json variants = variants_taken_out(given);
        if (const auto problem = scenarios::drill::first_problem(given, hard_case_schema()))
            parsed.fail(problem->pointer, problem->what, problem->at_key);
        const json value = scenarios::drill::with_defaults(given, hard_case_schema());
        const auto folder = file.parent_path();
        HardCase hard_case{value["id"],   value["goes_wrong"],       value.value("why", ""),
                           value["case"], {scene_of(value, folder)}, {}};
        if (hard_case.id != file.stem())
            throw Misfit{"/id", "expected the file's name, \"" + file.stem().string() + "\""};
        hard_case.conditions = conditions_of(value, hard_case.scenes.front());
        for (std::size_t i = 0; i < variants.size(); ++i)
            hard_case.scenes.push_back(variant_of(given, variants[i], folder, "/variants/" + std::to_string(i)));
        for (std::size_t i = 0; i < hard_case.conditions.size(); ++i)
            if (std::none_of(hard_case.scenes.begin(), hard_case.scenes.end(),
                             [&](const Scene& s) { return is_asked_of(s, hard_case.conditions[i]); }))
                throw Misfit{"/expect/" + std::to_string(i) + "/model", "expected that of a variant"};
        return hard_case;
    } catch (const Misfit& misfit) {
        parsed.fail(misfit.pointer, misfit.what);
    }
}

HardCase load_hard_case(const std::filesystem::path& file) {
    return parse_hard_case(scenarios::drill::read_text(file, most_bytes), file);
}

std::vector<std::filesystem::path> hard_case_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace bench::lab
