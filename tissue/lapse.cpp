// The ten lapses of the Anastomosis Lapse Index (Ghanem et al. 2016) as tests on a join's measures.
#include "tissue/lapse.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace tissue {

namespace {

constexpr double degree = EIGEN_PI / 180;

struct Test {
    const char* measure;
    double value, limit;
    bool at_least = false;
    bool fails() const { return at_least ? value < limit : value > limit; }
};

Lapse lapse(const char* name, std::initializer_list<Test> tests) {
    const auto found = std::find_if(tests.begin(), tests.end(), [](const Test& test) { return test.fails(); });
    const Test& worst = found != tests.end() ? *found : *tests.begin();
    return {name, worst.measure, worst.value, worst.limit, worst.at_least, worst.fails()};
}

template <class All, class Value>
double most(const All& all, const Value& value) {
    double worst = 0;
    for (const auto& one : all) worst = std::max(worst, value(one));
    return worst;
}

// Longest stretch of pieces that are open, round the end too, over the mean spacing; a ring needs two stitches at
// least.
double open_spacings(const Join& join, double gap) {
    double run = 0, longest = 0;
    for (std::size_t i = 0; i < 2 * join.line.size(); ++i) {
        const LinePiece& piece = join.line[i % join.line.size()];
        run = piece.gap > gap ? std::min(join.rim, run + piece.length) : 0;
        longest = std::max(longest, run);
    }
    return longest / join.rim * static_cast<double>(std::max<std::size_t>(2, join.stitches.size()));
}

double median_size(const Join& join) {
    std::vector<double> sizes;
    for (const SewnBite& bite : join.bites)
        if (bite.thread >= 0 && bite.size > 0) sizes.push_back(bite.size);
    if (sizes.empty()) return 0;
    std::sort(sizes.begin(), sizes.end());
    const std::size_t n = sizes.size();
    return 0.5 * (sizes[(n - 1) / 2] + sizes[n / 2]);
}

struct Spacing {
    double least = 1, most = 1, variation = 0;  // over the mean
};

Spacing spacing(const Join& join) {
    Spacing worst;
    for (const std::vector<double>& all : join.spacing) {
        if (all.empty()) continue;
        double sum = 0, squares = 0;
        for (const double s : all) sum += s;
        const double mean = sum / static_cast<double>(all.size());
        for (const double s : all) squares += (s / mean - 1) * (s / mean - 1);
        worst.least = std::min(worst.least, *std::min_element(all.begin(), all.end()) / mean);
        worst.most = std::max(worst.most, *std::max_element(all.begin(), all.end()) / mean);
        worst.variation = std::max(worst.variation, std::sqrt(squares / static_cast<double>(all.size())));
    }
    return worst;
}

}  // namespace

std::array<Lapse, 10> lapses(const Join& join, const LapseLimits& limits) {
    const auto sewn = [&](const auto& value) {
        return most(join.bites, [&](const SewnBite& bite) { return bite.thread >= 0 ? value(bite) : 0.0; });
    };
    const auto count = [&](const auto& is) {
        return static_cast<double>(std::count_if(join.bites.begin(), join.bites.end(), is));
    };
    const double arc = std::max(join.arc_of_pass, most(join.stitches, [](const Stitch& s) { return s.arc; })) / degree;
    const double oblique =
        most(join.stitches, [&](const Stitch& s) { return s.arc > limits.arc * degree ? 0 : s.obliqueness; }) / degree;
    const double size = sewn([](const SewnBite&bite) { return bite.size; }), median = median_size(join);
    const double strain = sewn([](const SewnBite& bite) { return bite.strain; });
    const double partial =
        count([](const SewnBite& bite) { return bite.thread >= 0 && bite.partial && !bite.both_walls; });
    const double torn = count([](const SewnBite&bite) { return bite.torn; }),
                 hole = most(join.bites, [](const SewnBite&bite) { return bite.hole; });
    const double overlap = most(join.line, [](const LinePiece& piece) { return piece.overlap; });
    const Spacing apart = spacing(join);
    double loop = 1;
    for (const Stitch& s : join.stitches)
        if (s.loop > 0) loop = std::min(loop, s.loop);
    return {lapse("disruption of suture line", {{"longest open stretch, in spacings",
                                                 open_spacings(join, limits.gap * join.wall), limits.open_spacings}}),
            lapse("back-wall stitch", {{"arc between bites of a loop [degrees]", arc, limits.arc}}),
            lapse("oblique stitch", {{"angle to straight across [degrees]", oblique, limits.obliqueness}}),
            lapse("wide bite", {{"bite, in walls", size / join.wall, limits.bite_walls},
                                {"bite, in medians", median > 0 ? size / median : 0, limits.bite_medians}}),
            lapse("partial-thickness stitch", {{"bites", partial, limits.partial_bites}}),
            lapse("unequal spacing", {{"shortest, in means", apart.least, limits.least_spacing, true},
                                      {"longest, in means", apart.most, limits.most_spacing},
                                      {"standard deviation, in means", apart.variation, limits.spacing_variation}}),
            lapse("tear", {{"holes torn to the edge", torn, limits.torn_holes},
                           {"hole, in diameters of the thread", hole / join.diameter, limits.hole_diameters}}),
            lapse("strangulation", {{"strain at the edge", strain, limits.edge_strain},
                                    {"loop, in ways along the wall", loop, limits.least_loop, true}}),
            lapse("thread in lumen",
                  {{"depth, in diameters", join.deepest_thread / join.diameter, limits.depth_diameters}}),
            lapse("overlap", {{"overlap, in walls", overlap / join.wall, limits.overlap_walls}})};
}

}  // namespace tissue
