#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "scenarios/drill/motion.hpp"
#include "scenarios/drill/waypoints.hpp"
#include "tests/scenarios/drill/sample.hpp"

// Broken files as people and disks make them. Each is given to the functions and to the program: one line that names
// the file, exit code 2, nothing else; a crash, a hang or a page of text fails.

namespace {

namespace fs = std::filesystem;
using sample::with;

struct Broken {
    std::string what, drill;
    std::string motion = {};  ///< If set, the drill is good and names this motion.
};

const std::string header = "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw\n";
const std::string good_rows = "0,left,0,0,60,0,1,0,0,1\n0,right,0,0,90,0,1,0,0,1\n";

std::string junk(unsigned seed, std::size_t size) {
    std::mt19937 random(seed);
    std::string bytes;
    while (bytes.size() < size) bytes += static_cast<char>(random());
    return bytes;
}

std::string moving(const std::string& motion_name) {
    return with("\"time_limit_s\"", "\"motion\": \"" + motion_name + "\", \"time_limit_s\"");
}

std::string held(std::string text) {
    text.replace(text.find("forceps"), 7, "approximator");
    return text.replace(text.find("\"tube\""), 6, "\"held_by\": \"left\", \"tube\"");
}

std::vector<Broken> broken_drills() {
    return {
        {"empty", ""},
        {"blank", "\n \n"},
        {"truncated", sample::drill.substr(0, 300)},
        {"truncated in a text", sample::drill.substr(0, 35)},
        {"nul bytes", std::string(1000, '\0')},
        {"binary junk", junk(1, 5000)},
        {"junk behind a brace", "{" + junk(2, 5000)},
        {"cut UTF-8", with("Square", "\xc3")},
        {"not a number", with("150", "NaN")},
        {"infinite", with("150", "1e999")},
        {"a huge integer", with("150", std::string(4000, '9'))},
        {"negative", with("150", "-150")},
        {"wrong unit", with("length_mm\": 150", "length_cm\": 15")},
        {"metres", with("150", "0.150")},
        {"unknown key", with("friction", "grip")},
        {"unknown key that breaks lines", with("friction", "a\\nb\\u0000c")},
        {"a very long key", with("friction", std::string(100000, 'k'))},
        {"a billion links", with("\"friction\": 0.2", "\"links\": 1e9")},
        {"deep nesting", std::string(1000000, '[')},
        {"deep objects",
         [] {
             std::string s;
             for (int i = 0; i < 100000; ++i) s += "{\"a\":";
             return s;
         }()},
        {"a list", "[" + sample::drill + "]"},
        {"two documents", sample::drill + sample::drill},
        {"a key twice", with("\"title\"", "\"carrel_drill\": 1, \"title\"")},
        {"no instruments",
         with("{\"name\": \"left\", \"kind\": \"forceps\"},\n    {\"name\": \"right\", \"kind\": \"needle_holder\"}",
              "")},
        {"held by nobody", with("\"name\": \"carotid\"", "\"name\": \"carotid\", \"held_by\": \"clamp\"")},
        {"held by forceps", with("\"name\": \"carotid\"", "\"name\": \"carotid\", \"held_by\": \"left\"")},
        {"an approximator that holds nothing", with("\"forceps\"", "\"approximator\"")},
        {"a rigid vessel that is held", held(moving("m.csv"))},
        {"both ends held", held(with("{\"gravity\": false}", "{\"tissue\": \"elastic\"}"))},
        {"missing mesh", with("\"tube\": {\"diameter_mm\": 4, \"wall_mm\": 0.6, \"length_mm\": 30}",
                              "\"mesh\": {\"file\": \"none.obj\", \"sha256\": \"" + std::string(64, '0') + "\"}")},
        {"another mesh", with("\"tube\": {\"diameter_mm\": 4, \"wall_mm\": 0.6, \"length_mm\": 30}",
                              "\"mesh\": {\"file\": \"other.obj\", \"sha256\": \"" + std::string(64, '0') + "\"}")},
        {"missing motion", moving("none.csv")},
        {"motion is a directory", moving(".")},
        {"motion is the drill", moving("drill.json")},
    };
}

std::vector<Broken> broken_motions() {
    const std::string good = moving("m.csv");
    return {
        {"empty motion", good, "\n"},
        {"motion without rows", good, header},
        {"truncated motion", good, header + good_rows + "1,left,0,0,"},
        {"motion of junk", good, junk(3, 5000)},
        {"motion with nul bytes", good, header + std::string(1000, '\0')},
        {"motion with NaN", good, header + good_rows + "1,left,nan,0,0,1,0,0,0,1\n"},
        {"motion with an infinite time", good, header + good_rows + "inf,left,0,0,0,1,0,0,0,1\n"},
        {"motion in metres", good, "t_s,instrument,x_m,y_m,z_m,qw,qx,qy,qz,jaw\n" + good_rows},
        {"motion back in time", good, header + "1,left,0,0,0,1,0,0,0,1\n0,left,0,0,0,1,0,0,0,1\n"},
        {"motion without rotation", good, header + "0,left,0,0,0,0,0,0,0,1\n"},
        {"motion of another tool", good, header + "0,scissors,0,0,0,1,0,0,0,1\n"},
        {"motion with open jaws", good, header + "0,left,0,0,0,1,0,0,0,90\n"},
        {"motion separated by semicolons", good, "t_s;instrument;x_mm;y_mm;z_mm;qw;qx;qy;qz;jaw\n"},
    };
}

std::vector<Broken> broken() {
    std::vector<Broken> all = broken_drills();
    for (Broken& one : broken_motions()) all.push_back(std::move(one));
    return all;
}

class Folder {
  public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "carrel-broken-XXXXXX").string();
        path_ = mkdtemp(name.data());
        write("other.obj", "v 0 0 0\n");
    }
    ~Folder() { fs::remove_all(path_); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return (path_ / name).string();
    }
    fs::path operator/(const std::string& name) const { return path_ / name; }

  private:
    fs::path path_;
};

void check_function(const std::string& file, const std::string& words = ": error: ") {
    try {
        const auto drill = scenarios::drill::load_drill(file);
        scenarios::drill::load_motion(drill.motion, std::vector<std::string>{"left", "right"});
        FAIL() << "was accepted";
    } catch (const scenarios::drill::FileError& error) {
        const std::string line = error.what();
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        EXPECT_NE(line.find(words), std::string::npos) << line;
        EXPECT_LT(line.size(), 1000u) << line;
    }
}

void check_program(const std::string& command, const std::string& file, const Folder& folder) {
    const fs::path messages = folder / "stderr";
    const int status = std::system(
        ("\"" CARREL_PROGRAM "\" " + command + " \"" + file + "\" >/dev/null 2>\"" + messages.string() + "\"").c_str());
    std::stringstream text;
    text << std::ifstream(messages).rdbuf();
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2) << status << "\n" << text.str();
    const std::string lines = text.str();
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 1) << lines;
    EXPECT_TRUE(lines.ends_with('\n')) << lines;
    EXPECT_NE(lines.find(": error: "), std::string::npos) << lines;
}

// As spreadsheets and some editors write it.
TEST(BrokenFiles, AByteOrderMarkBreaksNone) {
    const Folder folder;
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_NO_THROW(scenarios::drill::load_motion(folder.write("m.csv", mark + header + good_rows),
                                                  std::vector<std::string>{"left", "right"}));
    EXPECT_NO_THROW(scenarios::drill::load_waypoints(folder.write("w.waypoints", mark + "start left 0 0 0 jaw 1\n")));
}

}  // namespace

TEST(BrokenFiles, OneLineEachFromTheFunctions) {
    const Folder folder;
    for (const Broken& b : broken()) {
        SCOPED_TRACE(b.what);
        folder.write("m.csv", b.motion);
        check_function(folder.write("drill.json", b.drill));
    }
}

TEST(BrokenFiles, OneLineAndExitTwoFromTheProgram) {
    const Folder folder;
    for (const Broken& b : broken()) {
        SCOPED_TRACE(b.what);
        folder.write("m.csv", b.motion);
        const std::string file = folder.write("drill.json", b.drill);
        check_program("validate", file, folder);
        const bool in_drill = b.motion.empty() && b.what != "motion is the drill";  // explain reads no motion
        if (in_drill) check_program("explain", file, folder);
    }
}

// What is no file at all: opening a pipe would wait for ever, and a directory opens but does not read.
TEST(BrokenFiles, WhatIsNoFile) {
    const Folder folder;
    fs::create_directory(folder / "directory");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("nowhere", folder / "dangling");
    const std::pair<std::string, std::string> cases[] = {{"directory", "is a directory, expected a file"},
                                                         {"pipe", "is not a regular file"},
                                                         {"dangling", "no such file"},
                                                         {"missing", "no such file"}};
    for (const auto& [name, words] : cases) {
        SCOPED_TRACE(name);
        check_function((folder / name).string(), words);
        check_program("validate", (folder / name).string(), folder);
        check_program("explain", (folder / name).string(), folder);
    }
    check_program("validate", "/dev/zero", folder);
}

// The same good files pass, so the cases above fail for the reason they name.
TEST(BrokenFiles, TheWholeOnesPass) {
    const Folder folder;
    folder.write("m.csv", header + good_rows);
    const std::string file = folder.write("drill.json", moving("m.csv"));
    EXPECT_EQ(scenarios::drill::load_drill(file).motion, folder / "m.csv");
    for (const char* command : {"validate", "validate --json", "explain", "explain --json"})
        EXPECT_EQ(std::system(
                      ("\"" CARREL_PROGRAM "\" " + std::string(command) + " \"" + file + "\" >/dev/null 2>&1").c_str()),
                  0)
            << command;
}
