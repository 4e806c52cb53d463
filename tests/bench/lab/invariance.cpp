#include <Eigen/Geometry>
#include <algorithm>
#include <functional>

#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/laws.hpp"
#include "tests/bench/lab/stopwatch.hpp"

namespace bench::lab {

namespace {

using Map = std::function<Vec3(const Vec3&)>;

constexpr int pull_ticks = 400;  // of 0.02 mm at either end: an overhand of 120 links is tight after some 250
constexpr int while_loose = 75;
constexpr double pull_step = 0.02e-3;  // [m]

// What becomes of a thread before it is pulled, and how its nodes are to be read afterwards.
struct Image {
    const char *id, *words;
    Map map = [](const Vec3& p) { return p; };
    double scale = 1;
    bool reversed = false;
    std::optional<double> path_bound;  ///< [D]
};

using Path = std::vector<std::vector<Vec3>>;

// Every tick's nodes of the image of an overhand whose ends are pulled apart.
Path pulled(const Image& image) {
    const double radius = ThreadDef{}.radius;
    std::vector<Vec3> nodes = loose_thread(Knot::trefoil, 120, 2 * radius, radius).nodes;
    const Vec3 on = image.map(pull_step * (nodes.back() - nodes.front()).normalized());
    for (Vec3& p : nodes) p = image.map(p);
    if (image.reversed) std::reverse(nodes.begin(), nodes.end());
    Thread thread({.radius = image.scale * radius}, nodes);
    Hands hands(thread);
    Path path;
    for (int i = 1; i <= pull_ticks; ++i) {
        hands.move(thread, image.reversed ? on : Vec3(-on), image.reversed ? Vec3(-on) : on);
        path.emplace_back(thread.nodes().begin(), thread.nodes().end());
        if (image.reversed) std::reverse(path.back().begin(), path.back().end());
    }
    return path;
}

// Largest difference of a node from the image of the plain thread's in the first ticks, in thread diameters of the
// image.
double farthest(const Path& plain, const Path& image, const Image& of, int first_ticks) {
    double most = 0;
    for (std::size_t t = 0; t < static_cast<std::size_t>(first_ticks); ++t)
        for (std::size_t i = 0; i < plain[t].size(); ++i)
            most = std::max(most, (of.map(plain[t][i]) - image[t][i]).norm());
    return most / (2 * of.scale * ThreadDef{}.radius);
}

double distance_of_ends(const Path& path, double scale) {
    return (path.back().back() - path.back().front()).norm() / (2 * scale * ThreadDef{}.radius);
}

Map grown(double scale) {
    return [scale](const Vec3& p) { return Vec3(scale * p); };
}

std::vector<Image> images() {
    const Eigen::Quaterniond turn = Eigen::Quaterniond(0.5, 0.1, -0.7, 0.3).normalized();
    const Map mirror = [](const Vec3&p) { return Vec3(-p.x(), p.y(), p.z()); },
              turned = [turn](const Vec3&p) { return Vec3(turn * p); };
    const Map same = grown(1);
    // A changed sign and a power of two round nothing: the same bits. All else rounds differently; a thousandth of the
    // thickness while the knot is loose is far above rounding, and far below what can be seen.
    return {{"mirror", "its mirror image", mirror, 1, false, 0.0},
            {"turn", "turned", turned, 1, false, 1e-3},
            {"scale-thousandth", "a thousandth of its size", grown(1e-3), 1e-3, false, 1e-3},
            {"scale-thousand", "a thousand times its size", grown(1e3), 1e3, false, 1e-3},
            {"scale-2-10", "1024 times its size", grown(0x1p10), 0x1p10, false, 0.0},
            {"reversed", "its nodes in reverse order", same, 1, true, 1e-3}};
}

}  // namespace

std::vector<Row> invariance_rows(bool) {
    std::vector<Row> rows;
    const Path plain = pulled(Image{.id = "", .words = "", .path_bound = {}});
    for (const Image& image : images()) {
        const Stopwatch watch;
        const Path path = pulled(image);
        const std::string id = std::string("same-") + image.id,
                          what = std::string("an overhand pulled tight, and ") + image.words + ": ";
        rows.push_back({.id = id + "-loose",
                        .what = what + "farthest nodes while it is loose",
                        .value = farthest(plain, path, image, while_loose),
                        .unit = "D",
                        .bound = image.path_bound,
                        .error = {},
                        .seconds = watch.seconds()});
        rows.push_back({.id = id + "-path",
                        .what = what + "farthest nodes at any time",
                        .value = farthest(plain, path, image, pull_ticks),
                        .unit = "D",
                        .bound = {},
                        .error = {}});
        // What rounding decides in a jam is which strand gives first, not how much thread the knot takes up.
        const double difference = std::abs(distance_of_ends(plain, 1) - distance_of_ends(path, image.scale));
        rows.push_back({.id = id + "-end",
                        .what = what + "difference in what the tight knot takes up",
                        .value = difference,
                        .unit = "D",
                        .bound = 0.5,
                        .error = {}});
    }
    const double length = static_cast<double>(plain.back().size() - 1);  // links are a diameter each
    rows.push_back({.id = "same-takes-up",
                    .what = "that overhand in the end: takes up",
                    .value = length - distance_of_ends(plain, 1),
                    .unit = "D",
                    .bound = {},
                    .error = {}});
    return rows;
}

}  // namespace bench::lab
