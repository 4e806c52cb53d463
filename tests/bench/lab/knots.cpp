#include "tests/bench/lab/knots.hpp"

#include "sim/geometry/resample.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/throws.hpp"

namespace bench::lab {

namespace {

// Curves p127 (an Aberdeen knot of one throw), p009 (opened) and p129 (a bowline, its end outside the eye) of
// tests/data/curves, their strands driven apart as far as their length allows, in a hundredth of it.
const std::vector<Vec3> figure_eight{
    {-31.7, 5.4, -2.0}, {-29.6, 5.1, -1.9}, {-27.5, 4.8, -1.7}, {-25.4, 4.6, -1.6}, {-23.3, 4.3, -1.4},
    {-21.2, 4.1, -1.3}, {-19.2, 3.8, -1.2}, {-17.1, 3.6, -1.0}, {-15.0, 3.3, -0.9}, {-12.9, 3.1, -0.7},
    {-10.8, 2.8, -0.6}, {-8.7, 2.6, -0.5},  {-6.6, 2.4, -0.5},  {-4.5, 2.5, -0.7},  {-2.4, 2.7, -0.7},
    {-0.5, 2.3, -0.1},  {0.7, 1.0, 1.0},    {0.6, -0.2, 2.7},   {-1.1, -0.5, 3.8},  {-2.8, 0.6, 3.8},
    {-3.0, 2.3, 2.9},   {-2.6, 1.6, 1.1},   {-1.7, 0.4, -0.4},  {0.0, 0.1, -1.4},   {2.1, 0.5, -1.5},
    {4.0, 0.7, -0.7},   {5.1, -0.1, 0.8},   {4.4, -1.7, 1.9},   {2.5, -2.6, 1.6},   {0.5, -2.1, 1.1},
    {-0.8, -0.6, 1.5},  {-0.6, 1.2, 2.5},   {1.2, 2.0, 3.1},    {2.8, 1.1, 2.3},    {3.1, -0.4, 0.9},
    {4.1, -1.7, -0.4},  {5.9, -2.5, -1.0},  {7.9, -3.2, -1.3},  {9.9, -3.7, -1.5},  {12.0, -4.0, -1.5},
    {14.1, -4.3, -1.3}, {16.2, -4.5, -1.1}, {18.3, -4.7, -0.9}, {20.4, -4.9, -0.7}, {22.5, -5.1, -0.5},
    {24.6, -5.3, -0.3}, {26.7, -5.5, -0.1}, {28.7, -5.7, 0.1},  {30.8, -5.9, 0.3}};
const std::vector<Vec3> five_two{
    {9.5, -6.6, 7.7},  {8.4, -5.9, 6.8},   {7.3, -5.2, 5.9},   {6.2, -4.5, 5.1},   {5.1, -3.7, 4.2},
    {4.9, -2.8, 3.6},  {5.7, -1.5, 3.5},   {6.1, 0.0, 3.4},    {5.8, 1.4, 2.9},    {4.8, 2.2, 2.0},
    {3.6, 2.3, 1.0},   {2.6, 2.2, -0.2},   {1.6, 2.1, -1.4},   {0.5, 2.4, -2.5},   {-0.6, 3.3, -3.2},
    {-1.1, 4.8, -3.1}, {-0.8, 6.2, -2.7},  {0.4, 7.2, -2.6},   {1.9, 7.4, -2.6},   {3.4, 6.8, -2.4},
    {4.6, 6.0, -1.9},  {5.6, 5.0, -1.3},   {6.5, 3.7, -0.8},   {6.9, 2.3, -0.4},   {6.6, 0.8, -0.1},
    {5.5, -0.2, 0.3},  {4.1, -0.8, 0.8},   {2.7, -1.2, 1.3},   {1.4, -1.9, 2.1},   {0.5, -2.7, 3.0},
    {-0.4, -3.6, 4.0}, {-1.6, -4.5, 4.3},  {-3.0, -5.1, 3.7},  {-4.1, -5.1, 2.6},  {-5.1, -4.7, 1.5},
    {-6.1, -4.0, 0.4}, {-6.8, -3.2, -0.7}, {-7.0, -2.4, -2.0}, {-6.5, -1.3, -3.1}, {-5.4, -0.3, -3.2},
    {-4.2, 0.6, -2.7}, {-3.1, 1.5, -2.0},  {-2.1, 2.5, -1.2},  {-1.0, 3.5, -0.9},  {0.2, 4.4, -1.5},
    {0.9, 4.9, -2.7},  {0.7, 5.3, -4.2},   {-0.4, 5.8, -5.2},  {-2.0, 6.0, -5.4},  {-3.5, 5.7, -5.1},
    {-4.8, 4.9, -4.6}, {-5.9, 4.0, -4.1},  {-6.9, 3.0, -3.3},  {-7.4, 2.1, -2.1},  {-7.2, 1.1, -1.0},
    {-6.1, 0.1, -0.2}, {-4.8, -0.7, 0.0},  {-3.5, -1.6, 0.2},  {-2.4, -2.7, 0.5},  {-1.6, -4.0, 0.8},
    {-0.8, -5.3, 1.2}, {-1.2, -6.8, 1.5},  {-1.7, -8.3, 1.8},  {-2.1, -9.8, 2.0},  {-2.6, -11.3, 2.3}};
const std::vector<Vec3> bowline{
    {20.2, 3.0, 0.4},   {18.7, 2.9, 0.5},   {17.1, 2.8, 0.5},   {15.5, 2.7, 0.6},   {13.9, 2.5, 0.7},
    {12.4, 2.4, 0.7},   {10.8, 2.3, 0.7},   {9.2, 2.1, 0.7},    {7.6, 2.0, 0.7},    {6.1, 1.8, 0.6},
    {5.1, 0.9, -0.1},   {4.9, -0.5, -0.9},  {3.8, -1.5, -0.6},  {2.8, -1.5, 0.5},   {1.8, -0.8, 1.5},
    {1.1, 0.6, 1.6},    {0.8, 1.9, 0.9},    {1.2, 3.0, -0.1},   {2.1, 3.4, -1.3},   {3.2, 2.8, -2.2},
    {3.7, 1.4, -2.2},   {3.7, 0.3, -1.1},   {4.1, -0.5, 0.1},   {5.1, -1.6, 0.7},   {5.0, -2.9, 1.3},
    {3.6, -3.4, 1.7},   {2.1, -3.7, 2.0},   {0.5, -3.9, 2.1},   {-1.0, -4.1, 2.1},  {-2.6, -4.4, 2.1},
    {-4.1, -4.6, 2.1},  {-5.7, -4.7, 2.0},  {-7.3, -4.9, 1.9},  {-8.9, -4.9, 1.9},  {-10.3, -4.4, 1.5},
    {-10.6, -3.2, 0.8}, {-9.5, -2.2, 0.3},  {-8.0, -1.7, 0.1},  {-6.5, -1.5, 0.1},  {-4.9, -1.3, 0.2},
    {-3.3, -1.1, 0.2},  {-1.8, -0.9, 0.2},  {-0.2, -0.7, 0.1},  {1.3, -0.2, 0.1},   {2.7, 0.3, 0.7},
    {4.2, 0.4, 1.2},    {5.7, 0.3, 0.8},    {6.3, 0.8, -0.4},   {5.3, 1.8, -1.0},   {3.8, 2.0, -0.8},
    {2.3, 1.7, -0.9},   {0.7, 1.5, -1.2},   {-0.9, 1.5, -1.2},  {-2.4, 1.5, -1.2},  {-4.0, 1.4, -1.2},
    {-5.6, 1.3, -1.3},  {-7.2, 1.2, -1.4},  {-8.7, 1.2, -1.5},  {-10.3, 1.1, -1.7}, {-11.9, 1.1, -1.8},
    {-13.4, 1.2, -2.0}, {-15.0, 1.3, -2.2}, {-16.6, 1.4, -2.4}, {-18.1, 1.5, -2.6}, {-19.7, 1.5, -2.9}};

// Ends that lead out far to either side, so that they can go straight on for ever.
constexpr double out = 6, up = 2;

std::vector<Vec3> tied_open(const std::vector<sim::knot::Throw>& throws) {
    return tied(throws, {{0, 0, -6}}, {out, 0, up});
}

}  // namespace

const std::array<KnownKnot, 8> known_knots{{{Knot::trefoil, "trefoil", "3_1"},
                                            {Knot::figure_eight, "figure eight", "4_1"},
                                            {Knot::five_one, "five-one", "5_1"},
                                            {Knot::five_two, "five-two", "5_2"},
                                            {Knot::square, "square", "3_1#m3_1"},
                                            {Knot::granny, "granny", "3_1#3_1"},
                                            {Knot::surgeons, "surgeon's", "m3_1#5_1"},
                                            {Knot::bowline, "bowline", "m6_2"}}};

const KnownKnot& known(Knot knot) {
    return known_knots[static_cast<std::size_t>(knot)];
}

std::vector<Vec3> rounded(const std::vector<Vec3>& corners, int times, int pieces) {
    std::vector<Vec3> path = sim::geometry::resample(corners, pieces), before;
    for (int k = 0; k < times; ++k) {
        before = path;
        for (std::size_t i = 1; i < static_cast<std::size_t>(pieces); ++i)
            path[i] = 0.5 * before[i] + 0.25 * (before[i - 1] + before[i + 1]);
    }
    return path;
}

std::vector<Vec3> loose(Knot knot) {
    constexpr int corners = 24, of_a_table = 8;
    switch (knot) {
        case Knot::trefoil:
            return rounded(tied_open({{1, true}}), corners);
        case Knot::figure_eight:
            return rounded(figure_eight, of_a_table);
        case Knot::five_one:
            return rounded(tied_open({{2, true}}), corners);
        case Knot::five_two:
            return rounded(five_two, of_a_table);
        case Knot::square:
            return rounded(tied_open({{1, true}, {1, false}}), corners);
        case Knot::granny:
            return rounded(tied_open({{1, true}, {1, true}}), corners);
        case Knot::surgeons:
            return rounded(tied_open({{2, true}, {1, false}}), corners);
        case Knot::bowline:
            return rounded(bowline, of_a_table);
    }
    return {};
}

std::vector<Vec3> looped(Knot knot, double deep) {
    constexpr int corners = 24, pieces = 300;  // of the same length as those of loose()
    const double low = -3 - deep;
    const std::vector<Vec3> loop{{-2.5, 0, low}, {0, 0, low}, {2.5, 0, low}};
    return rounded(tied({{1, true}, {1, knot == Knot::granny}}, loop, {out, 0, up}), corners, pieces);
}

}  // namespace bench::lab
