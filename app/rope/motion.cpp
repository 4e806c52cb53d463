#include "app/rope/motion.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string_view>

#include "app/fault.hpp"
#include "scenarios/drill/file.hpp"

namespace app::rope {

namespace {

constexpr std::size_t most_bytes = 256 << 20;  // two nodes at 1 kHz for half an hour take 150 MB
constexpr double longest_time = 7200;          // [s]
constexpr double largest_place = 10e3;         // [mm]
constexpr const char* header = "t_s,node,x_mm,y_mm,z_mm";
constexpr std::array<const char*, 5> names = {"t_s", "node", "x_mm", "y_mm", "z_mm"};

[[noreturn]] void fail_at(const std::string& place, const std::string& what) {
    std::string line = place + ": error: " + what;
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';  // one line, whatever the file holds
    throw InputFault(line);
}

std::string shown(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

struct Row {
    const std::string& file;
    int line;
    std::array<std::string_view, names.size()> cells = {};
    std::array<std::size_t, names.size()> columns = {};  // of the first character, from 1

    [[noreturn]] void fail(std::size_t column, const std::string& wanted) const {
        fail_at(file + ":" + std::to_string(line) + ":" + std::to_string(columns[column]),
                std::string(names[column]) + ": expected " + wanted + ", found \"" +
                    std::string(cells[column].substr(0, 40)) + "\"");
    }

    double number(std::size_t column, double low, double high, const char* unit) const {
        const std::string_view cell = cells[column];
        double value = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        const bool whole = error == std::errc() && end == cell.data() + cell.size();
        if (!whole || !(value >= low && value <= high))  // the comparison is false for nan too
            fail(column, "a number from " + shown(low) + " to " + shown(high) + unit);
        return value;
    }

    int node(int nodes) const {
        if (cells[1] == "first") return 0;
        if (cells[1] == "last") return nodes - 1;
        int index = -1;
        const auto [end, error] = std::from_chars(cells[1].data(), cells[1].data() + cells[1].size(), index);
        if (error != std::errc() || end != cells[1].data() + cells[1].size() || index < 0 || index >= nodes)
            fail(1, "first, last or an index from 0 to " + std::to_string(nodes - 1));
        return index;
    }
};

Row split(const std::string& file, int line, std::string_view text) {
    Row row{file, line};
    std::size_t start = 0, count = 0;
    for (bool more = true; more; ++count) {
        const std::size_t comma = text.find(',', start), end = std::min(comma, text.size());
        const std::string_view cell = text.substr(start, end - start);
        const std::size_t blanks = std::min(cell.find_first_not_of(" \t"), cell.size());
        if (count < names.size()) {
            row.cells[count] = cell.substr(blanks, cell.find_last_not_of(" \t") + 1 - blanks);
            row.columns[count] = start + blanks + 1;
        }
        more = comma != std::string_view::npos;
        start = end + 1;
    }
    if (count != names.size())
        fail_at(file + ":" + std::to_string(line), "expected the " + std::to_string(names.size()) + " columns " +
                                                       header + ", found " + std::to_string(count));
    return row;
}

std::string text_of(const std::filesystem::path& file) try {
    return scenarios::drill::read_text(file, most_bytes);
} catch (const scenarios::drill::FileError& fault) {
    throw InputFault(fault.what());
}

void add(std::map<int, HeldNode>& held, const Row& row, int nodes) {
    const double t = row.number(0, 0, longest_time, " s");
    const int node = row.node(nodes);
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis)
        place[axis] = row.number(2 + static_cast<std::size_t>(axis), -largest_place, largest_place, " mm") / 1000;
    HeldNode& entry = held.try_emplace(node, HeldNode{node, {}}).first->second;
    if (!entry.keys.empty() && t <= entry.keys.back().t)
        row.fail(0, "a time after " + shown(entry.keys.back().t) + " s, the row before of this node");
    entry.keys.push_back({t, place});
}

}  // namespace

Vec3 HeldNode::place_at(double t) const {
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), t, [](double time, const Key& key) { return time < key.t; });
    if (after == keys.begin()) return keys.front().place;
    if (after == keys.end()) return keys.back().place;
    const Key &from = *(after - 1), &to = *after;
    return from.place + (t - from.t) / (to.t - from.t) * (to.place - from.place);
}

std::vector<HeldNode> load_motion(const std::filesystem::path& file, int nodes) {
    const std::string text = text_of(file), name = file.string();
    std::map<int, HeldNode> held;
    std::string_view rest = text;
    for (int line = 1; line == 1 || !rest.empty(); ++line) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view content = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (content.ends_with('\r')) content.remove_suffix(1);
        if (line == 1) {
            if (content != header) fail_at(name + ":1:1", std::string("expected the header ") + header);
        } else if (content.find_first_not_of(" \t") != std::string_view::npos && !content.starts_with('#')) {
            add(held, split(name, line, content), nodes);
        }
    }
    if (held.empty()) fail_at(name, "has no row below its header, expected at least one node to hold");
    std::vector<HeldNode> result;
    for (auto& [node, entry] : held) result.push_back(std::move(entry));
    return result;
}

}  // namespace app::rope
