#include <pty.h>

#include <nlohmann/json.hpp>

#include "tests/app/commands/still.hpp"
#include "tests/program.hpp"

namespace {

/// The other end of a terminal: what the program shows a person while it works.
class Terminal {
  public:
    Terminal() {
        if (openpty(&master_, &slave_, nullptr, nullptr, nullptr) != 0) throw std::runtime_error("no terminal");
        fcntl(master_, F_SETFL, O_NONBLOCK);
    }
    ~Terminal() {
        close(master_);
        close(slave_);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    std::string name() const { return ptsname(master_); }

    /// Simulated seconds that the progress bar has come to; negative before the first.
    double progress_s() {
        char bytes[4096];
        for (ssize_t n; (n = ::read(master_, bytes, sizeof bytes)) > 0;)
            shown_.append(bytes, static_cast<std::size_t>(n));
        const std::size_t end = shown_.rfind(" of "), begin = shown_.rfind("] ", end);
        return end == std::string::npos ? -1 : std::stod(shown_.substr(begin + 2));
    }

  private:
    int master_ = -1, slave_ = -1;
    std::string shown_;
};

/// A session of ten minutes, more than the square drill allows: no machine is through with it before it is killed.
std::string long_drill(const program::Folder& folder) {
    folder.write("still.csv", still::motion("599"));
    const std::string drill = program::replaced(program::read(still::drill), "square-knot.csv", "still.csv");
    return folder.write("still.json", program::replaced(drill, "\"time_limit_s\": 120", "\"time_limit_s\": 600"));
}

/// Starts it, kills it that long after it began to move, and tells how far it had come at least.
double play_and_kill(const std::string& drill, const std::string& recording, std::chrono::milliseconds moment) {
    Terminal terminal;
    const pid_t child = program::start({"run", drill, "--record", recording}, "/dev/null", terminal.name());
    while (terminal.progress_s() < 0 && waitpid(child, nullptr, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(moment);
    const double reached_s = terminal.progress_s();
    int status = 0;
    EXPECT_EQ(kill(child, SIGKILL), 0);
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it ended before it was killed";
    return reached_s;
}

}  // namespace

// A power cut in the middle of a resident's drill: what is on disk must open, be the true beginning of the session, and
// lack no more than its last second. The program's own progress bar says how far it had come.
TEST(KilledProgram, EveryRecordingReplaysAndLacksAtMostOneSecond) {
    const program::Folder folder;
    const std::string drill = long_drill(folder);
    int longer_than_a_second = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::chrono::milliseconds moment(std::mt19937(seed)() % 800);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", killed after " + std::to_string(moment.count()) + " ms");
        const std::string recording = folder.path("killed-" + std::to_string(seed));
        const double reached_s = play_and_kill(drill, recording, moment);
        ASSERT_GE(reached_s, 0);
        longer_than_a_second += reached_s > 1;
        const auto replayed = program::run({"replay", "--verify", "--json", recording});
        if (replayed.exit == 2 && reached_s < 1) {  // killed before anything was due on disk
            EXPECT_EQ(replayed.said, recording + ": error: no tick was recorded\n");
            continue;
        }
        ASSERT_EQ(replayed.exit, 0) << replayed.said;
        const auto result = nlohmann::json::parse(replayed.out);
        EXPECT_GE(result.at("duration_s").get<double>(), reached_s - 1);
        EXPECT_FALSE(result.at("finished").get<bool>() || result.at("passed").get<bool>());
    }
    EXPECT_GT(longer_than_a_second, 0) << "every session was killed too early to lose anything";
}
