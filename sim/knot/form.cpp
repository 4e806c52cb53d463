#include "sim/knot/form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/at.hpp"

namespace sim::knot {

namespace {

struct Chord {
    Vec3 middle, along;
};

std::vector<Chord> chords_of(const std::vector<Vec3>& strand, int step) {
    const int last = static_cast<int>(strand.size()) - 1;
    std::vector<Chord> chords;
    for (int i = 0; i < last; i += step) {
        const Vec3 &a = strand[at(i)], &b = strand[at(std::min(i + step, last))];
        chords.push_back({0.5 * (a + b), b - a});
    }
    return chords;
}

// Crossings that views show on average between two chords: Gauss' integral by the midpoint rule, good where they are
// far from each other, and no more than one where they are near.
double crossings(const Chord& a, const Chord& b) {
    const Vec3 apart = a.middle - b.middle;
    const double volume = std::abs(apart.dot(a.along.cross(b.along))), distance2 = apart.squaredNorm();
    const double whole = 2 * std::numbers::pi * distance2 * std::sqrt(distance2);
    return volume < whole ? volume / whole : 1;
}

// Of all pairs of chords but neighbours, between which a bend counts as a crossing.
class Crossings {
  public:
    explicit Crossings(const std::vector<Chord>& chords)
        : count_(static_cast<int>(chords.size())), of_(chords.size() * chords.size()) {
        for (int i = 0; i < count_; ++i)
            for (int j = i + 3; j < count_; ++j)
                of_[at(i * count_ + j)] = of_[at(j * count_ + i)] = crossings(chords[at(i)], chords[at(j)]);
    }

    // Of this chord with those from `first` to before `last`.
    double with(int chord, int first, int last) const {
        double sum = 0;
        for (int j = first; j < last; ++j) sum += of_[at(chord * count_ + j)];
        return sum;
    }

    // The chord at which the loop is half way round: of the cuts where the halves cross most, the middle one.
    int middle_of_loop() const {
        constexpr double nearly_most = 0.6;  // half of two throws: the way round the loop crosses nothing
        std::vector<double> between{0};
        for (int cut = 0; cut < count_; ++cut)
            between.push_back(between.back() + with(cut, cut + 1, count_) - with(cut, 0, cut));
        const auto most = std::max_element(between.begin(), between.end());
        auto first = most, last = most;
        while (first != between.begin() && *(first - 1) >= nearly_most * *most) --first;
        while (last + 1 != between.end() && *(last + 1) >= nearly_most * *most) ++last;
        return static_cast<int>((first - between.begin()) + (last - between.begin())) / 2;
    }

    // Of the chords from `first` to before `last`, those where all but a twentieth at either end of the crossings with
    // the chords from `others` to before `others_end` are.
    struct Zone {
        int first, last;
    };
    Zone zone(int first, int last, int others, int others_end) const {
        constexpr double left_out = 0.05;
        double all = 0, sum = 0;
        for (int i = first; i < last; ++i) all += with(i, others, others_end);
        Zone zone{last, last};
        for (int i = first; i < last; ++i) {
            sum += with(i, others, others_end);
            if (zone.first == last && sum > left_out * all) zone.first = i;
            if (sum >= (1 - left_out) * all) return {zone.first, i + 1};
        }
        return zone;
    }

  private:
    int count_;
    std::vector<double> of_;
};

// Sum of the chords between unit tangents at these vertices, 2 sin(angle / 2) each.
double turning(const std::vector<Vec3>& strand, int first, int last) {
    double total = 0.0;
    for (int i = std::max(1, first); i <= last && i + 1 < static_cast<int>(strand.size()); ++i)
        total += ((strand[at(i + 1)] - strand[at(i)]).normalized() - (strand[at(i)] - strand[at(i - 1)]).normalized())
                     .norm();
    return total;
}

// Where the two halves of a strand cross each other, in its vertices.
struct Halves {
    int first, loop_first, loop_last, last;
};

Halves halves_of(const std::vector<Vec3>& strand) {
    constexpr int enough = 64;  // finer chords place neither the loop nor the zones better
    const int vertices = static_cast<int>(strand.size()), step = std::max(1, (vertices - 2 + enough) / enough);
    const std::vector<Chord> chords = chords_of(strand, step);
    const Crossings crossings(chords);
    const int middle = crossings.middle_of_loop(), count = static_cast<int>(chords.size());
    const auto a = crossings.zone(0, middle, middle, count), b = crossings.zone(middle, count, 0, middle);
    const auto vertex = [&](int chord) { return std::min(step * chord, vertices - 1); };
    return {vertex(a.first), vertex(a.last), vertex(b.first), vertex(b.last)};
}

double length(const std::vector<Vec3>& strand, int first, int last) {
    double sum = 0;
    for (int i = first; i < last; ++i) sum += (strand[at(i + 1)] - strand[at(i)]).norm();
    return sum;
}

}  // namespace

double unevenness(const std::vector<Vec3>& strand) {
    const Halves halves = halves_of(strand);
    const double a = turning(strand, halves.first, halves.loop_first),
                 b = turning(strand, halves.loop_last, halves.last);
    return a + b > 0 ? std::abs(a - b) / (a + b) : 0;
}

Extent extent(const std::vector<Vec3>& strand) {
    const Halves rough = halves_of(strand);
    const int margin = (rough.last - rough.first) / 8, from = std::max(0, rough.first - margin);
    const auto to = std::min(strand.size(), at(rough.last + margin + 1));
    const std::vector<Vec3> knot(strand.begin() + from, strand.begin() + static_cast<std::ptrdiff_t>(to));
    const Halves fine = halves_of(knot);
    const double before = length(strand, 0, from);
    const auto at_vertex = [&](int vertex) { return before + length(knot, 0, vertex); };
    return {at_vertex(fine.first), at_vertex(fine.loop_first), at_vertex(fine.loop_last), at_vertex(fine.last)};
}

}  // namespace sim::knot
