#include <sqlite3.h>
#include <sys/resource.h>

#include <cmath>

#include "scenarios/drill/drill.hpp"
#include "scenarios/recording/recording.hpp"
#include "tests/app/commands/still.hpp"
#include "tests/program.hpp"

// Every command is given what disks, hurried people and other programs leave behind. A crash, a hang, a silent default
// or a page of noise costs its author an afternoon. To cover another input, add a row.
namespace {

using program::Folder;

struct Case {
    std::vector<std::string> call;  ///< "FILE" stands for the broken file.
    std::string content;            ///< What is in it; "<missing>" and "<directory>" as they say.
    std::string extension = ".json";
};

const std::string header = "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw\n";

// Where an answer would go that bad input never comes to.
std::string never(const char* name) {
    return (std::filesystem::temp_directory_path() / name).string();
}

// Whatever a command reads: nothing, nonsense, half of it, not there, not a file.
void add_every_command(std::vector<Case>& all) {
    const std::vector<std::vector<std::string>> calls = {{"run", "FILE"},
                                                         {"validate", "FILE"},
                                                         {"explain", "FILE"},
                                                         {"replay", "FILE"},
                                                         {"replay", "--verify", "FILE"},
                                                         {"render", "FILE", "--out", never("never.png")},
                                                         {"knot", "FILE"},
                                                         {"motion", "FILE", "--out", never("never.csv")},
                                                         {"run", still::drill, "--input", "FILE"}};
    const std::string contents[] = {"", program::junk(1, 4096), "{\"carrel_drill\": 1, \"tit", "<missing>",
                                    "<directory>"};
    for (const auto& call : calls)
        for (const std::string& content : contents) all.push_back({call, content});
}

void add_motions(std::vector<Case>& all) {
    const std::string pose = ",0,0,40,1,0,0,0,0\n", both = "0,left" + pose + "0,right" + pose;
    for (const std::string& rows :
         {std::string("0,left,nan,0,0,1,0,0,0,0\n"), std::string("0,left,0,0,0,0,0,0,0,0\n"),
          std::string("0,left,0,0,0,1,0,0,0,7\n"), std::string("0,middle,0,0,0,1,0,0,0,0\n"),
          std::string("0,left,0,0,0,1,0,0\n"), std::string("0,left,1e300,0,0,1,0,0,0,0\n"),
          std::string("0,left,0,0,0,1e-200,0,0,0,0\n"), std::string("0,\x1b[31mred") + pose, std::string(""),
          "1,left" + pose + "0,left" + pose, both + both, both + "1e9,left" + pose, "-1,left" + pose, "0,left" + pose,
          both + "1,left" + pose + "0.5,left" + pose, both + "0,5,left" + pose,
          "0," + std::string(1000000, 'x') + pose})
        all.push_back({{"run", still::drill, "--input", "FILE"}, header + rows, ".csv"});
    for (const std::string& other : {std::string("t_s,instrument,x_m,y_m,z_m,qw,qx,qy,qz,jaw\n"),
                                     std::string("\xef\xbb\xbf\xef\xbb\xbf") + header})
        all.push_back({{"run", still::drill, "--input", "FILE"}, other + both, ".csv"});
}

void add_curves(std::vector<Case>& all) {
    for (const char* text : {"0 0 0\nnan 0 0\n", "0 0 0\n", "0 0\n1 1\n", "0 0 0\n1 0 0\n1 0 inf\n"})
        all.push_back({{"knot", "FILE"}, text, ".xyz"});
}

void add_waypoints(std::vector<Case>& all) {
    const std::string start = "start left 0 0 0 jaw 0\n";
    for (const std::string& text :
         {std::string("go left 0 0 0\n"), std::string("start left 0 0 nan jaw 0\n"),
          std::string("start left 0 0 0 jaw 2\n"), std::string("hop left 1 2 3\n"),
          std::string("tool left pointing 0 0 0 opening 1 0 0\n"), std::string("start a,b 0 0 0 jaw 0\n"),
          std::string("start left 0 0 0 jaw 0 left 0 0 0 jaw 0\n"), start + start, start + "jaw left 0 in -1\n",
          start + "go right 0 0 0\n", start + "go left 0 0 1 left 0 0 2\n", start + "go left 0 0\n",
          start + "speed 0\n", start + "wait 1e9\n", start + "go left 1 1 1 now\n", std::string(2 << 20, 'x')})
        all.push_back({{"motion", "FILE", "--out", never("never.csv")}, text, ".waypoints"});
}

/// A drill with its mesh's SHA-256, as the program itself says it, in place of one of zeros.
std::string with_sum(const Folder& folder, const std::string& drill) {
    const auto told = program::run({"validate", folder.write("drill.json", drill)});
    program::expect_one_line_naming("/vessels/0/mesh/sha256", told);
    return program::replaced(drill, std::string(64, '0'), told.said.substr(told.said.size() - 65, 64));
}

/// A drill without its guidance, which tells of seconds of its own motion.
std::string without_steps(std::string drill) {
    const auto from = drill.find("\"steps\""), to = drill.find("\"motion\"");
    return drill.erase(from, to - from);
}

/// A drill whose vessel is this mesh; writes the mesh and a short motion beside it.
std::string drill_of_mesh(const Folder& folder, const std::string& mesh) {
    folder.write("vessel.obj", mesh);
    folder.write("motion.csv", still::motion("0.05"));
    const std::string tube = "\"tube\": {\"diameter_mm\": 4, \"wall_mm\": 0.6, \"length_mm\": 30}", wrong(64, '0');
    std::string drill = program::replaced(without_steps(program::read(still::drill)), "square-knot.csv", "motion.csv");
    drill = program::replaced(drill, tube, "\"mesh\": {\"file\": \"vessel.obj\", \"sha256\": \"" + wrong + "\"}");
    return with_sum(folder, drill);
}

void expect_refused(const Case& c, const Folder& folder, const std::string& blamed) {
    std::string file = folder.path("broken" + c.extension);
    if (c.content == "<directory>") file = folder.path("");
    if (c.content != "<directory>" && c.content != "<missing>") folder.write("broken" + c.extension, c.content);
    std::vector<std::string> call = c.call;
    std::replace(call.begin(), call.end(), std::string("FILE"), file);
    SCOPED_TRACE(testing::PrintToString(c.call) + "\n" + c.content.substr(0, 80));
    program::expect_one_line_naming(blamed.empty() ? file : blamed, program::run(call, std::chrono::seconds(20)));
}

}  // namespace

TEST(BadInput, IsOneLineThatNamesTheFileAndExit2) {
    std::vector<Case> all;
    add_every_command(all);
    add_motions(all);
    add_curves(all);
    add_waypoints(all);
    for (const Case& c : all) expect_refused(c, Folder(), "");
}

// A drill of a billion links must be refused, not tried; each line says where in the file.
TEST(BadInput, ADrillIsRefusedWithThePlaceInIt) {
    const std::string good = program::read(still::drill);
    const std::pair<std::string, std::string> swaps[] = {
        {"\"links\": 141", "\"links\": 1000000000"},
        {"\"links\": 141", "\"links\": 2000"},
        {"\"length_mm\"", "\"length_cm\""},
        {"\"length_mm\": 96.2", "\"length_mm\": 900"},
        {"\"carrel_drill\": 1", "\"carrel_drill\": 9"},
        {"\"kind\": \"forceps\"", "\"kind\": \"spoon\""},
        {"\"name\": \"right\"", "\"name\": \"left\""},
        {"\"diameter_mm\": 4", "\"diameter_mm\": -4"},
        {"\"diameter_mm\": 4", "\"diameter_mm\": 9"},  // the thread would start in its wall
        {"\"wall_mm\": 0.6", "\"wall_mm\": 2"},
        {"\"axis\": [1, 0, 0]", "\"axis\": [0, 0, 0]"},
        {"\"gravity\": false", "\"gravity\": \"no\""},
        {"\"around\": \"carotid\"", "\"around\": \"aorta\""},
        {"\"tails_mm\": [3, 120]", "\"tails_mm\": [120, 3]"},
        {"\"time_limit_s\": 120", "\"time_limit_s\": 0"},
        {"\"time_limit_s\": 120", "\"time_limit_s\": 120, \"time_limit_s\": 60"},
        {"\"motion\": \"square-knot.csv\"", "\"motion\": \"/dev/zero\""},
        {"\"tube\": {\"diameter_mm\"", "\"mesh\": \"x.obj\", \"tube\": {\"diameter_mm\""}};
    for (const auto& [from, to] : swaps)
        for (const std::string command : {"validate", "explain", "run"})
            expect_refused({{command, "FILE"}, program::replaced(good, from, to)}, Folder(), ": error: /");
    const std::string brackets(100000, '[');
    for (const std::string& text :
         {brackets, program::replaced(good, "[1, 0, 0]", brackets), program::replaced(good, "141", "1e400"),
          program::replaced(good, "141", "NaN"), good + "}", std::string(5 << 20, ' ')})
        expect_refused({{"validate", "FILE"}, text}, Folder(), "");
}

// A vessel that is no mesh must be found where the author looks, in `validate`, and not be blamed on the simulator.
TEST(BadInput, AMeshIsRefusedByName) {
    const std::string corners = "v -50 -20 -20\nv 50 -20 -20\nv 50 20 20\n";
    for (const std::string& mesh :
         {std::string(), program::junk(2, 3000), std::string("v 0 0 0\nv 1 0 0\n"),
          std::string("v 0 0 0\nv nan 0 0\nv 0 9 0\nf 1 2 3\n"), corners + "f 1 2 9\n",
          std::string("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n"), corners + "f 1 2 3\n" /* cuts the thread */}) {
        const Folder folder;
        for (const std::string command : {"validate", "run"})
            expect_refused({{command, "FILE"}, drill_of_mesh(folder, mesh)}, folder, "vessel.obj: error: ");
    }
}

// What is cut aslant is known only once its wall is made. A thread in one goes through it thousands of times.
TEST(BadInput, NothingStartsInAWallThatGivesWay) {
    const Folder folder;
    folder.write("single-bite.csv", program::read(CARREL_SOURCE "/scenarios/drills/single-bite.csv"));
    std::string good = program::read(CARREL_SOURCE "/scenarios/drills/single-bite.json");
    for (int end = 0; end < 2; ++end)
        good = program::replaced(good, "\"length_mm\": 4}", "\"length_mm\": 4, \"cut_angle_deg\": 45}");
    const std::string drill = folder.write("drill.json", good);
    ASSERT_EQ(program::run({"validate", drill}).exit, 0);
    for (const auto& [from, to, blamed] : std::vector<std::array<std::string, 3>>{
             {R"("tail_mm": [1.022, 0, 8.605], "towards": [-4.44, 0, -5.79], "bulge": [-3.134, 0, 2.405]},
    "start_mm": [[2.4, 1.5, 8.2])",
              R"("tail_mm": [-3.5, 0, 6], "towards": [0, 0, -1], "bulge": [0, 1, 0]},
    "start_mm": [[-3.5, -3, 7.5])",
              "vessel \"left-end\": error: /vessels/0: the needle"},
             {"\"centre_mm\": [3.5, 0, 0]", "\"centre_mm\": [-3, 0, 0]",
              "vessel \"right-end\": error: /vessels/1: it starts in the wall of \"left-end\""}}) {
        folder.write("drill.json", program::replaced(good, from, to));
        for (const char* command : {"validate", "run"})
            program::expect_one_line_naming(blamed, program::run({command, drill}));
    }
}

// A box whose wall is half a millimetre thick; the thread is in that, and touches no side of it.
TEST(BadInput, NoThreadStartsInAWallThatIsAMesh) {
    const Folder folder;
    folder.write("box.obj",
                 "v -9 -9 -9\nv 9 -9 -9\nv 9 9 -9\nv -9 9 -9\nv -9 -9 9\nv 9 -9 9\nv 9 9 9\nv -9 9 9\nf 1 3 2\nf 1 4 "
                 "3\nf 5 6 7\nf 5 7 8\n"
                 "f 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n");
    std::string text =
        R"({"carrel_drill": 1, "title": "Box", "thread": {"size": "6-0", "length_mm": 8, "links": 40,
      "start_mm": [[-4, 0, 8.75], [4, 0, 8.75]]},
      "vessels": [{"name": "box", "mesh": {"file": "box.obj", "sha256": "SHA", "wall_mm": 0.5}}],
      "instruments": [{"name": "left", "kind": "forceps"}],
      "effects": {"tissue": "elastic"}, "time_limit_s": 1})";
    text = with_sum(folder, program::replaced(text, "SHA", std::string(64, '0')));
    const std::string drill = folder.write("drill.json", text);
    program::expect_one_line_naming("vessel \"box\": error: /vessels/0: the thread starts in its wall, behind corner 0",
                                    program::run({"validate", drill}));
    folder.write("drill.json",
                 program::replaced(text, "[[-4, 0, 8.75], [4, 0, 8.75]]", "[[-4, 0, 9.75], [4, 0, 9.75]]"));
    EXPECT_EQ(program::run({"validate", drill}).exit, 0);
    std::string sewn = program::replaced(text, "\"start_mm\": [[-4, 0, 8.75], [4, 0, 8.75]]",
                                         "\"needle\": {\"code\": \"BV-1\", \"tail_mm\": [0, 0, 30], \"towards\": [1, "
                                         "0, 0], \"bulge\": [0, 0, 1]}, \"start_mm\": [[-4, 0, 30], [-8, 0, 30]]");
    sewn = program::replaced(sewn, "\"wall_mm\": 0.5}}", "\"wall_mm\": 0.5}, \"held\": [\"start\"]}");
    sewn = program::replaced(sewn, "\"time_limit_s\"",
                             "\"bands\": {\"bites\": [1, 2], \"bite_mm\": [1, 2]}, \"time_limit_s\"");
    folder.write("drill.json", sewn);
    program::expect_one_line_naming("it is closed, so that there is no cut", program::run({"validate", drill}));
}

// Where a tool is at first has nothing before it to stay at.
TEST(BadInput, ARecordingWhoseFirstInputIsDamagedIsNamed) {
    const Folder folder;
    const auto drill = scenarios::drill::load_drill(still::drill);
    const std::string bad = folder.path("bad.carrel");
    std::vector<instruments::ToolInput> inputs(drill.world.instruments.size());
    inputs[1].pose.position.x() = std::nan("");
    scenarios::recording::Recorder recorder(bad,
                                            {drill.text, still::drill, "", drill.world.tick_s, {"left", "right"}, {}});
    for (int t = 0; t < 5; ++t) recorder.add_tick(inputs);
    recorder.finish();
    for (const auto& call : {std::vector<std::string>{"replay", bad}, {"render", bad, "--out", folder.path("x.png")}})
        program::expect_one_line_naming(bad, program::run(call));
}

// Recordings are kept for years and moved about. What was changed in one must be told, by all who read it, and a check
// of hashes that compared none must not say that all are equal.
TEST(BadInput, ADamagedRecordingIsNamed) {
    const Folder folder;
    const std::string good = folder.path("good.carrel"), bad = folder.path("bad.carrel");
    ASSERT_EQ(
        program::run({"run", still::drill, "--input", folder.write("m.csv", still::motion("0.05")), "--record", good})
            .exit,
        0);
    const auto expect_named = [&](const std::string& how, const std::vector<std::vector<std::string>>& calls) {
        for (const auto& call : calls) {
            SCOPED_TRACE(how + "\n" + testing::PrintToString(call));
            program::expect_one_line_naming(bad, program::run(call));
        }
    };
    const std::vector<std::string> verify{"replay", "--verify", bad};
    const std::vector<std::vector<std::string>> all{
        {"replay", bad}, verify, {"render", bad, "--out", folder.path("x.png")}};
    const auto forge = [&](const std::string& sql) {
        std::filesystem::copy_file(good, bad, std::filesystem::copy_options::overwrite_existing);
        sqlite3* db = nullptr;
        ASSERT_EQ(sqlite3_open(bad.c_str(), &db), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sql;
        sqlite3_close(db);
    };
    for (const char* sql :
         {"DELETE FROM head", "DELETE FROM chunk", "DROP TABLE chunk", "UPDATE chunk SET ticks = 1000000000000",
          "UPDATE chunk SET ticks = -1", "UPDATE chunk SET inputs = 7", "UPDATE chunk SET first_tick = first_tick + 5",
          "UPDATE head SET drill_text = '{'", "UPDATE head SET tick_s = 0.01", "UPDATE head SET tick_s = 'x'",
          "UPDATE instrument SET name = CASE place WHEN 0 THEN 'right' ELSE 'left' END", "DELETE FROM instrument",
          "UPDATE finished SET ticks = 999999", "UPDATE state_hash SET hash = 'hello'", "PRAGMA user_version = 99",
          "PRAGMA application_id = 1", "UPDATE head SET drill_name = char(27, 10), drill_text = '['"}) {
        forge(sql);
        expect_named(sql, all);
    }
    for (const char* sql :
         {"DELETE FROM state_hash", "DELETE FROM state_hash; DELETE FROM finished",
          "DELETE FROM state_hash WHERE tick > 300", "UPDATE state_hash SET tick = tick + 100000 WHERE tick = 200",
          "UPDATE state_hash SET tick = -tick"}) {
        forge(sql);
        expect_named(sql, {verify});
    }
    const std::string bytes = program::read(good);
    for (const std::size_t size : {1ul, 100ul, 4096ul, bytes.size() / 2, bytes.size() - 4096}) {
        folder.write("bad.carrel", bytes.substr(0, size));
        expect_named("cut to " + std::to_string(size), all);
    }
    // A bit here and there: whatever comes of it, it comes to an end and is at most one line.
    for (unsigned seed = 0; seed < 10; ++seed) {
        std::mt19937 random(seed);
        std::string damaged = bytes;
        for (int i = 0; i < 20; ++i) damaged[100 + random() % (damaged.size() - 100)] = static_cast<char>(random());
        folder.write("bad.carrel", damaged);
        const auto ending = program::run(verify);
        SCOPED_TRACE("seed " + std::to_string(seed));
        EXPECT_TRUE(ending.in_time);
        EXPECT_TRUE(ending.exit == 0 || ending.exit == 2 || ending.exit == 3)
            << ending.exit << ", signal " << ending.signal;
        EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
    }
}

// A drill's mesh lies beside its recordings. Replayed on another one, a session is not what its resident did.
TEST(BadInput, ARecordingOfAnotherMeshIsNamed) {
    const Folder folder;
    const std::string far = "v -50 -20 -90\nv 50 -20 -90\nv 50 20 -90\nf 1 2 3\n", mesh = folder.path("vessel.obj");
    folder.write("drill.json", drill_of_mesh(folder, far));
    const std::string recording = folder.path("session.carrel");
    ASSERT_EQ(program::run({"run", folder.path("drill.json"), "--record", recording}).exit, 0);
    EXPECT_EQ(program::run({"replay", "--verify", recording}).exit, 0);
    folder.write("vessel.obj", far + "f 1 3 2\n");
    program::expect_one_line_naming(mesh, program::run({"replay", recording}));
    std::filesystem::remove(mesh);
    program::expect_one_line_naming(mesh, program::run({"replay", recording}));
    const Folder elsewhere;
    const std::string copy = elsewhere.path("copy.carrel");
    std::filesystem::copy(recording, copy);
    program::expect_one_line_naming(mesh + " is not there, expected it there or at " + elsewhere.path("vessel.obj"),
                                    program::run({"replay", copy}));
    elsewhere.write("vessel.obj", far);
    EXPECT_EQ(program::run({"replay", "--verify", copy}).exit, 0)
        << "who gets a recording and its mesh has them in one folder";
}

TEST(BadInput, ANameThatIsTooLongIsNoFile) {
    const Folder folder;
    const std::string too_long(300, 'x');
    folder.write("drill.json", program::replaced(program::read(still::drill), "square-knot.csv", too_long));
    program::expect_one_line_naming("/motion: no such file", program::run({"validate", folder.path("drill.json")}));
}

// Where the answer cannot be written it must be said before the work, and nothing that is there may be lost.
TEST(BadInput, APlaceThatCannotBeWrittenIsNamed) {
    const Folder folder, other;
    const std::string notes = folder.write("notes.txt", "mine"), motion = folder.write("m.csv", still::motion("0.05"));
    const std::string waypoints = CARREL_SOURCE "/scenarios/drills/square-knot.waypoints";
    const std::string drill = folder.write("result.json", program::read(still::drill));  // as a report would be called
    const std::string curve = folder.write("curve.xyz", "0 0 0\n10 0 0\n");
    const std::string pull = folder.write("pull.csv", "t_s,node,x_mm,y_mm,z_mm\n0,first,0,0,0\n0.01,first,-1,0,0\n");
    const std::string recording = other.path("result.json");
    ASSERT_EQ(program::run({"run", still::drill, "--input", motion, "--record", recording}).exit, 0);
    const std::string steps = folder.write("steps.csv", program::read(waypoints));
    const auto run_to = [&](const std::string& option, const std::string& place) {
        return std::vector<std::string>{"run", still::drill, "--input", motion, option, place};
    };
    for (const auto& [blamed, call] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {notes, run_to("--record", notes)},
             {motion, run_to("--record", motion)},
             {"/dev/null", run_to("--record", "/dev/null")},
             {folder.path(""), run_to("--record", folder.path(""))},
             {notes, run_to("--record", notes + "/x")},
             {notes, run_to("--out", notes)},
             {"/proc/x", run_to("--out", "/proc/x")},
             {"--out", run_to("--out", "")},
             {other.path("report.html"),
              {"run", still::drill, "--input", motion, "--out", other.path(""), "--record", other.path("report.html")}},
             {"--frames", run_to("--frames", "3")},  // nowhere to go
             {"/nowhere/x.csv", {"motion", waypoints, "--out", "/nowhere/x.csv"}},
             {folder.path(""), {"motion", waypoints, "--out", folder.path("")}},
             {notes, {"motion", waypoints, "--out", notes}},
             {notes, {"render", still::drill, "--out", notes}},
             {steps, {"motion", steps, "--out", steps}},
             {curve, {"rope", curve, "--motion", pull, "--out", curve}},
             {notes, {"bench", "speed", "--quick", "--plot", notes}},
             {"/nowhere/x.svg", {"bench", "speed", "--quick", "--plot", "/nowhere/x.svg"}},
             {notes, {"bench", "speed-vs-error", "--quick", "--plot", notes}},
             {notes, {"bench", "tissue", "--quick", "--plot", notes}},
             {notes + ".svg", {"bench", "accuracy", "--quick", "--plot", notes + ".svg"}},
             {drill, {"run", drill, "--input", motion, "--out", folder.path("")}},
             {recording, {"replay", recording, "--out", other.path("")}}}) {
        SCOPED_TRACE(testing::PrintToString(call));
        program::expect_one_line_naming(blamed, program::run(call));
    }
    EXPECT_EQ(program::read(notes), "mine");
    EXPECT_EQ(program::read(motion), still::motion("0.05"));
    EXPECT_EQ(program::read(curve), "0 0 0\n10 0 0\n");
    EXPECT_EQ(program::read(drill), program::read(still::drill));
    EXPECT_EQ(program::read(steps), program::read(waypoints));
    EXPECT_EQ(program::run({"replay", "--verify", recording}).exit, 0);
}

// A full disk behind a pipe: a script that trusts exit 0 would go on with half an answer.
TEST(BadInput, AnAnswerThatCannotBePrintedIsAFault) {
    const Folder folder;
    for (const std::vector<std::string>& call :
         std::vector<std::vector<std::string>>{{"validate", "--schema"}, {"explain", still::drill}}) {
        int status = 0;
        ASSERT_GT(waitpid(program::start(call, "/dev/full", folder.path("said")), &status, 0), 0);
        EXPECT_EQ(WEXITSTATUS(status), 1) << call.front();
    }
}

// A disk that fills up while it is written: half a motion looks like one that ends there.
TEST(BadInput, AFileThatCannotBeWrittenToItsEndIsNotLeft) {
    const Folder folder;
    const std::string made = folder.path("made.csv");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = signal(SIGXFSZ, SIG_IGN);  // the program is to be told, not killed
    const rlimit small{4096, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const auto ending =
        program::run({"motion", CARREL_SOURCE "/scenarios/drills/square-knot.waypoints", "--out", made});
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, handler);
    EXPECT_EQ(ending.exit, 1);
    EXPECT_NE(ending.said.find(made + ": cannot be written: "), std::string::npos) << ending.said;
    EXPECT_FALSE(std::filesystem::exists(made));
}

// A mistyped option is bad input like any other: one line that says what to look up.
TEST(BadInput, AWrongCommandLineIsOneLineToo) {
    for (const std::vector<std::string>& call :
         std::vector<std::vector<std::string>>{{""},
                                               {"nope"},
                                               {"run"},
                                               {"run", "--nope"},
                                               {"replay"},
                                               {"nope", "--help"},
                                               {"knot", "--around"},
                                               {"rope", "--links", "many"},
                                               {"render", "--size"},
                                               {"validate", "a", "--no\npe"},
                                               {"run", still::drill, "--frames", "1e12"}}) {
        SCOPED_TRACE(testing::PrintToString(call));
        program::expect_one_line_naming("--help", program::run(call));
    }
    EXPECT_NE(program::run({"runn", still::drill}).said.find("'runn' is no command, known are play, run, replay"),
              std::string::npos);
}
