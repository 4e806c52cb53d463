#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "app/commands/commands.hpp"
#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/rope/run.hpp"
#include "assets/curve.hpp"
#include "assets/mesh.hpp"
#include "sim/geometry/resample.hpp"
#include "sim/knot/namer.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;
using sim::geometry::TriangleTree;
using sim::geometry::Vec3;

constexpr int most_links = 100000;  // a metre of the finest thread in links of its own thickness
constexpr double most_ticks = 1e7;  // nearly three hours of the default tick

[[noreturn]] void fail(const std::string& place, const std::string& what) {
    throw InputFault(place + ": error: " + what);
}

void check_range(const char* option, double value, double low, double high, const char* unit) {
    if (value >= low && value <= high) return;  // false for nan
    std::ostringstream what;
    what << "expected " << low << " to " << high << unit << ", found " << value;
    fail(option, what.str());
}

void check(const RopeOptions& o) {
    if (o.thread != "ftl" && o.thread != "elastic") fail("--thread", "expected ftl or elastic, found " + o.thread);
    if (o.gravity && o.thread != "elastic")
        fail("--gravity", "a thread moved by ftl has no weight, expected --thread elastic beside it");
    check_range("--radius", o.radius_mm, 1e-3, 100, " mm");
    check_range("--friction", o.friction, 0, 10, "");
    check_range("--tick", o.tick_s, 1e-6, 1, " s");
    check_range("--young", o.young_MPa, 1e-3, 1e6, " MPa");
    check_range("--density", o.density_kg_m3, 1, 1e5, " kg/m^3");
    check_range("--every", static_cast<double>(o.every), 1, most_ticks, " ticks");
    if (o.links && !(*o.links >= 1 && *o.links <= most_links))
        fail(o.curve, "--links: expected 1 to " + std::to_string(most_links) + ", found " + std::to_string(*o.links));
}

std::vector<Vec3> read_curve(const std::string& file) try {
    const auto curves = assets::load_curve(file).components;
    if (curves.size() != 1) fail(file, "expected one curve, found " + std::to_string(curves.size()));
    if (curves[0].closed) fail(file, "expected an open curve, its last vertex is its first");
    const std::vector<Vec3>& nodes = curves[0].vertices;
    if (nodes.size() > most_links + 1)
        fail(file,
             "expected at most " + std::to_string(most_links + 1) + " vertices, found " + std::to_string(nodes.size()));
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        if (nodes[i] == nodes[i + 1])
            fail(file, "vertices " + std::to_string(i) + " and " + std::to_string(i + 1) + " are the same place");
    for (const Vec3& p : nodes)
        if (p.cwiseAbs().maxCoeff() > 10) fail(file, "expected coordinates within 10000 mm");
    return nodes;
} catch (const assets::AssetError& error) {
    throw InputFault(error.what());
}

TriangleTree read_obstacle(const std::string& file) try {
    return TriangleTree(assets::load_mesh(file).soup());
} catch (const assets::AssetError& error) {
    throw InputFault(error.what());
}

// The motion names nodes of the curve as it was given; after resampling it holds those at the same place along it.
void resample(rope::Experiment& experiment, int links, const RopeOptions& options) {
    const std::vector<Vec3>& given = experiment.nodes;
    std::vector<double> passed{0};
    for (std::size_t i = 0; i + 1 < given.size(); ++i)
        passed.push_back(passed.back() + (given[i + 1] - given[i]).norm());
    int previous = -1;
    for (rope::HeldNode& held : experiment.motion) {
        const int given_node = held.node;
        held.node = static_cast<int>(std::lround(passed[static_cast<std::size_t>(given_node)] / passed.back() * links));
        if (held.node == previous)
            fail(options.motion, "node " + std::to_string(given_node) +
                                     " and the one before fall together with --links " + std::to_string(links) +
                                     ", expected more links");
        previous = held.node;
    }
    std::vector<Vec3> nodes = sim::geometry::resample(given, links);
    const sim::knot::Name as_given = sim::knot::name_knot(given), as_laid = sim::knot::name_knot(nodes);
    if (as_given.certain && as_laid.certain && as_given.knot != as_laid.knot)
        fail(options.curve, "--links: the curve is knotted as " + as_given.knot + ", of " + std::to_string(links) +
                                " links as " + as_laid.knot + ", expected more links");
    experiment.nodes = std::move(nodes);
}

// Of an ftl thread the neighbours of one link of a thirtieth of the radius, far longer than it, have passed each other:
// they are too near along the thread to be contacts, and bends are limited node by node, to no better than such a link
// is long. Of a sixth they have not, nor where all links are as short.
void check_links(const RopeOptions& options, const std::vector<Vec3>& nodes) {
    const double least = 1e-3 * options.radius_mm / 10;
    std::vector<double> links;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) links.push_back((nodes[i + 1] - nodes[i]).norm());
    for (std::size_t i = 0; i < links.size(); ++i) {
        const double longer = std::max(i > 0 ? links[i - 1] : 0, i + 1 < links.size() ? links[i + 1] : 0);
        if (links[i] >= least || links[i] >= longer / 10) continue;
        std::ostringstream what;
        what << "vertices " << i << " and " << i + 1 << " are " << 1000 * links[i] << " mm apart, the next "
             << 1000 * longer << " mm: expected at least " << 1000 * least
             << " mm, a tenth of the radius, or even links: leave one out, or ask for them by --links";
        fail(options.curve, what.str());
    }
}

rope::Experiment read(const RopeOptions& options) {
    rope::Experiment experiment;
    const double radius = options.radius_mm / 1000;
    experiment.thread = {.radius = radius,
                         .friction = options.friction,
                         .friction_tool = options.friction,
                         .axial_stiffness = options.young_MPa * 1e6 * std::numbers::pi * radius * radius};
    if (options.thread == "elastic") {
        experiment.thread.elastic = {
            .young = options.young_MPa * 1e6, .density = options.density_kg_m3, .axial_over_bending = 0};
        if (options.gravity) experiment.thread.elastic->gravity = {0, 0, -9.81};
    }
    experiment.nodes = read_curve(options.curve);
    experiment.motion = rope::load_motion(options.motion, static_cast<int>(experiment.nodes.size()));
    if (options.links) resample(experiment, static_cast<int>(*options.links), options);
    if (!experiment.thread.elastic) check_links(options, experiment.nodes);
    if (experiment.thread.elastic && experiment.nodes.size() < 3)
        fail(options.links ? "--links" : options.curve,
             "an elastic thread bends at its inner nodes, expected at least 2 links");
    experiment.tick = options.tick_s;
    experiment.every = static_cast<int>(options.every);
    const double ticks = rope::ticks_of(experiment);
    if (!(ticks >= 1 && ticks <= most_ticks))
        fail(options.motion, "takes " + std::to_string(static_cast<long>(ticks)) + " ticks, expected 1 to " +
                                 std::to_string(static_cast<long>(most_ticks)));
    return experiment;
}

// Nearer than it is thick it is pushed out; where its middle line touches no side is out.
void check_start(const std::string& file, const std::vector<Vec3>& nodes, double radius, const TriangleTree& obstacle) {
    if (const int link = sim::geometry::first_nearer(nodes, obstacle, 0.1 * radius); link >= 0)
        fail(file, "link " + std::to_string(link) +
                       " of the thread starts through the obstacle, expected to start clear of it");
}

bool both_ends_held_throughout(const rope::Experiment& experiment) {
    const double end = rope::ticks_of(experiment) * experiment.tick, tick = experiment.tick;
    const auto throughout = [&](int node) {
        return std::any_of(experiment.motion.begin(), experiment.motion.end(), [&](const rope::HeldNode& held) {
            return held.node == node && held.keys.front().t <= tick && held.keys.back().t >= end - tick;
        });
    };
    return throughout(0) && throughout(static_cast<int>(experiment.nodes.size()) - 1);
}

struct Knots {
    sim::knot::Name before, after;
    bool changed() const { return before.certain && after.certain && before.knot != after.knot; }
};

Knots name_knots(const rope::Experiment& experiment, const rope::Measured& measured) {
    return {sim::knot::name_knot(experiment.nodes), sim::knot::name_knot(measured.nodes)};
}

std::string hex(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

ordered_json answer(const RopeOptions& options, const rope::Experiment& experiment, const rope::Measured& m,
                    const Knots& knots) {
    const auto percentile = [&](double share) {
        return m.tick_us[static_cast<std::size_t>(share * static_cast<double>(m.tick_us.size() - 1))];
    };
    const bool any_near = m.separation_min < 1e300;
    return {{"thread", options.thread},
            {"links", experiment.nodes.size() - 1},
            {"ticks", m.ticks},
            {"substeps", m.substeps},
            {"tick_us", {{"p50", percentile(0.5)}, {"p99", percentile(0.99)}, {"max", m.tick_us.back()}}},
            {"stretch", {{"max", m.stretch_max}, {"settled", m.stretch_settled}, {"total", m.stretch_total}}},
            {"separation", {{"min", any_near ? ordered_json(m.separation_min) : ordered_json(nullptr)}}},
            {"node_step", {{"max_over_bound", m.step_over_bound}}},
            {"pass_throughs", m.pass_throughs},
            {"tool_lag_mm", {{"max", m.lag_max * 1000}, {"final", m.lag_final * 1000}}},
            {"tension_N", {{"max", m.tension_max}}},
            {"knot", {{"before", knots.before.knot}, {"after", knots.after.knot}}},
            {"contacts", {{"max", m.contacts_max}}},
            {"state_hash", hex(m.hash)}};
}

void print(const ordered_json& a) {
    std::cout << a["links"] << " links, " << a["ticks"] << " ticks of " << a["tick_us"]["p50"] << " us (p50), "
              << a["tick_us"]["p99"] << " us (p99)\n"
              << "knot " << a["knot"]["before"].get<std::string>() << " -> " << a["knot"]["after"].get<std::string>()
              << ", pass-throughs " << a["pass_throughs"] << ", stretch at most " << a["stretch"]["max"] << '\n'
              << "tools behind by " << a["tool_lag_mm"]["max"] << " mm at most, tension at most "
              << a["tension_N"]["max"] << " N\nstate " << a["state_hash"].get<std::string>() << '\n';
}

}  // namespace

int rope_command(const RopeOptions& options) {
    check(options);
    rope::Experiment experiment = read(options);
    std::unique_ptr<TriangleTree> obstacle;
    if (!options.obstacle.empty()) obstacle = std::make_unique<TriangleTree>(read_obstacle(options.obstacle));
    experiment.obstacle = obstacle.get();
    if (obstacle) check_start(options.curve, experiment.nodes, experiment.thread.radius, *obstacle);
    std::ofstream positions;
    if (!options.out.empty()) {
        expect_writable("--out", options.out, {options.curve, options.motion, options.obstacle});
        positions.open(options.out, std::ios::binary);
        experiment.positions = &positions;
    }
    const rope::Measured measured = rope::run(experiment);
    if (!options.out.empty()) {
        positions.close();
        if (!positions) throw std::runtime_error(options.out + ": could not be written to its end");
    }

    const Knots knots = name_knots(experiment, measured);
    const ordered_json report = answer(options, experiment, measured, knots);
    options.json ? void(std::cout << report.dump(2) << '\n') : print(report);
    if (measured.pass_throughs > 0)
        throw CheckFailed(options.curve + ": the thread passed through something, see pass_throughs");
    if (knots.changed() && both_ends_held_throughout(experiment))
        throw CheckFailed(options.curve + ": the knot changed from " + knots.before.knot + " to " + knots.after.knot +
                          " while both ends were held");
    return 0;
}

}  // namespace app
