#include "app/rope/motion.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "app/fault.hpp"
#include "scenarios/drill/csv.hpp"
#include "scenarios/drill/file.hpp"
#include "scenarios/drill/schema.hpp"

namespace app::rope {

namespace {

using scenarios::drill::CsvReader;

constexpr std::size_t most_bytes = 256 << 20;  // two nodes at 1 kHz for half an hour take 150 MB
constexpr double longest_time = 7200;          // [s]
constexpr double largest_place = 10e3;         // [mm]
constexpr std::array<const char*, 5> columns = {"t_s", "node", "x_mm", "y_mm", "z_mm"};

int node_of(const CsvReader& row, int nodes) {
    const std::string_view cell = row.cell(1);
    if (cell == "first") return 0;
    if (cell == "last") return nodes - 1;
    int index = -1;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), index);
    if (error != std::errc() || end != cell.data() + cell.size() || index < 0 || index >= nodes)
        row.fail(
            1, "expected first, last or an index from 0 to " + std::to_string(nodes - 1) + ", found " + row.quoted(1));
    return index;
}

void add(std::map<int, HeldNode>& held, const CsvReader& row, int nodes) {
    const double t = row.number(0, 0, longest_time, " s");
    const int node = node_of(row, nodes);
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis)
        place[axis] = row.number(2 + static_cast<std::size_t>(axis), -largest_place, largest_place, " mm") / 1000;
    HeldNode& entry = held.try_emplace(node, HeldNode{node, {}}).first->second;
    if (!entry.keys.empty() && t <= entry.keys.back().t)
        row.fail(0, "expected a time after " + scenarios::drill::shown(entry.keys.back().t) +
                        " s, the row before of this node, found " + row.quoted(0));
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

std::vector<HeldNode> load_motion(const std::filesystem::path& file, int nodes) try {
    const std::string text = scenarios::drill::read_text(file, most_bytes);
    std::map<int, HeldNode> held;
    for (CsvReader row(text, file.string(), columns); row.next();) add(held, row, nodes);
    if (held.empty())
        scenarios::drill::fail(file.string(), "has no row below its header, expected at least one node to hold");
    std::vector<HeldNode> result;
    for (auto& [node, entry] : held) result.push_back(std::move(entry));
    return result;
} catch (const scenarios::drill::FileError& fault) {
    throw InputFault(fault.what());
}

}  // namespace app::rope
