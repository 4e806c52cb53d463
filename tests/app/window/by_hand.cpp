// Plays a drill at the window as a person does: reads what is seen of it, a line of --scene-dump a frame, and prints
// what she does with mouse and keys, each somewhat late. Who carries that to the X server is another's business.
//
//   window_by_hand MOTION SEED PACE   tie the square knot of this motion with the assists wrist, snap, pull-both
//   prints: move RIGHT DOWN | wheel NOTCHES | button 1 0 or 1 | key NAME 0 or 1 | goal NUMBER SECONDS | done
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/hands/plans.hpp"

namespace {

using namespace app::hands;
using Json = nlohmann::json;

Vec3 vec3_of(const Json& json) {
    return Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

Quat quat_of(const Json& json) {
    return Quat(json[0].get<double>(), json[1].get<double>(), json[2].get<double>(), json[3].get<double>());
}

Seen seen_in(const Json& scene) {
    Seen seen;
    seen.t_s = scene["t_s"], seen.tension_N = scene["tension_N"];
    for (const Json& tool : scene["tools"]) {
        seen.tools.push_back({{vec3_of(tool["at"]), quat_of(tool["turned"])}, tool["jaw"]});
        seen.strands.push_back(tool["held"].get<std::string>().find("thread") != std::string::npos);
    }
    for (const Json& node : scene["thread"]) seen.thread.push_back(vec3_of(node));
    seen.along = {0};
    for (std::size_t k = 1; k < seen.thread.size(); ++k)
        seen.along.push_back(seen.along.back() + (seen.thread[k] - seen.thread[k - 1]).norm());
    seen.sight = {vec3_of(scene["eye"]), quat_of(scene["turned"]), scene["pixels"]};
    return seen;
}

struct Print {
    void operator()(const Motion& motion) const { std::printf("move %.0f %.0f\n", motion.right, motion.down); }
    void operator()(const Wheel& wheel) const { std::printf("wheel %.0f\n", wheel.notches); }
    void operator()(const Click& click) const { std::printf("button 1 %d\n", click.down); }
    void operator()(const Press& press) const {
        const std::string keys = row_of(press.action).key;
        std::printf("key %s %d\n", keys.substr(0, keys.find(' ')).c_str(), press.down);
    }
    template <class Other>
    void operator()(const Other&) const {}
};

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Brings each event when it is to be, and up to 40 ms late.
class Fingers {
  public:
    Fingers(unsigned seed, double pace) : random_(seed), pace_(pace) {}
    void send(const std::vector<Event>& events, double seen_s) {
        const double late_s = std::uniform_real_distribution<double>(0, 0.04)(random_);
        for (const Event& event : events)
            queue_.emplace(now_s() + late_s + std::max(0.0, event.stamp_s - seen_s) / pace_, event);
    }
    void deliver(double until_s) {
        for (; !queue_.empty() && queue_.begin()->first <= until_s; queue_.erase(queue_.begin()))
            std::visit(Print(), queue_.begin()->second.what);
        std::fflush(stdout);
    }

  private:
    std::mt19937 random_;
    double pace_;
    std::multimap<double, Event> queue_;
};

// Reads what has come; the last whole line of it is what she sees.
class Eyes {
  public:
    // False: nothing more will come.
    bool look(int wait_ms) {
        pollfd ready{STDIN_FILENO, POLLIN, 0};
        if (poll(&ready, 1, wait_ms) <= 0) return true;
        char part[1 << 16];
        const auto count = read(STDIN_FILENO, part, sizeof part);
        if (count <= 0) return false;
        text_.append(part, static_cast<std::size_t>(count));
        const auto end = text_.rfind('\n');
        if (end == std::string::npos) return true;
        const auto before = end == 0 ? std::string::npos : text_.rfind('\n', end - 1);
        const auto begin = before == std::string::npos ? 0 : before + 1;
        line_ = text_.substr(begin, end - begin);
        text_.erase(0, end + 1);
        return true;
    }
    std::string take() { return std::exchange(line_, {}); }

  private:
    std::string text_, line_;
};

}  // namespace

int main(int count, char** words) {
    if (count != 4) return std::fprintf(stderr, "usage: window_by_hand MOTION SEED PACE\n"), 2;
    constexpr double patience_s = 5;
    const auto seed = static_cast<unsigned>(std::atoi(words[2]));
    const std::vector<std::string> instruments{"left", "right"};
    const auto motion = scenarios::drill::load_motion(words[1], instruments);
    Player player(square_knot(motion, true), 1, 0, {.keys_near = 2e-3, .looks_s = 0.16, .gain = 8}, seed);
    Fingers fingers(seed, std::atof(words[3]));
    Eyes eyes;
    double last_s = now_s();  // that she saw something
    while (!player.is_done() && eyes.look(2) && now_s() < last_s + patience_s) {
        fingers.deliver(now_s());
        const std::string line = eyes.take();
        if (line.empty()) continue;
        last_s = now_s();
        const Seen seen = seen_in(Json::parse(line));
        const std::size_t goal = player.goal();
        fingers.send(player.play(seen), seen.t_s);
        if (player.goal() != goal) std::printf("goal %zu %.3f\n", goal, seen.t_s);
    }
    fingers.deliver(now_s() + 1);
    std::printf("done\n");
}
