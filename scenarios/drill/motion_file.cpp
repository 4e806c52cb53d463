#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "scenarios/drill/motion.hpp"
#include "scenarios/drill/nearest.hpp"
#include "scenarios/drill/shape.hpp"

namespace scenarios::drill {

namespace {

constexpr std::size_t most_bytes = 256 << 20;  ///< An hour of two tools at 100 Hz takes 60 MB.
constexpr int columns = 10;
constexpr const char* header = "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw";
constexpr std::array<const char*, columns> names = {"t_s", "instrument", "x_mm", "y_mm", "z_mm",
                                                    "qw",  "qx",         "qy",   "qz",   "jaw"};

struct Row {
    const std::string& file;
    int line;
    std::array<std::string_view, columns> cells;
    std::array<int, columns> starts;  ///< Column of the first character, from 1.

    [[noreturn]] void fail(int column, const std::string& what) const {
        drill::fail(file + ":" + std::to_string(line) + ":" + std::to_string(starts[static_cast<std::size_t>(column)]),
                    std::string(names[static_cast<std::size_t>(column)]) + ": " + what);
    }

    std::string cell(int column) const {
        return "\"" + std::string(cells[static_cast<std::size_t>(column)].substr(0, 40)) + "\"";
    }

    double number(int column, double low, double high, const char* unit) const {
        const std::string_view text = cells[static_cast<std::size_t>(column)];
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size())
            fail(column, "expected a number, found " + cell(column));
        if (!(value >= low && value <= high))  // also false for nan
            fail(column, "expected " + shown(low) + " to " + shown(high) + unit + ", found " + cell(column));
        return value;
    }
};

Row split(const std::string& file, int line, std::string_view text) {
    Row row{file, line, {}, {}};
    std::size_t at = 0;
    for (std::size_t i = 0;; ++i) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        if (i < columns) {
            std::string_view cell = text.substr(at, comma - at);
            const auto first = std::min(cell.find_first_not_of(" \t"), cell.size());
            const auto last = cell.find_last_not_of(" \t");
            row.starts[i] = static_cast<int>(at + first) + 1;
            row.cells[i] = last == std::string_view::npos ? "" : cell.substr(first, last + 1 - first);
        }
        at = comma + 1;
        if (comma < text.size()) continue;
        if (i + 1 != columns)
            fail(file + ":" + std::to_string(line),
                 "expected " + std::to_string(columns) + " columns, found " + std::to_string(i + 1));
        return row;
    }
}

instruments::ToolInput read_tool(const Row& row) {
    instruments::ToolInput tool;
    for (int i = 0; i < 3; ++i) tool.pose.position[i] = row.number(2 + i, -1000, 1000, " mm") / 1000;
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

void check_header(const std::string& name, std::string_view line) {
    if (line == header) return;
    fail(name + ":1",
         std::string("expected the header ") + header + ", found \"" + std::string(line.substr(0, 60)) + "\"");
}

std::size_t instrument_of(const Row& row, std::span<const std::string> instruments) {
    const auto found = std::find(instruments.begin(), instruments.end(), row.cells[1]);
    if (found != instruments.end()) return static_cast<std::size_t>(found - instruments.begin());
    std::string known;
    for (const std::string& name : instruments) known += (known.empty() ? "\"" : ", \"") + name + "\"";
    row.fail(1, "the drill has no instrument " + row.cell(1) + ", it has " + known);
}

}  // namespace

Motion parse_motion(const std::string& text, const std::string& name, std::span<const std::string> instruments) {
    std::vector<std::vector<MotionKey>> keys(instruments.size());
    std::string_view rest = text;
    for (int line = 1; line == 1 || !rest.empty(); ++line) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view content = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (content.ends_with('\r')) content.remove_suffix(1);
        if (line == 1) {
            check_header(name, content);
            continue;
        }
        if (content.find_first_not_of(" \t") == std::string_view::npos || content.starts_with('#')) continue;
        const Row row = split(name, line, content);
        const double t = row.number(0, 0, 7200, " s");
        auto& list = keys[instrument_of(row, instruments)];
        if (!list.empty() && t <= list.back().t_s)
            row.fail(0, "expected a time after " + shown(list.back().t_s) + " s, the row before of " + row.cell(1) +
                            ", found " + row.cell(0));
        list.push_back({t, read_tool(row)});
    }
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].empty())
            fail(name, "has no row of the instrument \"" + instruments[i] + "\", expected at least one");
    return Motion(std::move(keys));
}

Motion load_motion(const std::filesystem::path& file, std::span<const std::string> instruments) {
    return parse_motion(without_mark(read_text(file, most_bytes)), file.string(), instruments);
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
    std::string text = std::string(header) + "\n";
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
