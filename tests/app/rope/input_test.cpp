#include <sys/stat.h>

#include "tests/program.hpp"

// Every command is given what disks, hurried people and other programs leave behind, through the real program. A crash,
// a hang, a page of text or a line that does not name the file would leave a user with nothing to go on. To cover
// another command, add its lines to `cases()`.
namespace {

namespace fs = std::filesystem;
using program::expect_one_line_naming;
using program::Folder;
using program::junk;

/// A person waits no longer for an error message.
program::Ending run(const std::vector<std::string>& call) {
    return program::run(call, std::chrono::seconds(10));
}

const std::string curve = "0 0 0\n1 0 0\n2 0 0\n3 0 0\n";
const std::string overhand =
    "7.03 5.62 0.43\n2.29 1.83 0.43\n1.48 2.06 0.93\n0.50 1.81 0.93\n-0.43 1.10 0.43\n-1.08 0.05 -0.30\n-1.33 -1.11 "
    "-0.87\n-1.13 -2.15 -0.97\n-0.58 -2.82 -0.56\n0.15 -2.99 0.15\n0.83 -2.61 0.78\n1.26 -1.77 1.00\n1.28 -0.65 0.68\n"
    "0.87 0.50 0.00\n0.08 1.44 -0.68\n-0.90 1.97 -1.00\n-1.84 2.02 -0.78\n-2.51 1.62 -0.15\n-2.73 0.91 0.56\n-2.43 "
    "0.10 0.97\n-1.63 -0.59 0.87\n-0.50 -0.97 0.30\n0.74 -0.92 -0.43\n1.82 -0.48 -0.93\n2.53 0.25 -0.93\n2.73 1.07 "
    "-0.43\n8.38 3.28 -0.43\n";
const std::string header = "t_s,node,x_mm,y_mm,z_mm\n";
const std::string motion = header + "0,first,0,0,0\n0.01,first,-1,0,0\n";

/// What is in the files and how the program is called; "@name" stands for the path of that file in the test's folder.
struct Case {
    std::string what;
    std::vector<std::string> call;
    std::string blamed;  ///< The file that the line must name.
    std::vector<std::pair<std::string, std::string>> files;
};

// Broken in ways that any reader of any format meets.
std::vector<std::pair<std::string, std::string>> broken_bytes() {
    return {{"empty", ""},
            {"blank", "\n \n\t\n"},
            {"nul bytes", std::string(1000, '\0')},
            {"binary junk", junk(1, 5000)},
            {"more junk", junk(2, 200000)},
            {"one long line", std::string(1000000, '7')},
            {"cut UTF-8", "\xc3"},
            {"a picture", "\x89PNG\r\n\x1a\n" + junk(3, 500)}};
}

// The three places of a command line where a file stands, with good ones beside it.
void add_everywhere(std::vector<Case>& cases, const std::string& what, const std::string& bytes) {
    cases.push_back({"rope, curve: " + what,
                     {"rope", "@c.csv", "--motion", "@m.csv"},
                     "c.csv",
                     {{"c.csv", bytes}, {"m.csv", motion}}});
    cases.push_back({"rope, motion: " + what,
                     {"rope", "@c.csv", "--motion", "@m.csv"},
                     "m.csv",
                     {{"c.csv", curve}, {"m.csv", bytes}}});
    cases.push_back({"rope, obstacle: " + what,
                     {"rope", "@c.csv", "--motion", "@m.csv", "--obstacle", "@o.obj"},
                     "o.obj",
                     {{"c.csv", curve}, {"m.csv", motion}, {"o.obj", bytes}}});
    for (const std::string command : {"validate", "explain"})
        cases.push_back({command + ": " + what, {command, "@d.json"}, "d.json", {{"d.json", bytes}}});
}

std::vector<Case> curve_cases() {
    std::vector<Case> cases;
    const auto with_curve = [&](const std::string& what, const std::string& text) {
        cases.push_back({"rope, curve: " + what,
                         {"rope", "@c.csv", "--motion", "@m.csv"},
                         "c.csv",
                         {{"c.csv", text}, {"m.csv", motion}}});
    };
    with_curve("one vertex", "1 2 3\n");
    with_curve("NaN", "0 0 0\nnan 0 0\n");
    with_curve("a link far shorter than the thread is thick", "0 0 0\n1 0 0\n1.0001 0 0\n2 0 0\n");
    with_curve("infinite", "0 0 0\n1e999 0 0\n");
    with_curve("two numbers", "0 0 0\n1 2\n");
    with_curve("four numbers", "0 0 0\n1 2 3 4\n");
    with_curve("words", "0 0 0\none two three\n");
    with_curve("the same vertex twice", "0 0 0\n1 0 0\n1 0 0\n2 0 0\n");
    with_curve("all in one place", "1 1 1\n1 1 1\n");
    with_curve("two curves", curve + "\n" + curve);
    with_curve("closed", "0 0 0\n1 0 0\n1 1 0\n0 0 0\n");
    with_curve("in another galaxy", "0 0 0\n1e300 0 0\n");
    return cases;
}

std::vector<Case> motion_cases() {
    std::vector<Case> cases;
    const auto with_motion = [&](const std::string& what, const std::string& text) {
        cases.push_back({"rope, motion: " + what,
                         {"rope", "@c.csv", "--motion", "@m.csv"},
                         "m.csv",
                         {{"c.csv", curve}, {"m.csv", text}}});
    };
    with_motion("header alone", header);
    with_motion("no header", "0,first,0,0,0\n");
    with_motion("cut in a row", motion.substr(0, motion.size() - 5));
    with_motion("a column too many", header + "0,first,0,0,0,0\n");
    with_motion("NaN", header + "0,first,nan,0,0\n");
    with_motion("infinite", header + "0,first,0,0,inf\n");
    with_motion("time is NaN", header + "nan,first,0,0,0\n");
    with_motion("a negative time", header + "-1,first,0,0,0\n");
    with_motion("time going back", header + "1,first,0,0,0\n0.5,first,0,0,0\n");
    with_motion("one time twice under two names", header + "1,first,0,0,0\n1,0,1,0,0\n");
    with_motion("a node beyond the last", header + "0,4,0,0,0\n");
    with_motion("a negative node", header + "0,-1,0,0,0\n");
    with_motion("an unknown name of a node", header + "0,middle,0,0,0\n");
    with_motion("ends before it begins", header + "0,first,0,0,0\n");
    with_motion("escape characters", header + "0,\x1b[31m\r\x07,0,0,0\n");
    with_motion("a year", header + "0,first,0,0,0\n31536000,first,1,0,0\n");
    return cases;
}

std::vector<Case> option_cases() {
    std::vector<Case> cases;
    const auto with_options = [&](const std::string& what, const std::string& blamed,
                                  std::vector<std::string> options) {
        options.insert(options.begin(), {"rope", "@c.csv", "--motion", "@m.csv"});
        cases.push_back({"rope: " + what, options, blamed, {{"c.csv", curve}, {"m.csv", motion}}});
    };
    with_options("a billion links", "c.csv", {"--links", "1000000000"});
    with_options("fewer than no links", "c.csv", {"--links", "-1"});
    with_options("no links", "c.csv", {"--links", "0"});
    with_options("shorter than a tick", "--tick", {"--tick", "1e9"});
    with_options("radius is NaN", "--radius", {"--radius", "nan"});
    with_options("radius of nothing", "--radius", {"--radius", "0"});
    with_options("negative friction", "--friction", {"--friction", "-0.1"});
    with_options("tick of nothing", "--tick", {"--tick", "0"});
    with_options("every zero ticks", "--every", {"--every", "0"});
    with_options("an elastic thread that cannot bend", "--links", {"--thread", "elastic", "--links", "1"});
    with_options("an unknown thread", "--thread", {"--thread", "wool"});
    with_options("weight of a thread that has none", "--gravity", {"--gravity"});
    with_options("positions into a folder that is not there", "nowhere", {"--out", "@nowhere/x.jsonl"});
    with_options("an obstacle of another kind", "m.csv", {"--obstacle", "@m.csv"});
    return cases;
}

std::vector<Case> start_cases() {
    std::vector<Case> cases;
    cases.push_back({"rope: so few links that the knot is gone",
                     {"rope", "@c.csv", "--motion", "@m.csv", "--links", "8"},
                     "c.csv",
                     {{"c.csv", overhand}, {"m.csv", motion}}});
    cases.push_back(
        {"rope: a start through the obstacle",
         {"rope", "@c.csv", "--motion", "@m.csv", "--obstacle", "@o.obj"},
         "c.csv",
         {{"c.csv", curve}, {"m.csv", motion}, {"o.obj", "v 1.5 -1 -1\nv 1.5 1 -1\nv 1.5 0 2\nf 1 2 3\n"}}});
    return cases;
}

std::vector<Case> drill_cases() {
    std::vector<Case> cases;
    for (const std::string command : {"validate", "explain"}) {
        const auto with = [&](const std::string& what, const std::string& text) {
            cases.push_back({command + ": " + what, {command, "@d.json"}, "d.json", {{"d.json", text}}});
        };
        with("cut in the middle", R"({"carrel_drill": 1, "title": "Squa)");
        with("NaN", R"({"carrel_drill": 1, "title": "x", "thread": {"size": "6-0", "length_mm": NaN}})");
        with("a billion links",
             R"({"carrel_drill": 1, "title": "x", "thread": {"size": "6-0", "length_mm": 150, "links": 1e9}})");
        with("an unknown key", R"({"carrel_drill": 1, "titel": "x"})");
        with("a later version", R"({"carrel_drill": 1000000})");
        with("a million brackets", std::string(1000000, '['));
    }
    return cases;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const auto& of_a_kind : {curve_cases(), motion_cases(), option_cases(), start_cases(), drill_cases()})
        all.insert(all.end(), of_a_kind.begin(), of_a_kind.end());
    for (const auto& [what, bytes] : broken_bytes()) add_everywhere(all, what, bytes);
    return all;
}

std::vector<std::string> placed(std::vector<std::string> call, const Folder& folder) {
    for (std::string& argument : call)
        if (argument.starts_with('@')) argument = folder.path(argument.substr(1));
    return call;
}

TEST(BadInput, ABrokenFileGetsOneLineThatNamesIt) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.what);
        const Folder folder;
        for (const auto& [name, bytes] : c.files) folder.write(name, bytes);
        expect_one_line_naming(c.blamed, run(placed(c.call, folder)));
    }
}

// Paths that are no files: someone drags the folder in, mistypes a name, or gives a device that never ends.
TEST(BadInput, APathThatIsNoFileGetsOneLineThatNamesIt) {
    std::vector<Case> all;
    add_everywhere(all, "", "");
    for (Case c : all) {
        for (const std::string kind : {"missing", "a directory", "a pipe", "a loop of links"}) {
            SCOPED_TRACE(c.what + kind);
            const Folder folder;
            for (const auto& [name, bytes] : c.files)
                if (name != c.blamed) folder.write(name, bytes);
            const std::string path = folder.path(c.blamed);
            if (kind == "a directory") fs::create_directory(path);
            if (kind == "a pipe") mkfifo(path.c_str(), 0600);
            if (kind == "a loop of links") fs::create_symlink(path, path);
            expect_one_line_naming(c.blamed, run(placed(c.call, folder)));
        }
    }
}

// The good files that stand beside the broken ones: were they refused too, every case above would pass for nothing.
TEST(BadInput, TheGoodFilesBesideThemAreTaken) {
    const Folder folder;
    const program::Ending ending =
        run({"rope", folder.write("c.csv", curve), "--motion", folder.write("m.csv", motion)});
    EXPECT_EQ(ending.exit, 0) << ending.said;
    EXPECT_EQ(ending.said, "");
}

// A motion that ends within a tick would let go in its last one: the taut thread leaps, and that it lags would not be
// told.
TEST(Rope, HoldsToTheEndOfAMotionThatEndsWithinATick) {
    const Folder folder;
    const std::string ends_within = header + "0,first,0,0,0\n0.0995,first,0,0,12\n0,last,3,0,0\n0.0995,last,3,0,12\n",
                      dump = folder.path("d.jsonl");
    ASSERT_EQ(run({"rope", folder.write("c.csv", curve), "--motion", folder.write("m.csv", ends_within), "--thread",
                   "elastic", "--out", dump})
                  .exit,
              0);
    const std::string text = program::read(dump), end = text.substr(text.rfind("\"tick\""));
    EXPECT_NE(end.find("[[0.0,0.0,12.0]"), std::string::npos) << end;
}

}  // namespace
