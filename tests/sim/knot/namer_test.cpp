#include "sim/knot/namer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

namespace sim::knot {

namespace {

const std::string curves = std::string(CARREL_SOURCE) + "/tests/data/curves/";

std::vector<Vec3> read_curve(const std::string& file) {
    std::ifstream in(curves + file);
    std::vector<Vec3> points;
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields(line);
        if (double x, y, z; fields >> x >> y >> z) points.emplace_back(x, y, z);
    }
    return points;
}

// "4_1#3_1" and "m4_1#3_1" are one type: the labels' own spelling of it.
struct Labelled {
    std::string file, canonical, surgical;
    bool closed = false, flat = false, amphichiral = false;
};

std::vector<Labelled> labelled_knots() {
    std::ifstream in(curves + "labels.json");
    std::vector<Labelled> result;
    const nlohmann::json labels = nlohmann::json::parse(in);
    for (const auto& label : labels["curves"])
        if (label["kind"] == "knot" && !label.contains("distribution"))
            result.push_back(
                {label["file"], label["canonical"], label.value("surgical", ""), label["components"][0]["closed"]});
    return result;
}

void PrintTo(const Labelled& curve, std::ostream* out) {
    *out << curve.file << ' ' << curve.canonical;
}

class LabelledCurve : public testing::TestWithParam<Labelled> {};

// Ropes smooth, crumpled, tight, on a lattice, with repeated vertices: each must get exactly its own name.
TEST_P(LabelledCurve, GetsItsName) {
    const Name name = name_knot(read_curve(GetParam().file), GetParam().closed);
    if (GetParam().canonical == "10_48") {  // Its two hands share every invariant we compute.
        EXPECT_FALSE(name.certain);
        EXPECT_EQ(name.candidates, (std::vector<std::string>{"10_48", "m10_48"}));
        return;
    }
    EXPECT_EQ(name.knot, GetParam().canonical) << "left: " << name.crossings_reduced;
    EXPECT_TRUE(name.certain);
    if (GetParam().flat) {
        EXPECT_EQ(name.throws, GetParam().surgical);
    }
}

INSTANTIATE_TEST_SUITE_P(Public, LabelledCurve, testing::ValuesIn(labelled_knots()),
                         [](const auto& curve) { return curve.param.file.substr(0, curve.param.file.find('.')); });

// A noose is the unknot as a whole; a namer that stops there tells the surgeon there is nothing to undo.
TEST(SurgicalReading, ASlipKnotIsNoPlainRope) {
    EXPECT_EQ(name_knot(read_curve("p126.xyz")).surgical, "slip");
    EXPECT_EQ(name_knot(read_curve("p002.xyz")).surgical, "");
}

// 2=1 and 1=2 are the same type up to the mirror: only the order met from the loop tells them apart. Reading the
// surgeon's knot from its free ends inwards would call it reversed.
TEST(SurgicalReading, OrderIsReadFromTheLoopOutwards) {
    EXPECT_EQ(name_knot(read_curve("p109.xyz")).surgical, "surgeon's");
    EXPECT_EQ(name_knot(read_curve("p103.xyz")).surgical, "square");
    EXPECT_EQ(name_knot(read_curve("p105.xyz")).surgical, "granny");
    EXPECT_EQ(name_knot(read_curve("p100.xyz")).surgical, "overhand");
    EXPECT_EQ(name_knot(read_curve("p102.xyz")).surgical, "double");
}

using Curve = std::vector<Vec3>;

// The torus knot T(2,3) wound so that the signs of its three crossings, summed over all edge pairs apart from this code, are +3:
// (over x under).z > 0. A sign slip anywhere in the pipeline names it m3_1.
Curve right_handed_trefoil() {
    Curve curve;
    for (int i = 0; i < 60; ++i) {
        const double t = 2 * EIGEN_PI * i / 60;
        curve.emplace_back(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), std::sin(3 * t));
    }
    return curve;
}

Curve mapped(Curve curve, const std::function<Vec3(const Vec3&)>& map) {
    for (Vec3& v : curve) v = map(v);
    return curve;
}

TEST(Laws, HandednessIsThatOfTheHandCheckedTrefoil) {
    const Curve trefoil = right_handed_trefoil();
    const Curve other = mapped(trefoil, [](const Vec3& v) { return Vec3(v.x(), v.y(), -v.z()); });
    EXPECT_EQ(name_knot(trefoil, true).knot, "3_1");
    EXPECT_EQ(name_knot(other, true).knot, "m3_1");
}

// A camera or a patient may stand anywhere: turned, moved, scaled and travelled backwards a knot keeps its name.
TEST(Laws, NamesDoNotDependOnTheFrameOrTheDirection) {
    for (const char* file : {"p103.xyz", "p105.xyz", "p109.xyz", "p117.xyz", "p126.xyz"}) {
        const Curve curve = read_curve(file);
        const Name name = name_knot(curve);
        for (unsigned seed = 0; seed < 30; ++seed) {
            SCOPED_TRACE(std::string(file) + " seed " + std::to_string(seed));
            std::mt19937 random(seed);
            std::normal_distribution<double> normal;
            const geometry::Quat turn =
                geometry::Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
            Curve moved = mapped(curve, [&](const Vec3& v) { return Vec3(1e-3 * (turn * v) + Vec3(7, -3, 0.2)); });
            if (seed % 2) std::reverse(moved.begin(), moved.end());
            const Name again = name_knot(moved);
            EXPECT_EQ(again.knot, name.knot);
            EXPECT_EQ(again.throws, name.throws);
            EXPECT_EQ(again.surgical, name.surgical);
        }
    }
}

// Vertices in line and vertices twice are where triangles have no area; a finer thread is the same thread.
TEST(Laws, SubdivisionAndRepetitionChangeNothing) {
    for (const Labelled& label : labelled_knots()) {
        SCOPED_TRACE(label.file);
        const Curve curve = read_curve(label.file);
        Curve finer;
        for (size_t i = 0; i + 1 < curve.size(); ++i)
            for (const double t : {0.0, 0.0, 0.5}) finer.push_back(curve[i] + t * (curve[i + 1] - curve[i]));
        finer.push_back(curve.back());
        EXPECT_EQ(name_knot(finer, label.closed).knot, name_knot(curve, label.closed).knot);
    }
}

// Curves as simple as curves get: nothing to reduce, nothing to see, and no place for an index to go wrong.
TEST(Namer, TheSmallestCurvesAreUnknotted) {
    EXPECT_EQ(name_knot({Vec3(0, 0, 0), Vec3(1, 0, 0)}).knot, "0_1");
    EXPECT_EQ(name_knot({Vec3(0, 0, 0), Vec3(0, 0, 0)}).knot, "0_1");
    EXPECT_EQ(name_knot({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, true).knot, "0_1");
    EXPECT_EQ(name_knot({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(5, 0, 0)}).knot, "0_1");
}

// An end inside the coils has no type of its own: a bare name would be a guess.
TEST(Namer, BuriedEndsAreNamedAsACandidateOnly) {
    for (const char* file : {"p154.xyz", "p155.xyz"}) {
        const Name name = name_knot(read_curve(file));
        EXPECT_FALSE(name.certain) << file;
        EXPECT_GT(name.candidates.size(), 1u) << file;
    }
}

// A ball of wool must not stop the simulation, whatever it is called.
TEST(Namer, ATangleIsAnsweredAndNeverWithASmallName) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 1);
    Curve tangle;
    for (int i = 0; i < 300; ++i) tangle.emplace_back(place(random), place(random), place(random));
    EXPECT_EQ(name_knot(tangle, true).knot, "unknown");
}

}  // namespace

}  // namespace sim::knot
