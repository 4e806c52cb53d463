#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::string drill = CARREL_SOURCE "/scenarios/drills/square-knot.json";

fs::path scratch() {
    static const fs::path dir = [] {
        const fs::path made = fs::temp_directory_path() / ("carrel-bad-input-" + std::to_string(getpid()));
        fs::remove_all(made);
        fs::create_directories(made / "directory");
        return made;
    }();
    return dir;
}

std::string junk() {
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>((i * 7919 + i / 13) & 0xff);
    return bytes;
}

struct Case {
    std::string command;   ///< FILE stands for the broken file.
    std::string content;   ///< What is in it; "<missing>" and "<directory>" as they say.
};

const std::string header = "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw\n";

std::vector<Case> cases() {
    std::vector<Case> all;
    // Whatever a command reads: nothing, nonsense, half of it, not there, not a file.
    for (const std::string& command : std::vector<std::string>{"run FILE", "validate FILE", "explain FILE", "replay FILE", "replay --verify FILE",
                                      "render FILE --out /dev/null", "knot FILE", "motion FILE --out /dev/null",
                                      "run " + drill + " --input FILE"})
        for (const std::string& content : std::vector<std::string>{std::string(), junk(), std::string("{\"carrel_drill\": 1, \"tit"),
                                          std::string("<missing>"), std::string("<directory>")})
            all.push_back({command, content});
    const std::string run = "run " + drill + " --input FILE";
    for (const std::string& row : std::vector<std::string>{"0,left,nan,0,0,1,0,0,0,0\n", "0,left,0,0,0,0,0,0,0,0\n", "0,left,0,0,0,1,0,0,0,7\n",
                                  "0,middle,0,0,0,1,0,0,0,0\n", "1,left,0,0,0,1,0,0,0,0\n0,left,0,0,0,1,0,0,0,0\n",
                                  "0,left,0,0,0,1,0,0\n", "0,left,1e300,0,0,1,0,0,0,0\n"})
        all.push_back({run, header + row});
    for (const std::string& text : std::vector<std::string>{"0 0 0\nnan 0 0\n", "0 0 0\n", "0 0\n1 1\n", "0 0 0\n1 0 0\n1 0 inf\n"})
        all.push_back({"knot FILE", text});
    for (const std::string& text : std::vector<std::string>{"go left 0 0 0\n", "start left 0 0 nan jaw 0\n", "start left 0 0 0 jaw 2\n", "hop left 1 2 3\n",
                                   "start left 0 0 0 jaw 0\njaw left 0 in -1\n", "start left 0 0 0 jaw 0\ngo right 0 0 0\n",
                                   "tool left pointing 0 0 0 opening 1 0 0\n"})
        all.push_back({"motion FILE --out /dev/null", text});
    return all;
}

std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

fs::path broken_file(const std::string& content, std::size_t number) {
    if (content == "<missing>") return scratch() / "missing.json";
    if (content == "<directory>") return scratch() / "directory";
    const fs::path file = scratch() / ("case-" + std::to_string(number) + ".json");
    std::ofstream(file, std::ios::binary) << content;
    return file;
}

// A crash, a hang, a silent default or a page of noise on bad input costs its author an afternoon.
TEST(BadInput, IsOneLineThatNamesTheFileAndExit2) {
    const auto all = cases();
    for (std::size_t i = 0; i < all.size(); ++i) {
        SCOPED_TRACE(all[i].command + "\n" + all[i].content.substr(0, 60));
        const fs::path file = broken_file(all[i].content, i), errors = scratch() / "stderr";
        std::string command = all[i].command;
        command.replace(command.find("FILE"), 4, file.string());
        const int status = std::system(("timeout 20 " CARREL_PROGRAM " " + command + " > /dev/null 2> " + errors.string()).c_str());
        const std::string said = read(errors);
        EXPECT_EQ(WEXITSTATUS(status), 2) << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_NE(said.find(file.filename().string()), std::string::npos) << said;
    }
}

// A mistyped option is bad input like any other: one line that says what to look up.
TEST(BadInput, AWrongCommandLineIsOneLineToo) {
    for (const char* line : {"", "nope", "run", "run --nope", "replay", "knot --around", "rope --links many", "render --size"}) {
        SCOPED_TRACE(line);
        const fs::path errors = scratch() / "stderr";
        const int status = std::system((std::string(CARREL_PROGRAM " ") + line + " > /dev/null 2> " + errors.string()).c_str());
        const std::string said = read(errors);
        EXPECT_EQ(WEXITSTATUS(status), 2) << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_NE(said.find("--help"), std::string::npos) << said;
    }
}

// A drill of a billion links must be refused, not tried.
TEST(BadInput, ImpossibleSizesAndUnitsAreRefused) {
    const std::string good = read(drill);
    const std::pair<std::string, std::string> swaps[] = {{"\"links\": 300", "\"links\": 1000000000"},
                                                         {"\"length_mm\"", "\"length_cm\""},
                                                         {"\"carrel_drill\": 1", "\"carrel_drill\": 9"},
                                                         {"\"kind\": \"forceps\"", "\"kind\": \"spoon\""},
                                                         {"\"diameter_mm\": 4", "\"diameter_mm\": -4"}};
    for (const auto& [from, to] : swaps) {
        SCOPED_TRACE(to);
        std::string text = good;
        ASSERT_NE(text.find(from), std::string::npos);
        text.replace(text.find(from), from.size(), to);
        const fs::path file = broken_file(text, 1000), errors = scratch() / "stderr";
        const int status = std::system((CARREL_PROGRAM " validate " + file.string() + " > /dev/null 2> " + errors.string()).c_str());
        EXPECT_EQ(WEXITSTATUS(status), 2);
        const std::string said = read(errors);
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_NE(said.find(": error: /"), std::string::npos) << "no JSON pointer: " << said;
    }
}

}  // namespace
