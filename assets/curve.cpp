#include "assets/curve.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

#include "assets/curve_lines.hpp"

namespace assets {

namespace {

constexpr double farthest_mm = 1e9;  // a thousand kilometres: a wrong unit or a broken number

[[noreturn]] void fail(const std::filesystem::path& file, int line, std::size_t column, const std::string& what) {
    std::string place = file.string();
    if (line > 0) place += ":" + std::to_string(line);
    if (column > 0) place += ":" + std::to_string(column);
    throw AssetError(place + ": error: " + what);
}

// What was found, fit to print: a broken file may hold anything.
std::string shown(std::string_view word) {
    std::string text = "'";
    for (const char c : word.substr(0, 20)) text += c > ' ' && c < 127 ? c : '?';
    return text + (word.size() > 20 ? "...'" : "'");
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::string_view between = " \t,\r";
    for (std::size_t from = line.find_first_not_of(between); from != std::string_view::npos && words.size() < 5;) {
        const std::size_t to = std::min(line.find_first_of(between, from), line.size());
        words.push_back(line.substr(from, to - from));
        from = line.find_first_not_of(between, to);
    }
    return words;
}

double number_in(std::string_view word, const std::filesystem::path& file, int line, std::size_t column) {
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || digits.empty() || error == std::errc::invalid_argument)
        fail(file, line, column, "expected a number, found " + shown(word) + "; a line is 'x y z' in mm");
    if (error != std::errc{} || !std::isfinite(value) || std::abs(value) > farthest_mm)
        fail(file, line, column, "expected a finite coordinate within 1e9 mm, found " + shown(word));
    return value;
}

Vec3 vertex_in(std::string_view line, const std::filesystem::path& file, int number) {
    const auto words = words_of(line);
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < std::min<std::size_t>(3, words.size()); ++i)
        x[i] = number_in(words[i], file, number, static_cast<std::size_t>(words[i].data() - line.data()) + 1);
    if (words.size() != 3)
        fail(file, number, 0,
             "expected three numbers 'x y z' in mm, found " +
                 (words.size() > 4 ? "more than four" : std::to_string(words.size())));
    return 1e-3 * Vec3(x[0], x[1], x[2]);
}

std::vector<CurveComponent> read_text(std::istream& in, const std::filesystem::path& file) {
    std::vector<CurveComponent> components;
    int number = 0, vertices = 0;
    bool new_component = true;
    // No line of three numbers is near this long; a file without line ends must not be read whole.
    constexpr std::streamsize longest_line = 4096;
    std::array<char, longest_line> buffer;
    while (in.getline(buffer.data(), longest_line) || in.gcount() > 0) {
        ++number;
        if (in.fail() && !in.eof())
            fail(file, number, 0, "a line of more than 4000 characters is not a vertex 'x y z'");
        std::string_view line(buffer.data(), static_cast<std::size_t>(in.gcount() - (in.eof() ? 0 : 1)));
        if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
        const std::size_t comment = line.find('#');
        const bool commented = comment != std::string_view::npos;
        line = line.substr(0, comment);
        if (words_of(line).empty()) {
            new_component = new_component || !commented;
            continue;
        }
        if (++vertices > most_curve_vertices)
            fail(file, number, 0,
                 "more than " + std::to_string(most_curve_vertices) + " vertices; resample the curve to fewer");
        if (new_component) components.emplace_back();
        new_component = false;
        components.back().vertices.push_back(vertex_in(line, file, number));
        components.back().lines.push_back(number);
    }
    return components;
}

bool in_one_place(const CurveComponent& component) {
    constexpr double least = 1e-12;  // [m], a hundredth of an atom; squares of what is far smaller vanish
    for (const Vec3& p : component.vertices)
        if ((p - component.vertices.front()).cwiseAbs().maxCoeff() > least) return false;
    return true;
}

}  // namespace

std::string Curve::place(int component, int vertex) const {
    const int line = components[static_cast<std::size_t>(component)].lines[static_cast<std::size_t>(vertex)];
    return file.string() + (line > 0 ? ":" + std::to_string(line) : ": vertex " + std::to_string(vertex + 1));
}

static Curve checked(Curve curve) {
    const std::filesystem::path& file = curve.file;
    if (curve.components.empty()) fail(file, 0, 0, "holds no vertices; expected one 'x y z' in mm a line");
    for (CurveComponent& component : curve.components) {
        if (component.vertices.size() < 2)
            fail(file, component.lines.front(), 0, "a component of one vertex; expected at least two");
        if (in_one_place(component))
            fail(file, component.lines.front(), 0, "all vertices of this component are in one place; expected a curve");
        while (component.vertices.front() == component.vertices.back()) {
            component.closed = true;
            component.vertices.pop_back();
            component.lines.pop_back();
        }
    }
    return curve;
}

Curve load_curve(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) fail(file, 0, 0, "no such file");
    if (!std::filesystem::is_regular_file(file, ignored))
        fail(file, 0, 0, "not a file; expected a curve of vertices 'x y z'");
    const auto ending = file.extension();
    if (ending == ".ply" || ending == ".obj") return checked({file, read_lines(file)});
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, 0, 0, "cannot be opened");
    return read_curve(in, file);
}

Curve read_curve(std::istream& in, const std::filesystem::path& name) {
    return checked({name, read_text(in, name)});
}

}  // namespace assets
