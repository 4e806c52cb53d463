#include "scenarios/drill/waypoints.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "scenarios/drill/direction.hpp"
#include "scenarios/drill/file.hpp"
#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

namespace {

using sim::geometry::Quat;
using sim::geometry::Vec3;

constexpr double least_step_s = 0.15;  ///< No step is shorter: a hand needs this long to start and stop.
constexpr double radians = 3.14159265358979324 / 180;

struct Tool {
    std::string name;
    Vec3 place_mm = Vec3::Zero();
    Vec3 pointing = Vec3::UnitZ(), opening = Vec3::UnitX();
    double jaw = 1;
    std::vector<MotionKey> keys;
    int line = 0;  // that turned it before `start` placed it
};

// Where places and directions are seen from.
struct View {
    Vec3 origin_mm = Vec3::Zero();
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
    bool mirrored = false;
};

Quat turned(const Vec3& pointing, const Vec3& opening) {
    const Vec3 z = pointing.normalized(), x = (opening - opening.dot(z) * z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return Quat(axes);
}

class Reader {
  public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    void read(const std::string& text) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            std::istringstream words(line.substr(0, line.find('#')));
            std::vector<std::string> found{std::istream_iterator<std::string>(words), {}};
            if (!found.empty()) take({line_, std::move(found)});
        }
        if (!named_.empty()) complain("`steps " + named_ + "` has no `end`");
        for (const auto& [name, steps] : steps_)
            if (!steps.empty() && !played_.contains(name))
                complain_at(steps.front().number,
                            "`steps " + name + "` are never played, expected `play " + name + "` after them");
        if (tools_.empty()) complain("no `start` line, expected one that places every tool");
    }

    Waypoints result() const {
        std::vector<std::string> names;
        std::vector<std::vector<MotionKey>> keys;
        for (const Tool& tool : tools_) {
            names.push_back(tool.name);
            keys.push_back(tool.keys);
        }
        return {names, Motion(keys)};
    }

  private:
    struct Line {
        int number;
        std::vector<std::string> words;
    };

    // Between `steps` and `end` lines are kept, for `play`.
    void take(const Line& line) {
        if (named_.empty() || line.words.front() == "end") return run(line);
        if (line.words.front() == "steps") complain("`steps` within `steps " + named_ + "`, expected `end` first");
        steps_[named_].push_back(line);
    }

    void run(const Line& line) {
        constexpr int most = 100000;  // more than a file has room for
        line_ = line.number, words_ = line.words, next_ = 0;
        if (++run_ > most) complain("the " + std::to_string(most) + "th step with all that is played, expected fewer");
        step();
    }

    void name_steps() {
        named_ = word("a name");
        if (!steps_.try_emplace(named_).second) complain("`steps " + named_ + "` a second time, expected another name");
    }

    void end_steps() {
        if (named_.empty()) complain("`end` of nothing, expected `steps` before it");
        named_.clear();
    }

    // As if they stood here, their frames seen from the one here.
    void play() {
        const std::string name = word("a name");
        const auto known = steps_.find(name);
        if (known == steps_.end())
            complain("no steps are called \"" + name + "\", expected `steps " + name + "` before");
        if (more()) return;
        played_.insert(name);
        const View before = view_, outside = from_;
        const int line = line_;
        from_ = view_;
        for (const Line& one : known->second) {
            if (one.words.front() == "play") complain_at(one.number, "`play` within steps, expected no such line");
            run(one);
        }
        line_ = line, words_.clear(), next_ = 0;
        view_ = before, from_ = outside;
    }

    [[noreturn]] void complain_at(int line, const std::string& what) const {
        fail(file_ + ":" + std::to_string(line), what);
    }
    [[noreturn]] void complain(const std::string& what) const { complain_at(line_, what); }

    bool more() const { return next_ < words_.size(); }

    std::string word(const char* expected) {
        if (!more()) complain(std::string("expected ") + expected + " at the end of the line");
        return words_[next_++];
    }

    void expect(const char* keyword) {
        const std::string quoted = "\"" + std::string(keyword) + "\"", found = word(quoted.c_str());
        if (found != keyword) complain("expected " + quoted + ", found \"" + found + "\"");
    }

    double number(const char* what, double low, double high) {
        const std::string text = word(what);
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high))
            complain(std::string(what) + ": expected a number from " + shown(low) + " to " + shown(high) +
                     ", found \"" + text + "\"");
        return value;
    }

    static constexpr double far_mm = 1000;  // a tool a metre away is a mistake of units

    Vec3 vector(const char* what) {
        const double x = number(what, -far_mm, far_mm), y = number(what, -far_mm, far_mm);
        return {x, y, number(what, -far_mm, far_mm)};
    }

    Vec3 place() {
        const Vec3 p = vector("place in mm");
        return within_reach(view_.origin_mm + view_.frame * (view_.mirrored ? Vec3(p.x(), -p.y(), p.z()) : p));
    }

    // Of what a motion file takes.
    Vec3 within_reach(const Vec3& world_mm) const {
        if (world_mm.cwiseAbs().maxCoeff() > far_mm)
            complain("that is " + shown(std::round(world_mm.x())) + " " + shown(std::round(world_mm.y())) + " " +
                     shown(std::round(world_mm.z())) + " mm seen from outside all frames, expected -1000 to 1000 each");
        return world_mm;
    }

    // Where places and directions that follow are seen from.
    void frame() {
        const Vec3 origin = vector("origin in mm");
        Eigen::AngleAxisd by(0, Vec3::UnitX());
        if (more()) {
            expect("turned");
            by.angle() = number("degrees", -360, 360) * radians;
            expect("about");
            by.axis() = direction();
        }
        view_.origin_mm = from_.origin_mm + from_.frame * origin, view_.frame = from_.frame * by.toRotationMatrix();
    }

    Vec3 direction() {
        const Vec3 axis = vector("axis");
        if (!has_direction(axis)) complain("the axis has no direction, expected one component other than 0");
        return axis.normalized();
    }

    Tool& tool() { return tool_named(word("a tool's name")); }

    Tool& tool_named(const std::string& name) { return tool_named(name, line_); }

    Tool& tool_named(const std::string& name, int line) {
        for (Tool& known : tools_)
            if (known.name == name) return known;
        std::string names;
        for (const Tool& known : tools_) names += (names.empty() ? "" : ", ") + known.name;
        complain_at(line, "no tool is called \"" + name + "\", expected one of: " + names);
    }

    void step() {
        const std::string verb = word("a step");
        if (verb == "tool") {
            orient();
        } else if (verb == "start") {
            start();
        } else if (verb == "frame") {
            frame();
        } else if (verb == "mirror") {
            const std::string how = word("y or off");
            if (how != "y" && how != "off") complain("mirror: expected y or off, found \"" + how + "\"");
            view_.mirrored = how == "y";
        } else if (verb == "steps") {
            name_steps();
        } else if (verb == "end") {
            end_steps();
        } else if (verb == "play") {
            play();
        } else if (verb == "speed") {
            speed_mm_s_ = number("speed in mm/s", 0.1, 2000);
        } else if (tools_.empty()) {
            complain("\"" + verb + "\" before `start`, expected every tool to be placed first");
        } else if (verb == "go") {
            go();
        } else if (verb == "turn") {
            turn_about();
        } else if (verb == "jaw") {
            Tool& moved = tool();
            moved.jaw = number("jaw", 0, 1);
            expect("in");
            pass(number("seconds", 0.001, 60));
        } else if (verb == "wait") {
            pass(number("seconds", 0.001, 600));
        } else {
            complain("unknown step \"" + verb +
                     "\", expected tool, start, speed, go, turn, jaw, wait, frame, mirror, steps, end or play");
        }
        if (more()) complain("\"" + words_[next_] + "\" is one word too many");
    }

    void orient() {
        const std::string name = word("a tool's name");
        expect("pointing");
        const Vec3 pointing = view_.frame * vector("pointing");
        expect("opening");
        const Vec3 opening = view_.frame * vector("opening");
        if (pointing.cross(opening).norm() < 1e-3 * pointing.norm() * opening.norm() || !has_direction(pointing) ||
            !has_direction(opening))
            complain("pointing and opening of " + name + " must be two different directions");
        if (tools_.empty()) return turned_.push_back({name, Vec3::Zero(), pointing, opening, 1, {}, line_});
        Tool& known = tool_named(name);
        known.pointing = pointing, known.opening = opening;
    }

    void start() {
        if (!tools_.empty()) complain("a second `start`, expected one");
        while (more()) {
            Tool placed;
            placed.name = word("a tool's name");
            if (placed.name.find(',') != std::string::npos)
                complain("a tool cannot be called \"" + placed.name + "\": a comma ends a column of a motion file");
            for (const Tool& known : tools_)
                if (known.name == placed.name)
                    complain("\"" + placed.name + "\" is placed twice, expected different names");
            placed.place_mm = place();
            expect("jaw");
            placed.jaw = number("jaw", 0, 1);
            for (const Tool& known : turned_)
                if (known.name == placed.name) placed.pointing = known.pointing, placed.opening = known.opening;
            tools_.push_back(placed);
        }
        if (tools_.empty()) complain("`start` names no tool");
        for (const Tool& known : turned_) tool_named(known.name, known.line);
        key();
    }

    void go() {
        double longest = 0;
        std::vector<const Tool*> gone;
        if (!more()) complain("`go` moves nothing, expected a tool and its place");
        while (more()) {
            Tool& moved = tool();
            if (std::find(gone.begin(), gone.end(), &moved) != gone.end())
                complain("\"" + moved.name + "\" goes twice in one step, expected one place");
            gone.push_back(&moved);
            const Vec3 to = place();
            longest = std::max(longest, (to - moved.place_mm).norm());
            moved.place_mm = to;
        }
        pass(std::max(least_step_s, longest / speed_mm_s_));
    }

    // In pieces so short that places between them are off the arc by a thousandth of its radius.
    void turn_about() {
        constexpr double piece = 5;
        Tool& turned = tool();
        const double angle = number("degrees", -720, 720);
        expect("about");
        Vec3 axis = direction();
        if (view_.mirrored) axis = {-axis.x(), axis.y(), -axis.z()};  // and so the other way round
        axis = view_.frame * axis;
        expect("through");
        const Vec3 centre = place();
        expect("in");
        const double seconds = number("seconds", 0.001, 600);
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / piece)));
        const Eigen::AngleAxisd by(radians * angle / pieces, axis);
        for (int k = 0; k < pieces; ++k) {
            turned.place_mm = within_reach(centre + by * (turned.place_mm - centre));
            turned.pointing = by * turned.pointing;
            turned.opening = by * turned.opening;
            pass(seconds / pieces);
        }
    }

    void pass(double seconds) {
        time_s_ += seconds;
        key();
    }

    void key() {
        for (Tool& t : tools_) t.keys.push_back({time_s_, {{1e-3 * t.place_mm, turned(t.pointing, t.opening)}, t.jaw}});
    }

    std::string file_;
    int line_ = 0, run_ = 0;
    std::vector<std::string> words_;
    std::size_t next_ = 0;
    std::vector<Tool> tools_, turned_;
    double time_s_ = 0, speed_mm_s_ = 50;
    View view_, from_;  // of what comes next; that its frames are seen from
    std::map<std::string, std::vector<Line>> steps_;
    std::string named_;  // to be kept under
    std::set<std::string> played_;
};

}  // namespace

Waypoints parse_waypoints(const std::string& text, const std::string& name) {
    Reader reader(name);
    reader.read(text);
    return reader.result();
}

Waypoints load_waypoints(const std::filesystem::path& file) {
    constexpr std::size_t most_bytes = 1 << 20;  // ten thousand steps
    return parse_waypoints(without_mark(read_text(file, most_bytes)), file.string());
}

}  // namespace scenarios::drill
