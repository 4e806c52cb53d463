#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace cutting {

namespace fs = std::filesystem;

// Two needle holders pull a thread of 30 mm until it breaks at 1 N, then scissors cut what one of them holds.
constexpr const char* drill = R"({
  "carrel_drill": 1,
  "title": "Broken and cut",
  "thread": {"size": "6-0", "length_mm": 30, "links": 100, "break_N": 1,
             "model": "MODEL", "start_mm": [[-15, 0, 0], [15, 0, 0]]},
  "instruments": [
    {"name": "left", "kind": "needle_holder"},
    {"name": "right", "kind": "needle_holder"},
    {"name": "blades", "kind": "scissors"}
  ],
  "goals": [{"tie": "square"}],
  "motion": "motion.csv",
  "time_limit_s": 60
}
)";

// All from above, jaws across the thread: x of the tool along y of the world.
constexpr const char* motion = R"(t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw
0,left,-12,0,-2,0,0.7071067811865476,0.7071067811865476,0,1
0,right,12,0,-2,0,0.7071067811865476,0.7071067811865476,0,1
0,blades,-6,0,-2,0,0.7071067811865476,0.7071067811865476,0,1
0.2,left,-12,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
0.2,right,12,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
1.2,right,15,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
1.3,blades,-6,0,-2,0,0.7071067811865476,0.7071067811865476,0,1
1.4,left,-12,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
1.4,right,15,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
1.5,blades,-6,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
2,left,-14,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
2,right,15,3,-2,0,0.7071067811865476,0.7071067811865476,0,0
2,blades,-6,0,-2,0,0.7071067811865476,0.7071067811865476,0,0
)";

int run(const std::string& arguments) {
    return WEXITSTATUS(std::system((std::string(CARREL_PROGRAM) + " " + arguments).c_str()));
}

// What a session broke and cut its replay must break and cut, at the same tick and place.
TEST(Drills, ABrokenAndCutThreadIsReplayedToTheSameBits) {
    for (const std::string model : {"ftl", "elastic"}) {
        SCOPED_TRACE(model);
        const fs::path dir = fs::temp_directory_path() / ("carrel-cut-" + model);
        fs::create_directories(dir);
        std::string text = drill;
        text.replace(text.find("MODEL"), 5, model);
        std::ofstream(dir / "drill.json") << text;
        std::ofstream(dir / "motion.csv") << motion;
        ASSERT_EQ(run("run " + (dir / "drill.json").string() + " --json --record " + (dir / "session.carrel").string() +
                      " > " + (dir / "result.json").string()),
                  0);
        const auto result = nlohmann::json::parse(std::ifstream(dir / "result.json"));
        EXPECT_EQ(result["thread"]["pass_throughs"], 0);
        const auto count = [&](const std::string& kind) {
            return std::count_if(result["events"].begin(), result["events"].end(),
                                 [&](const auto& event) { return event["kind"] == kind; });
        };
        EXPECT_EQ(count("break"), 1) << result["events"];
        EXPECT_EQ(count("cut"), 1) << result["events"];
        EXPECT_EQ(run("replay --verify " + (dir / "session.carrel").string() + " 2> /dev/null"), 0);
    }
}

}  // namespace cutting
