#include "tests/bench/lab/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/curve.hpp"
#include "assets/mesh.hpp"
#include "sim/geometry/resample.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/start_shapes.hpp"

namespace bench::lab {

using nlohmann::json;

namespace {

constexpr double most_places = 6e6;  // nodes times ticks: a trace of 150 MB

Vec3 vector_of(const json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

std::vector<Vec3> curve_from(const std::filesystem::path& file) try {
    const auto components = assets::load_curve(file).components;
    if (components.size() != 1 || components[0].closed)
        throw Misfit{"/thread/start/file", "expected one open curve in " + file.string()};
    return components[0].vertices;
} catch (const assets::AssetError& error) {
    throw Misfit{"/thread/start/file", error.what()};
}

double need(const json& start, const char* key) {
    if (!start.contains(key))
        throw Misfit{"/thread/start", "the key \"" + std::string(key) + "\" is missing, this shape needs it"};
    return start[key];
}

// As long as its links are together, whatever the path's own size.
std::vector<Vec3> scalable_path(const json& start, double length, const std::filesystem::path& folder) {
    const std::string shape = start["shape"];
    if (shape == "straight") return {Vec3(-length / 2, 0, 0), Vec3(length / 2, 0, 0)};
    if (shape == "overhand") return laid_along_x(overhand_path(), length);
    const char* key = shape == "tied" ? "throws" : "file";
    if (!start.contains(key))
        throw Misfit{"/thread/start", "the key \"" + std::string(key) + "\" is missing, this shape needs it"};
    return laid_along_x(
        shape == "tied" ? tied_path(start["throws"]) : curve_from(folder / start["file"].get<std::string>()), length);
}

std::vector<Vec3> path_in_mm(const json& start) {
    const std::string shape = start["shape"];
    if (shape == "coil")
        return coil_path(need(start, "turns"), mm * need(start, "radius_mm"), mm * need(start, "pitch_mm"));
    if (shape == "folded")
        return folded_path(static_cast<int>(need(start, "folds")), mm * need(start, "length_mm"),
                           mm * need(start, "gap_mm"));
    if (!start.contains("points_mm"))
        throw Misfit{"/thread/start", "the key \"points_mm\" is missing, this shape needs it"};
    std::vector<Vec3> path;
    for (const json& p : start["points_mm"]) path.push_back(mm * vector_of(p));
    return path;
}

// Cuts one link in two very unequal ones.
void cut_short_link(std::vector<Vec3>& nodes, const json& cut) {
    const auto link = static_cast<std::size_t>(
        std::min(node_of(cut["after"], static_cast<int>(nodes.size())), static_cast<int>(nodes.size()) - 2));
    const double share = cut["share"];
    nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(link) + 1,
                 nodes[link] + share * (nodes[link + 1] - nodes[link]));
}

std::vector<Vec3> nodes_of(const json& thread, const std::filesystem::path& folder) {
    const json& start = thread["start"];
    const std::string shape = start["shape"];
    const double link = 2 * mm * thread["radius_mm"].get<double>() * thread["link_over_diameter"].get<double>();
    const bool has_links = thread.contains("links");
    std::vector<Vec3> path;
    if (shape == "coil" || shape == "folded" || shape == "points")
        path = path_in_mm(start);
    else if (has_links)
        path = scalable_path(start, link * thread["links"].get<int>(), folder);
    else
        throw Misfit{"/thread", "the key \"links\" is missing, this shape needs it"};
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        if (path[i] == path[i + 1])
            throw Misfit{"/thread/start",
                         "points " + std::to_string(i) + " and " + std::to_string(i + 1) + " are the same place"};
    if (!has_links && shape == "points") return path;
    const int links =
        has_links ? thread["links"].get<int>() : std::max(1, static_cast<int>(std::lround(length_of(path) / link)));
    std::vector<Vec3> nodes = sim::geometry::resample(path, links);
    if (thread.contains("short_link")) cut_short_link(nodes, thread["short_link"]);
    return nodes;
}

Way way_of(const json& value, const std::string& at) {
    Way way;
    way.axis = vector_of(value["axis"]);
    if (way.axis.norm() == 0) throw Misfit{at + "/axis", "expected a direction, found no length"};
    way.axis.normalize();
    for (const json& key : value["keys"]) {
        way.keys.push_back(
            {key["t_s"], mm * vector_of(key["by_mm"]), key["turn_deg"].get<double>() * std::numbers::pi / 180});
        if (way.keys.size() > 1 && !(way.keys[way.keys.size() - 2].t < way.keys.back().t))
            throw Misfit{at + "/keys/" + std::to_string(way.keys.size() - 1) + "/t_s",
                         "expected later than the key before"};
    }
    return way;
}

HoldPlan hold_of(const json& value, const Scene& scene, const std::string& at) {
    HoldPlan plan;
    for (const json& node : value["nodes"]) {
        plan.nodes.push_back(node_of(node, static_cast<int>(scene.nodes.size())));
        if (plan.nodes.back() >= static_cast<int>(scene.nodes.size()))
            throw Misfit{at + "/nodes", "expected less than the thread's " + std::to_string(scene.nodes.size()) +
                                            " nodes, found " + std::to_string(plan.nodes.back())};
    }
    plan.tool = value["tool"];
    plan.from = value["from_s"];
    plan.to = value.contains("to_s") ? value["to_s"].get<double>() : 2 * scene.duration;
    if (plan.to < plan.from) throw Misfit{at + "/to_s", "expected not before from_s"};
    if (value.contains("chatter"))
        plan.chatter_period = value["chatter"]["period_s"], plan.chatter_phase = value["chatter"]["phase_s"];
    plan.way = way_of(value, at);
    return plan;
}

ToolPlan tool_of(const json& value, const std::string& at) {
    return {std::max(0, value["tool"].get<int>()),
            {mm * vector_of(value["a_mm"]), mm * vector_of(value["b_mm"]), mm * value["radius_mm"].get<double>()},
            way_of(value, at)};
}

std::vector<sim::geometry::Triangle> tube_of(const json& tube) {
    const double diameter = mm * tube["diameter_mm"].get<double>(), wall = mm * tube["wall_mm"].get<double>();
    if (wall >= diameter / 2) throw Misfit{"/tube/wall_mm", "expected less than half of diameter_mm"};
    constexpr int rings = 10;
    auto mesh = assets::make_tube(diameter, wall, mm * tube["length_mm"].get<double>(), tube["sides"], rings);
    const std::string along = tube["along"];
    const Vec3 centre = mm * vector_of(tube["centre_mm"]);
    for (Vec3& p : mesh.vertices) {
        if (along == "y") p = Vec3(p.z(), p.x(), p.y());
        if (along == "z") p = Vec3(p.y(), p.z(), p.x());
        p += centre;
    }
    return mesh.soup();
}

Fault fault_of(const json& value, const Scene& scene, const std::string& at) {
    static const std::vector<std::string> kinds{
        "nan", "infinite", "zero_rotation", "long_rotation", "flipped_rotation", "frozen", "leap", "sampled"};
    const auto kind = std::find(kinds.begin(), kinds.end(), value["is"].get<std::string>()) - kinds.begin();
    Fault fault{static_cast<Fault::Kind>(kind), value["input"], value["from_s"], 0,
                mm * vector_of(value["by_mm"]), value["hz"]};
    fault.to = value.contains("to_s") ? value["to_s"].get<double>() : 2 * scene.duration;
    const bool of_thread = fault.input == "holds" || fault.input == "tools";
    if (of_thread != scene.drill.empty())
        throw Misfit{at + "/input", "expected \"holds\" or \"tools\" of a thread, or an instrument of a drill"};
    if (of_thread && kind > 1) throw Misfit{at + "/is", "expected \"nan\" or \"infinite\", the others are for drills"};
    return fault;
}

// Where it is counted by the nodes that there are at first.
CutPlan cut_of(const json& value, const Scene& scene, const std::string& at) {
    const int nodes = static_cast<int>(scene.nodes.size()), after = node_of(value["after"], nodes);
    if (after + 1 >= nodes)
        throw Misfit{at + "/after", "expected less than the last of the thread's " + std::to_string(nodes) + " nodes"};
    double place = 0;
    for (int i = 0; i <= after; ++i)
        place += (i < after ? 1 : value["share"].get<double>()) *
                 (scene.nodes[static_cast<std::size_t>(i) + 1] - scene.nodes[static_cast<std::size_t>(i)]).norm();
    return {value["t_s"], place};
}

template <typename List, typename Make>
void fill(List& list, const json& values, const std::string& at, Make make) {
    for (std::size_t i = 0; i < values.size(); ++i) list.push_back(make(values[i], at + "/" + std::to_string(i)));
}

}  // namespace

int node_of(const json& value, int nodes) {
    if (value.is_number()) return value.get<int>();
    const std::string name = value;
    if (name == "first") return 0;
    if (name == "last") return nodes - 1;
    return static_cast<int>(std::lround(std::stod(name) / 100 * (nodes - 1)));
}

Scene scene_of(const json& value, const std::filesystem::path& folder) {
    Scene scene;
    scene.tick = value["tick_s"];
    scene.duration = value["duration_s"];
    if (value.contains("drill") == value.contains("thread"))
        throw Misfit{"", "expected exactly one of the keys \"thread\" and \"drill\""};
    if (value.contains("drill")) {
        scene.drill = folder / value["drill"].get<std::string>();
        scene.model = value.value("model", "");
    } else if (value.contains("model")) {
        throw Misfit{"/model", "goes with \"drill\" alone, expected it in \"thread\""};
    } else {
        const json& thread = value["thread"];
        scene.thread = {mm * thread["radius_mm"].get<double>(), thread["friction"], thread["friction_tool"],
                        thread["axial_stiffness_N"]};
        if (thread["model"] == "elastic")
            scene.thread.elastic = {.axial_over_bending = thread["axial_over_bending"],
                                    .keeps_shape = thread["keeps_shape"]};  // polypropylene
        scene.break_force = thread.value("break_N", scene.break_force);
        scene.nodes = nodes_of(thread, folder);
    }
    if (static_cast<double>(scene.nodes.size()) * scene.duration / scene.tick > most_places)
        throw Misfit{"/duration_s", "expected less: nodes times ticks over 6 million"};
    fill(scene.holds, value["holds"], "/holds",
         [&](const json& v, const std::string& at) { return hold_of(v, scene, at); });
    fill(scene.tools, value["tools"], "/tools", [&](const json& v, const std::string& at) { return tool_of(v, at); });
    fill(scene.cuts, value["cuts"], "/cuts",
         [&](const json& v, const std::string& at) { return cut_of(v, scene, at); });
    std::stable_sort(scene.cuts.begin(), scene.cuts.end(),
                     [](const CutPlan& a, const CutPlan& b) { return a.place > b.place; });
    if (value.contains("tube")) scene.surface = tube_of(value["tube"]);
    fill(scene.faults, value["broken_input"], "/broken_input",
         [&](const json& v, const std::string& at) { return fault_of(v, scene, at); });
    return scene;
}

}  // namespace bench::lab
