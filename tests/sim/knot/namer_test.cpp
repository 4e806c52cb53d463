#include "sim/knot/namer.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
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
    bool closed = false, flat = false;
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

}  // namespace

}  // namespace sim::knot
