#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/drill/csv.hpp"
#include "scenarios/drill/motion.hpp"
#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

namespace {

constexpr std::size_t most_bytes = 256 << 20;  ///< An hour of two tools at 100 Hz takes 60 MB.
constexpr double longest_s = 7200;
constexpr std::array<const char*, 10> columns = {"t_s", "instrument", "x_mm", "y_mm", "z_mm",
                                                 "qw",  "qx",         "qy",   "qz",   "jaw"};

instruments::ToolInput read_tool(const CsvReader& row) {
    instruments::ToolInput tool;
    for (int i = 0; i < 3; ++i)
        tool.pose.position[i] = row.number(2 + static_cast<std::size_t>(i), -1000, 1000, " mm") / 1000;
    const double w = row.number(5, -2, 2, ""), x = row.number(6, -2, 2, ""), y = row.number(7, -2, 2, ""),
                 z = row.number(8, -2, 2, "");
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    // Written with two digits a unit quaternion is off by a few per cent; by a factor of two it is something else.
    if (length < 0.5 || length > 2)
        row.fail(5, "qw,qx,qy,qz has length " + shown(length) + ", expected a unit quaternion");
    tool.pose.rotation = instruments::Quat(w / length, x / length, y / length, z / length);
    tool.jaw = row.number(9, 0, 1, "");
    return tool;
}

std::size_t instrument_of(const CsvReader& row, std::span<const std::string> instruments) {
    const auto found = std::find(instruments.begin(), instruments.end(), row.cell(1));
    if (found != instruments.end()) return static_cast<std::size_t>(found - instruments.begin());
    std::string known;
    for (const std::string& name : instruments) known += (known.empty() ? "\"" : ", \"") + name + "\"";
    row.fail(1, "the drill has no instrument " + row.quoted(1) + ", it has " + known);
}

}  // namespace

Motion parse_motion(const std::string& text, const std::string& name, std::span<const std::string> instruments) {
    std::vector<std::vector<MotionKey>> keys(instruments.size());
    for (CsvReader row(text, name, columns); row.next();) {
        const double t = row.number(0, 0, longest_s, " s");
        auto& list = keys[instrument_of(row, instruments)];
        if (!list.empty() && t <= list.back().t_s)
            row.fail(0, "expected a time after " + shown(list.back().t_s) + " s, the row before of " + row.quoted(1) +
                            ", found " + row.quoted(0));
        list.push_back({t, read_tool(row)});
    }
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].empty())
            fail(name, "has no row of the instrument \"" + instruments[i] + "\", expected at least one");
    return Motion(std::move(keys));
}

Motion load_motion(const std::filesystem::path& file, std::span<const std::string> instruments) {
    return parse_motion(read_text(file, most_bytes), file.string(), instruments);
}

std::string motion_text(const Motion& motion, std::span<const std::string> instruments) {
    struct Line {
        double t_s;
        std::size_t instrument;
        const instruments::ToolInput* input;
    };
    std::vector<Line> lines;
    for (std::size_t i = 0; i < motion.keys().size(); ++i)
        for (const MotionKey& key : motion.keys()[i]) lines.push_back({key.t_s, i, &key.input});
    std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.t_s < b.t_s; });
    std::string text;
    for (const char* column : columns) text += (text.empty() ? "" : ",") + std::string(column);
    text += "\n";
    for (const Line& line : lines) {
        const auto& [pose, jaw] = *line.input;
        text += shown(line.t_s) + "," + instruments[line.instrument];
        for (int i = 0; i < 3; ++i) text += "," + shown(pose.position[i] * 1000);
        for (const double q : {pose.rotation.w(), pose.rotation.x(), pose.rotation.y(), pose.rotation.z(), jaw})
            text += "," + shown(q);
        text += "\n";
    }
    return text;
}

}  // namespace scenarios::drill
