#include "tests/bench/suites/print.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "tests/bench/lab/words.hpp"

namespace bench::suites {

using namespace lab;

namespace {

constexpr std::size_t columns = 7;
using Line = std::array<std::string, columns>;

std::string bound_of(const Row& row) {
    if (!row.bound) return "";
    return (row.must == Must::be_at_most ? "<= " : ">= ") + figure(*row.bound);
}

Line line_of(const Row& row) {
    const std::string verdict = !row.bound ? "" : row.pass() ? "pass" : "MISSED";
    const std::string error = row.error ? "+-" + figure(*row.error) : "";
    return {row.id, row.what, figure(row.value) + " " + row.unit, bound_of(row), verdict, error, figure(row.seconds)};
}

void print(std::ostream& out, const Line& line, const std::array<std::size_t, columns>& widths) {
    std::string text;
    for (std::size_t c = 0; c < columns; ++c) text += line[c] + std::string(widths[c] - line[c].size() + 2, ' ');
    out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
}

}  // namespace

void print_table(std::ostream& out, const Suite& suite, const Origin& origin) {
    std::vector<Line> lines{{"id", "what", "value", "bound", "", "error", "seconds"}};
    for (const Row& row : suite.rows) lines.push_back(line_of(row));
    std::array<std::size_t, columns> widths{};
    for (const Line& line : lines)
        for (std::size_t c = 0; c < columns; ++c) widths[c] = std::max(widths[c], line[c].size());
    out << "suite " << suite.name << ", on " << origin.machine << ", " << origin.build << '\n';
    for (const Line& line : lines) print(out, line, widths);
}

void print_json(std::ostream& out, const Suite& suite, const Origin& origin) {
    using Json = nlohmann::ordered_json;
    const auto or_null = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
    Json rows = Json::array();
    for (const Row& row : suite.rows)
        rows.push_back({{"id", row.id},
                        {"what", row.what},
                        {"value", row.value},
                        {"unit", row.unit},
                        {"bound", or_null(row.bound)},
                        {"pass", row.pass()},
                        {"error", or_null(row.error)},
                        {"seconds", row.seconds}});
    const Json answer = {{"suite", suite.name}, {"machine", origin.machine}, {"build", origin.build}, {"rows", rows}};
    out << answer.dump(2) << '\n';
}

std::string missed(const Suite& suite) {
    std::string ids;
    for (const Row& row : suite.rows)
        if (!row.pass()) ids += (ids.empty() ? "" : ", ") + row.id;
    return ids;
}

}  // namespace bench::suites
