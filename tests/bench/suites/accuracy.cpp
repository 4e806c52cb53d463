#include "tests/bench/suites/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/rod/rod.hpp"
#include "tests/bench/lab/bends.hpp"
#include "tests/bench/lab/clasp.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/crossing.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/incline.hpp"
#include "tests/bench/lab/knots.hpp"
#include "tests/bench/lab/loose_overhand.hpp"
#include "tests/bench/lab/plastic_set.hpp"
#include "tests/bench/lab/rod_capstan.hpp"
#include "tests/bench/lab/rod_cases.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/strand_capstan.hpp"
#include "tests/bench/lab/thread_rope.hpp"
#include "tests/bench/lab/tight_elastic.hpp"
#include "tests/bench/lab/words.hpp"

namespace bench::suites {

using namespace lab;

namespace {

using sim::rod::Rod;
using sim::thread::RodDef;
using sim::thread::Vec3;

void add_case(Suite& suite, const RodCase& c, const std::vector<int>& resolutions) {
    double coarser = 0, order = 0;
    for (const int links : resolutions) {
        const double begin = processor_time(), error = 100 * c.at(links).error(), seconds = processor_time() - begin;
        Row row{.id = c.id + "-n" + std::to_string(links),
                .what = c.what + ", " + std::to_string(links) + " links: error",
                .value = std::abs(error),
                .unit = "%",
                .bound = {},
                .error = {},
                .seconds = seconds};
        if (links >= c.bound_links) row.bound = 100 * c.bound;
        suite.rows.push_back(row);
        order = std::log2(coarser / std::abs(error));
        coarser = std::abs(error);
    }
    suite.rows.push_back({.id = c.id + "-order",
                          .what = c.what + ": order of the last halving of links",
                          .value = order,
                          .unit = "order",
                          .bound = {},
                          .error = {}});
}

// A rod bent and twisted in space between two clamps.
std::vector<Vec3> shape(double scale, bool mirrored) {
    constexpr int links = 60;
    constexpr double turn = 3;
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.push_back(scale * Vec3(i / 60.0, 0, 0));
    const double r = 1e-3 * scale;
    Rod rod({.radius = r, .young = 1, .poisson = 0.3, .density = 0}, nodes);
    const double z = mirrored ? -1 : 1;
    const Vec3 end = scale * Vec3(0.6, 0.2, 0.3 * z), along = scale / 60 * Vec3(0.6, 0, 0.8 * z);
    const Vec3 first = nodes[0], second = nodes[1];
    constexpr int steps = 20;
    for (int s = 1; s <= steps; ++s) {
        const double u = static_cast<double>(s) / steps;
        const Vec3 last = nodes.back() + u * (end - nodes.back()),
                   before = last - scale / 60 * ((1 - u) * Vec3(1, 0, 0) + u * along / along.norm()).normalized();
        const sim::thread::Hold holds[] = {{0, first}, {1, second}, {links - 1, before}, {links, last}};
        for (int i = 0; i < 10 && !rod.step({.holds = holds, .turn = u * turn * z}, 0).settled; ++i) {
        }
    }
    std::vector<Vec3> found;
    for (const Vec3& p : rod.nodes()) found.push_back(Vec3(p.x(), p.y(), z * p.z()) / scale);
    return found;
}

double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

void add_laws(Suite& suite) {
    const auto add = [&](const char* id, const char* what, double value, double bound) {
        suite.rows.push_back({.id = id, .what = what, .value = value, .unit = "L", .bound = bound, .error = {}});
    };
    const auto plain = shape(1, false);
    add("mirrored-apart", "bent and twisted rod and its mirror image: apart", apart(plain, shape(1, true)), 1e-6);
    add("scaled-1024-apart", "the same 1024 times as large: apart", apart(plain, shape(1024, false)), 1e-6);
    add("scaled-1e-3-apart", "a thousandth as large: apart", apart(plain, shape(1e-3, false)), 1e-6);
}

// Who is drawn over a cylinder: the rod alone, or as a thread.
struct Drawn {
    const char *id, *what;
    Compared (*ratio)(double friction, double wrap, double turn, double tick);
    double (*slides)(double friction, double wrap, double turn, double share);
    double most_creep;  ///< In a second [D].
    bool has_corners;   ///< Its nodes carry what a polyline's do.
};

constexpr double half_turn = std::numbers::pi, degree = std::numbers::pi / 180;

void add_capstan_ratio(Suite& suite, const Drawn& drawn, double half_turns, double friction, int turn, double tick) {
    const double begin = processor_time(), phi = half_turns * half_turn, theta = turn * degree;
    const Compared found = drawn.ratio(friction, phi, theta, tick);
    const std::string wrap = whole(2 * half_turns), mu = whole(10 * friction), ms = whole(1000 * tick);
    suite.rows.push_back({.id = drawn.id + ("-" + wrap) + "-mu" + mu + "-turn" + std::to_string(turn) + "-tick" + ms,
                          .what = drawn.what + (", " + wrap) + " quarter turns, friction 0." + mu + ", links of " +
                                  std::to_string(turn) + " degrees, ticks of " + ms + " ms: error of the ratio",
                          .value = 100 * std::abs(found.error()),
                          .unit = "%",
                          .bound = 5,
                          .error = {},
                          .seconds = processor_time() - begin});
    if (drawn.has_corners)
        suite.rows.back().error = 100 * std::abs(found.found / capstan_of_nodes(friction, phi, theta) - 1);
}

void add_capstan_holds(Suite& suite, const Drawn& drawn, double friction) {
    const std::string mu = whole(10 * friction), id = drawn.id,
                      what = drawn.what + (", one half turn, friction 0." + mu) + ": moved in a second at ";
    const auto moved = [&](double share) { return drawn.slides(friction, half_turn, 10 * degree, share); };
    suite.rows.push_back({.id = id + "-holds-mu" + mu,
                          .what = what + "95 % of what slides",
                          .value = moved(0.95),
                          .unit = "D",
                          .bound = drawn.most_creep,
                          .error = {}});
    suite.rows.push_back({.id = id + "-slides-mu" + mu,
                          .what = what + "105 %",
                          .value = moved(1.05),
                          .unit = "D",
                          .bound = 1,
                          .must = Must::be_at_least,
                          .error = {}});
}

// Sliding in two ticks and two links, held below what slides and let go above it.
void add_capstan(Suite& suite, const Drawn& drawn, bool quick) {
    for (const double half_turns : quick ? std::vector{1.0} : std::vector{0.5, 2.0, 4.0})
        for (const double friction : {0.1, 0.2, 0.3})
            for (const int turn : {10, 20})
                for (const double tick : {1e-3, 4e-3})
                    add_capstan_ratio(suite, drawn, half_turns, friction, turn, tick);
    for (const double friction : {0.1, 0.3}) add_capstan_holds(suite, drawn, friction);
}

// 200 links of D of a suture under its own weight, one end held, the other led to and fro; no contact.
void add_speed(Suite& suite, double speed) {
    constexpr int links = 200, ticks = 600;
    constexpr double link = 0.085e-3, length = links * link, tick = 1e-3, reach = 0.95 * length;
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.emplace_back(link * i, 0, 0);
    Rod rod({.gravity = {0, 0, -9.81}}, nodes);
    std::vector<double> us, steps;
    double strain = 0;
    Vec3 end = nodes.back();
    for (int t = 0; t < ticks; ++t) {
        end += speed * tick * (t / 10 % 2 == 0 ? Vec3(-1, 0.3, 0) : Vec3(0.8, 0, -0.3));
        if (end.norm() > reach) end *= reach / end.norm();
        const sim::thread::Hold holds[] = {{0, nodes[0]}, {links, end}};
        const double begin = processor_time();
        steps.push_back(rod.step({holds}, tick).iterations);
        us.push_back(1e6 * (processor_time() - begin));
        for (int k = 0; k < links; ++k)
            strain = std::max(strain, std::abs(rod.tension(k)) / rod.def().axial_stiffness(link));
    }
    const std::string mm_s = std::to_string(std::lround(1000 * speed)), id = "rod-200-at-" + mm_s,
                      what = "200 links of 6-0, one end led at " + mm_s + " mm/s: ";
    const auto add = [&](const char* name, const char* of, double value, const char* unit) {
        suite.rows.push_back(
            {.id = id + name, .what = what + of, .value = value, .unit = unit, .bound = {}, .error = {}});
    };
    add("-p50", "median of a tick", percentile(us, 0.5), "us");
    add("-p99", "99 of 100 ticks", percentile(us, 0.99), "us");
    add("-worst", "slowest tick", percentile(us, 1), "us");
    add("-steps", "Newton steps of 99 of 100", percentile(steps, 0.99), "count");
    add("-strain", "largest strain", strain, "ratio");
}

// What a pull by the elastic thread came to. Without friction nothing keeps strands where they press: what bounds ask
// for is asked of sutures.
void add_pull(Suite& suite, const char* knot, const PullDef& def, const std::vector<Vec3>& start) {
    ThreadRope rope(def, start);
    const PullFigures found = pull(rope, def, start);
    const bool many = def.links > 200;
    const std::string mu = whole(10 * def.friction), links = std::to_string(def.links);
    const std::string id = std::string("elastic-pull-") +
                           (knot == std::string("overhand") ? "" : knot + std::string("-")) + links + "-mu" + mu;
    const std::string what = std::string("elastic, ") + knot + " pull, " + links + " links, friction 0." + mu + ": ";
    const auto add = [&](const char* name, const char* of, double value, const char* unit,
                         std::optional<double> bound = {}, Must must = Must::be_at_most) {
        suite.rows.push_back({.id = id + name,
                              .what = what + of,
                              .value = value,
                              .unit = unit,
                              .bound = bound,
                              .must = must,
                              .error = {}});
    };
    std::optional<double> most_p50, most_p99, least_gap;
    if (def.friction > 0) most_p50 = many ? 1500 : 650, least_gap = 0.99;
    if (def.friction > 0 && !many) most_p99 = 1000;
    add("-p50", "median tick", found.tick_p50, "us", most_p50);
    add("-p99", "99 of 100 ticks", found.tick_p99, "us", most_p99);
    add("-worst", "slowest tick", found.tick_max, "us");
    add("-tight-p50", "median tick when tight", found.tight_p50, "us", most_p50);
    add("-tight-p99", "99 of 100 ticks when tight", found.tight_p99, "us", most_p99);
    add("-gap", "smallest gap until it is tight", found.gap_pull, "D", least_gap, Must::be_at_least);
    add("-gap-over", "smallest gap beyond", found.gap_over, "D", least_gap, Must::be_at_least);
    add("-kept", "knot kept", found.knot_kept, "count", 1, Must::be_at_least);
    add("-passes", "pass-throughs", found.pass_throughs, "count", 0);
}

// That of `carrel bench speed`.
void add_overhand_pull(Suite& suite, int links, double friction) {
    const PullDef def{.links = links, .friction = friction, .elastic = true};
    add_pull(suite, "overhand", def, overhand(def.links, def.length));
}

void add_square_pull(Suite& suite, int links) {
    const PullDef def{.links = links, .friction = 0.2, .waits_at = 30, .tight_below = 34, .elastic = true};
    add_pull(suite, "square", def, loose_thread(Knot::square, links, def.link(), 0.5 * def.link()).nodes);
}

}  // namespace

Suite accuracy_suite(bool quick, const Progress& progress) {
    Suite suite{"accuracy", {}};
    const std::vector<int> resolutions = quick ? std::vector{20, 40} : std::vector{20, 40, 80, 160};
    for (const RodCase& c : rod_cases()) {
        if (progress) progress(c.what);
        add_case(suite, c, resolutions);
    }
    for (const Drawn& drawn :
         {Drawn{"capstan", "capstan", rod_capstan, rod_slides, 1e-4, true},
          Drawn{"elastic-capstan", "elastic thread, capstan", elastic_capstan, elastic_slides, 0.1, false}}) {
        if (progress) progress(drawn.what);
        add_capstan(suite, drawn, quick);
    }
    for (const Row& row : strand_capstan_rows(quick)) suite.rows.push_back(row);
    if (progress) progress("loose overhands");
    for (const Row& row : loose_overhand_rows(quick)) suite.rows.push_back(row);
    if (progress) progress("tight overhands and clasps");
    for (const Row& row : tight_elastic_rows(quick)) suite.rows.push_back(row);
    for (const Row& row : clasp_rows(quick)) suite.rows.push_back(row);
    add_laws(suite);
    for (const double speed : {0.03, 0.3}) add_speed(suite, speed);
    if (progress) progress("elastic knots pulled tight");
    for (const double friction : {0.0, 0.2}) add_overhand_pull(suite, 200, friction);
    add_square_pull(suite, 200);
    if (!quick) add_overhand_pull(suite, 400, 0.2), add_square_pull(suite, 400);
    if (progress) progress("elastic thread on inclines");
    for (const Row& row : incline_rows(quick)) suite.rows.push_back(row);
    if (progress) progress("elastic thread across itself");
    for (const Row& row : crossing_rows(quick)) suite.rows.push_back(row);
    if (progress) progress("elastic bends and loops");
    for (const Row& row : bend_rows(quick)) suite.rows.push_back(row);
    if (progress) progress("plastic set");
    for (const Row& row : plastic_set_rows(quick)) suite.rows.push_back(row);
    return suite;
}

}  // namespace bench::suites
