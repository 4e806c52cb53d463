#include <algorithm>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/fault.hpp"
#include "app/one_line.hpp"
#include "app/progress.hpp"
#include "assets/curve.hpp"
#include "sim/knot/namer.hpp"

namespace app {

namespace {

struct Answer {
    std::string file;
    bool open = false;
    sim::knot::LinkName link;
    double microseconds = 0.0;
};

assets::Curve load(const std::string& file) {
    try {
        return file == "-" ? assets::read_curve(std::cin, "standard input") : assets::load_curve(file);
    } catch (const assets::AssetError& error) {
        throw InputFault(error.what());
    }
}

// An object whose ends are hardly farther apart than its vertices are elsewhere is a closed one, its first vertex not
// repeated.
bool is_ring(const std::vector<sim::knot::Vec3>& vertices) {
    double longest = 0;
    for (std::size_t i = 1; i < vertices.size(); ++i)
        longest = std::max(longest, (vertices[i] - vertices[i - 1]).norm());
    return vertices.size() > 3 && (vertices.back() - vertices.front()).norm() <= 1.5 * longest;
}

// A component together with where it was read, so that a fault in it can be located.
struct Source {
    const assets::Curve* curve;
    int component;
};

Answer name(const std::string& file, const std::vector<assets::Curve>& around, bool closed) {
    const assets::Curve curve = load(file);
    std::vector<sim::knot::Component> components;
    std::vector<Source> sources;
    const auto add = [&](const assets::Curve& from, bool close) {
        for (std::size_t i = 0; i < from.components.size(); ++i) {
            const bool ring = !components.empty() && is_ring(from.components[i].vertices);
            components.push_back({from.components[i].vertices, from.components[i].closed || close || ring});
            sources.push_back({&from, static_cast<int>(i)});
        }
    };
    add(curve, closed);
    for (const assets::Curve& object : around) add(object, false);
    if (const auto touch = sim::knot::first_touch(components)) {
        const auto place = [&](int component, int vertex) {
            const Source& source = sources[static_cast<std::size_t>(component)];
            return source.curve->place(source.component, vertex);
        };
        throw InputFault(
            place(touch->component_a, touch->vertex_a) + ": error: the edge from here touches the edge from " +
            place(touch->component_b, touch->vertex_b) + ", so the knot is undefined; expected strands apart");
    }
    const auto start = std::chrono::steady_clock::now();
    Answer answer{file, !components.front().closed, sim::knot::name_link(components), 0.0};
    answer.microseconds = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    return answer;
}

nlohmann::ordered_json to_json(const Answer& answer) {
    const sim::knot::Name& n = answer.link.name;
    nlohmann::ordered_json j{{"file", answer.file},
                             {"components", answer.link.component_knots.size()},
                             {"open", answer.open},
                             {"knot", n.knot}};
    j["factors"] = nlohmann::json::array();
    for (const auto& f : n.factors)
        j["factors"].push_back(
            nlohmann::ordered_json{{"name", f.name}, {"mirror", f.mirror}, {"crossings", f.crossings}});
    if (n.surgical.empty()) {
        j["surgical"] = nullptr;
    } else {
        j["surgical"] = nlohmann::ordered_json{{"name", n.surgical}, {"throws", nullptr}, {"flat", nullptr}};
        if (!n.throws.empty()) j["surgical"]["throws"] = n.throws, j["surgical"]["flat"] = n.flat;
        if (!n.flat) j["surgical"]["half_hitches"] = n.half_hitches;
    }
    const nlohmann::json left = n.crossings_reduced < 0 ? nlohmann::json() : nlohmann::json(n.crossings_reduced);
    j["crossings"] = nlohmann::ordered_json{{"projected", n.crossings_projected}, {"reduced", left}};
    j["certain"] = n.certain;
    if (!n.certain) j["candidates"] = n.candidates;
    if (answer.link.component_knots.size() > 1) {
        j["component_knots"] = answer.link.component_knots;
        j["linking_numbers"] = answer.link.linking_numbers;
    }
    j["microseconds"] = static_cast<long>(answer.microseconds + 0.5);
    return j;
}

void print(const Answer& answer) {
    const sim::knot::Name& n = answer.link.name;
    std::cout << answer.file << ": " << n.knot;
    if (n.knot == "unknown" && n.crossings_reduced < 0) std::cout << " (too many crossings to count)";
    if (n.knot == "unknown" && n.crossings_reduced >= 0) std::cout << " (" << n.crossings_reduced << " crossings left)";
    if (!n.surgical.empty()) std::cout << ", " << n.surgical;
    if (!n.throws.empty())
        std::cout << " (" << n.throws << ")" << (n.flat ? "" : ", capsized: half hitches " + n.half_hitches);
    if (!n.certain && !n.candidates.empty()) {
        std::cout << ", not certain:";
        for (const std::string& c : n.candidates) std::cout << ' ' << c;
    }
    for (std::size_t i = 0; i < answer.link.linking_numbers.size(); ++i)
        std::cout << (i == 0 ? ", linking numbers " : " ") << answer.link.linking_numbers[i];
    std::cout << '\n';
}

}  // namespace

int knot_command(const KnotOptions& options) {
    std::size_t done = 0;
    int exit = 0;
    std::vector<assets::Curve> around;
    for (const std::string& file : options.around) around.push_back(load(file));
    nlohmann::ordered_json all{{"curves", nlohmann::json::array()}};
    Progress progress(static_cast<double>(options.curves.size()), "curves");
    for (const std::string& file : options.curves) {  // each is told at once: thousands take a while
        try {
            const Answer answer = name(file, around, options.closed);
            if (options.json)
                all["curves"].push_back(to_json(answer));
            else
                print(answer);
        } catch (const InputFault& fault) {  // the others are named all the same
            std::cerr << one_line(fault.what());
            exit = 2;
        }
        progress.at(static_cast<double>(++done));
    }
    // A file name may hold any bytes; JSON may not.
    if (options.json) std::cout << all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    return exit;
}

}  // namespace app
