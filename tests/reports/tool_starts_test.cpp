#include "app/commands/tool_starts.hpp"

#include <gtest/gtest.h>

#include "app/fault.hpp"
#include "scenarios/session/scene.hpp"
#include "tests/program.hpp"
#include "tests/scenarios/drill/sample.hpp"

// A tool that starts in a rigid vessel is held fast by it: its drill would be "valid", and "passed" without a move.
namespace tool_starts {

using instruments::Kind;
using instruments::Quat;
using instruments::ToolInput;
using sim::geometry::Vec3;

// A tube through the origin and one tool above it, the whole turned about the origin.
struct Start {
    double radius = 2e-3;  // [m] of the tube's outside
    double wall = 0.6e-3, length = 30e-3;
    Kind kind = Kind::forceps;
    double height = 10e-3;  // [m] of the jaws' tips over the tube's axis
    bool points_down = true;
    double jaw = 0;
    Quat turn = Quat::Identity();

    // "" or what is said of it.
    std::string said() const {
        scenarios::drill::Drill drill = scenarios::drill::parse_drill(sample::drill, "a.json", "");
        auto& vessel = drill.world.vessels[0];
        vessel.diameter = 2 * radius, vessel.wall = wall, vessel.length = length, vessel.axis = turn * Vec3::UnitX();
        drill.world.instruments.resize(1);
        drill.world.instruments[0].kind = kind;
        const Quat down(0, 1, 0, 0);  // half a turn about x
        const ToolInput input{{turn * Vec3(0, 0, height), turn * (points_down ? down : Quat::Identity())}, jaw};
        try {
            app::check_tool_starts(drill, scenarios::session::vessel_meshes(drill.world), {&input, 1}, "m.csv");
            return "";
        } catch (const app::InputFault& fault) {
            return fault.what();
        }
    }
};

std::string words(const std::string& parts) {
    return "m.csv: error: the " + parts +
           " of \"left\" start in the rigid vessel \"carotid\", which would hold it fast, expected to start clear of "
           "it: places in mm, and a rotation that lays the shaft, behind the jaws along -z, outside";
}

const Quat turns[] = {Quat::Identity(), Quat(0.8, 0.6, 0, 0), Quat(0.5, 0.5, -0.5, 0.5), Quat(0.1, -0.7, 0.5, 0.5)};

// Pointing down, a closed tool's lowest place is its tips, at `height`: it is clear of the tube where that is above its
// radius. Facets lie at most a twentieth of the thread's thickness (4 um) further in.
TEST(ToolStarts, JawsThatReachIntoAVesselAreNamed) {
    for (const Quat& turn : turns)
        for (const double radius : {0.5e-3, 2e-3, 12e-3})
            for (const Kind kind : {Kind::forceps, Kind::needle_holder, Kind::scissors}) {
                SCOPED_TRACE(testing::Message() << 1e3 * radius << " mm, kind " << static_cast<int>(kind));
                Start start{.radius = radius, .wall = radius / 3, .kind = kind, .turn = turn.normalized()};
                start.height = radius + 0.01e-3;
                EXPECT_EQ(start.said(), "");
                start.height = radius - 0.02e-3;
                EXPECT_EQ(start.said(), words("jaws"));
            }
}

// A tracker's identity: the tips above the vessel and the shaft below them, through it.
TEST(ToolStarts, AShaftThatComesThroughAVesselIsNamed) {
    for (const Quat& turn : turns) {
        Start start{.points_down = false, .turn = turn.normalized()};
        start.height = 2e-3 + 12e-3 + 0.3e-3;  // jaws of 12 mm and their round ends clear of it
        EXPECT_EQ(start.said(), words("shaft"));
        start.height = 0;
        EXPECT_EQ(start.said(), words("jaws"));
        start.radius = 12e-3, start.wall = 1e-3, start.height = 0.5e-3;
        EXPECT_EQ(start.said(), words("shaft and jaws"));
        start.height = 2e-3 + 12e-3 + 0.1e-3 + 83.1e-3, start.radius = 2e-3;  // a shaft of 80 mm and its round ends
        EXPECT_EQ(start.said(), "");
    }
}

// What is wide enough to work in may be worked in.
TEST(ToolStarts, ALumenThatIsWideEnoughIsNoWall) {
    Start start{.radius = 30e-3, .wall = 1e-3, .length = 300e-3, .jaw = 1};
    start.height = -20e-3;
    EXPECT_EQ(start.said(), words("shaft")) << "out of the top";
    scenarios::drill::Drill drill = scenarios::drill::parse_drill(sample::drill, "a.json", "");
    auto& vessel = drill.world.vessels[0];
    vessel.diameter = 60e-3, vessel.wall = 1e-3, vessel.length = 300e-3;
    drill.world.instruments.resize(1);
    const Quat along_x(std::sqrt(0.5), 0, std::sqrt(0.5), 0);
    const ToolInput inside{{Vec3(0.05, 0, 0), along_x}, 1};
    app::check_tool_starts(drill, scenarios::session::vessel_meshes(drill.world), {&inside, 1}, "m.csv");
}

// In a solid block no surface is near, and the tool is in it all the same.
TEST(ToolStarts, InAClosedMeshEverythingIsIn) {
    scenarios::drill::Drill drill = scenarios::drill::parse_drill(sample::drill, "a.json", "");
    drill.world.instruments.resize(1);
    assets::Mesh block;
    for (const double x : {-0.2, 0.2})
        for (const double y : {-0.2, 0.2})
            for (const double z : {-0.2, 0.2}) block.vertices.push_back({x, y, z});
    block.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                       {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    const ToolInput middle{};
    const auto check = [&] { app::check_tool_starts(drill, {block}, {&middle, 1}, "m.csv"); };
    EXPECT_THROW(check(), app::InputFault);
    block.triangles.resize(10);  // without a side it is a bowl, and the tool stands in that
    EXPECT_NO_THROW(check());
}

TEST(ToolStarts, ValidateAndRunSayWhichToolPartAndVessel) {
    const program::Folder folder;
    const std::string reported = CARREL_SOURCE "/tests/reports/tool-starts-in-vessel/";
    const std::string drill = program::read(reported + "drill.json"), header =
                                                                          "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,"
                                                                          "jaw\n";
    const std::string file = folder.write("drill.json", drill), motion = folder.path("from-lumen.csv");
    const auto expect_refused = [&](const std::string& rows, const std::string& parts) {
        folder.write("from-lumen.csv", rows);
        for (const char* command : {"validate", "run"}) {
            const auto ending = program::run({command, file});
            EXPECT_EQ(ending.exit, 2);
            EXPECT_EQ(ending.said, motion + ": error: the " + parts +
                                       " of \"right\" start in the rigid vessel \"carotid\", which would hold it fast, "
                                       "expected to start clear of it: places in mm, and a rotation that lays the "
                                       "shaft, behind the jaws along -z, outside\n");
        }
    };
    expect_refused(program::read(reported + "from-lumen.csv"), "jaws");
    expect_refused(header + "0,right,0.003,0.0,0.040,0,1,0,0,0.3\n1,right,0.0,0.0,0.030,0,1,0,0,0.3\n", "jaws");
    expect_refused(header + "0,right,0,0,15,1,0,0,0,0.3\n1,right,0,0,40,1,0,0,0,0.3\n", "shaft");
    folder.write("from-lumen.csv", header + "0,right,0,0,15,0,1,0,0,0.3\n0.1,right,0,0,12,0,1,0,0,0.3\n");
    for (const char* command : {"validate", "run"}) EXPECT_EQ(program::run({command, file}).exit, 0);
}

}  // namespace tool_starts
