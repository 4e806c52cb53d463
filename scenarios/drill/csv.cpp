#include "scenarios/drill/csv.hpp"

#include <algorithm>
#include <charconv>

#include "scenarios/drill/file.hpp"
#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

CsvReader::CsvReader(std::string_view text, std::string name, std::span<const char* const> columns)
    : rest_(text), name_(std::move(name)), columns_(columns) {
    if (constexpr std::string_view mark = "\xEF\xBB\xBF"; rest_.starts_with(mark)) rest_.remove_prefix(mark.size());
    const std::string_view line = take_line();
    split(line);
    width_ = cells_.size();
    const auto is_named = [](const char* column, const Cell& cell) { return cell.text == column; };
    if (width_ >= columns.size() && std::equal(columns.begin(), columns.end(), cells_.begin(), is_named)) return;
    std::string header;
    for (const char* column : columns) header += (header.empty() ? "" : ",") + std::string(column);
    fail_line("expected the header " + header + ", found \"" + std::string(line.substr(0, 60)) + "\"");
}

bool CsvReader::next() {
    while (!rest_.empty()) {
        const std::string_view line = take_line();
        if (line.find_first_not_of(" \t") == std::string_view::npos || line.starts_with('#')) continue;
        split(line);
        if (cells_.size() != width_)
            fail_line("expected " + std::to_string(width_) + " columns" +
                      (width_ > columns_.size() ? " as in the header" : "") + ", found " +
                      std::to_string(cells_.size()));
        return true;
    }
    return false;
}

std::string CsvReader::quoted(std::size_t column) const {
    return "\"" + std::string(cell(column).substr(0, 40)) + "\"";
}

double CsvReader::number(std::size_t column, double low, double high, const char* unit) const {
    const std::string_view text = cell(column);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        fail(column, "expected a number, found " + quoted(column));
    if (!(value >= low && value <= high))  // also false for nan
        fail(column, "expected " + shown(low) + " to " + shown(high) + unit + ", found " + quoted(column));
    return value;
}

void CsvReader::fail(std::size_t column, const std::string& what) const {
    drill::fail(name_ + ":" + std::to_string(line_) + ":" + std::to_string(cells_[column].start),
                std::string(columns_[column]) + ": " + what);
}

void CsvReader::fail_line(const std::string& what) const {
    drill::fail(name_ + ":" + std::to_string(line_), what);
}

std::string_view CsvReader::take_line() {
    ++line_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

void CsvReader::split(std::string_view line) {
    cells_.clear();
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t first = std::min(line.find_first_not_of(" \t", at), line.size());
        std::size_t end = line.find(',', first);
        std::string_view text;
        if (first < line.size() && line[first] == '"') {
            const std::size_t quote = line.find('"', first + 1);
            if (quote == std::string_view::npos) fail_line("expected a closing '\"' after the one in this line");
            text = line.substr(first + 1, quote - first - 1);
            end = line.find_first_not_of(" \t", quote + 1);
            if (end < line.size() && line[end] != ',') fail_line("expected ',' behind a cell in quotes");
        } else {
            text = line.substr(first, std::min(end, line.size()) - first);
            text = text.substr(0, text.find_last_not_of(" \t") + 1);
        }
        cells_.push_back({text, first + 1});
        at = std::min(end, line.size()) + 1;
    }
}

}  // namespace scenarios::drill
